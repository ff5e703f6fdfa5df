// E0502
// SPDX-License-Identifier: Apache-2.0
//! What reads a segmentation is done with it before it changes.
pub fn read_and_change(segmentation: &mut toothseg::Segmentation) -> toothseg::Result<()> {
    let teeth = segmentation.tooth_infos()?;
    segmentation.undo()?;
    drop(teeth);
    Ok(())
}
fn main() {}
