// E0499
// SPDX-License-Identifier: Apache-2.0
//! A job serves one call at a time.
pub fn two_at_once(model: &toothseg::Model, options: &toothseg::FeatureOptions, job: &mut toothseg::Job) {
    std::thread::scope(|scope| {
        scope.spawn(|| toothseg::Features::detect_with(model, options, Some(job)).is_ok());
        scope.spawn(|| toothseg::Features::detect_with(model, options, Some(job)).is_ok());
    });
}
fn main() {}
