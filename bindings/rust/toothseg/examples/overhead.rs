// SPDX-License-Identifier: Apache-2.0
//! What the binding costs: overhead SCAN prints the time of a call that does next to nothing (ns) and of reading back the
//! labels of the scan (ms, median of 50).

use std::time::Instant;
use toothseg::{fdi_to_universal, Context, Features, Model, Segmentation};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scan = std::env::args().nth(1).ok_or("usage: overhead SCAN")?;
    const CALLS: u32 = 1_000_000;
    let start = Instant::now();
    let mut sum = 0;
    for i in 0..CALLS {
        sum += u64::from(fdi_to_universal(11 + i % 8)?);
    }
    let call_ns = start.elapsed().as_secs_f64() * 1e9 / f64::from(CALLS);
    assert_eq!(sum, u64::from(CALLS) / 8 * (1 + 2 + 3 + 4 + 5 + 6 + 7 + 8));

    let context = Context::new()?;
    let model = Model::load(&context, scan)?;
    let features = Features::detect(&model)?;
    let mut segmentation = Segmentation::new(&features)?;
    segmentation.segment_all(None)?;
    let faces = segmentation.labels()?.len();
    let mut times = Vec::new();
    for _ in 0..50 {
        let start = Instant::now();
        let labels = segmentation.labels()?;
        times.push(start.elapsed().as_secs_f64() * 1e3);
        assert_eq!(labels.len(), faces);
    }
    times.sort_by(f64::total_cmp);
    println!(r#"{{"language": "rust", "call_ns": {call_ns:.1}, "labels_ms": {:.3}, "faces": {faces}}}"#, times[25]);
    Ok(())
}
