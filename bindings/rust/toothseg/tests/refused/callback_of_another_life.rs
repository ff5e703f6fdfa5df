// E0597
// SPDX-License-Identifier: Apache-2.0
//! A callback cannot outlive what it refers to.
fn main() -> toothseg::Result<()> {
    let context = toothseg::Context::new()?;
    let job;
    {
        let limit = 0.5;
        let below = &limit;
        job = toothseg::Job::with_progress(&context, move |fraction, _| fraction < *below)?;
    }
    job.cancel();
    Ok(())
}
