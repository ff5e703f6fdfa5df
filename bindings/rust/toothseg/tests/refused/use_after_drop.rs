// E0382
// SPDX-License-Identifier: Apache-2.0
//! A handle that was given back cannot be used.
fn main() -> toothseg::Result<()> {
    let context = toothseg::Context::new()?;
    drop(context);
    toothseg::Job::new(&context)?;
    Ok(())
}
