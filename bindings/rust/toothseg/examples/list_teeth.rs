// SPDX-License-Identifier: Apache-2.0
//! The program of docs/five-minutes-rust.md: lists the teeth of arch.ply in the current folder.

use toothseg::{Context, Features, Model, Segmentation};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let context = Context::new()?;
    let model = Model::load(&context, "arch.ply")?;
    let features = Features::detect(&model)?;
    let mut segmentation = Segmentation::new(&features)?;
    segmentation.segment_all(None)?;
    for tooth in segmentation.tooth_infos()? {
        let tooth = tooth?;
        println!("tooth {}: {:.0} mm^2, confidence {:.2}", tooth.label, tooth.area, tooth.confidence);
    }
    Ok(())
}
