// E0277
// SPDX-License-Identifier: Apache-2.0
//! Two threads cannot use one context at the same time.
fn main() -> toothseg::Result<()> {
    let context = toothseg::Context::new()?;
    std::thread::scope(|scope| {
        scope.spawn(|| toothseg::Job::new(&context).map(|_| ()));
    });
    Ok(())
}
