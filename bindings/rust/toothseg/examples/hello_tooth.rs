// SPDX-License-Identifier: Apache-2.0
//! The shortest way to a tooth: hello_tooth SCAN prints the cut around the first one that the library proposes.

use toothseg::{Context, Features, Model, Segmentation};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scan = std::env::args().nth(1).ok_or("usage: hello_tooth SCAN")?;
    let context = Context::new()?;
    let model = Model::load(&context, scan)?;
    let features = Features::detect(&model)?;
    let mut segmentation = Segmentation::new(&features)?;

    let position = *segmentation.propose_clicks()?.first().ok_or("no tooth was found")?;
    let click = segmentation.click(position, None)?;
    let tooth = segmentation.click_info(click)?.target;
    for point in segmentation.cut(tooth, 0)?.points {
        let [x, y, z] = point.position;
        println!("{x:.4} {y:.4} {z:.4}");
    }
    Ok(())
}
