// SPDX-License-Identifier: Apache-2.0
use crate::fixture::*;
use toothseg::*;

/// Each step changes something, and undo and redo go back and forth over it byte for byte.
#[track_caller]
fn step(segmentation: &mut Segmentation, step: impl FnOnce(&mut Segmentation) -> Result<()>) {
    let before = segmentation.labels().unwrap();
    step(segmentation).unwrap();
    assert!(!segmentation.changes().unwrap().is_empty());
    let after = segmentation.labels().unwrap();
    segmentation.undo().unwrap();
    assert_eq!(segmentation.labels().unwrap(), before);
    segmentation.redo().unwrap();
    assert_eq!(segmentation.labels().unwrap(), after);
}

#[test]
fn corrections() {
    let mut s = prepared();
    step(&mut s, |s| s.segment_all(None));
    assert!(s.propose_clicks().unwrap().is_empty());
    let teeth = s.teeth().unwrap();
    let up = arch().1.occlusal().unwrap();
    let height = |p: [f64; 3]| p[0] * up[0] + p[1] * up[1] + p[2] * up[2];
    // A point half a millimetre below the lowest of the cut is to be the tooth's.
    let cut = s.cut(teeth[3], 0).unwrap();
    let lowest = cut.points.iter().map(|p| p.position).min_by(|a, b| height(*a).total_cmp(&height(*b))).unwrap();
    let below = [0, 1, 2].map(|k| lowest[k] - 0.5 * up[k]);
    step(&mut s, |s| s.include(teeth[3], below, None));
    step(&mut s, |s| s.exclude(teeth[3], below, None));

    let points: Vec<FeaturePoint> = arch().1.points().unwrap().into_iter().filter(|p| p.group == teeth[1]).collect();
    let (keep, part) = (points[0].position, points[points.len() - 1].position);
    let mut second = 0;
    step(&mut s, |s| {
        second = s.split(teeth[1], keep, part, None)?;
        Ok(())
    });
    assert!(s.teeth().unwrap().contains(&second) && !teeth.contains(&second));
    step(&mut s, |s| s.merge(teeth[1], second, None));
    assert!(!s.teeth().unwrap().contains(&second));
    let of_tooth: Vec<FeaturePoint> = arch().1.points().unwrap().into_iter().filter(|p| p.group == teeth[6]).collect();
    let seed = of_tooth[0].position;
    let positions = model().positions().unwrap();
    let vertices = s.tooth_vertices(teeth[6]).unwrap();
    let free = |p: &[f64; 3]| of_tooth.iter().all(|q| distance(*p, q.position) > 2.0);
    let to = vertices.iter().map(|&v| positions[v as usize]).find(free).unwrap();
    step(&mut s, |s| s.move_point(teeth[6], seed, to, None));
    step(&mut s, |s| s.remove(teeth[9]));
    assert!(!s.teeth().unwrap().contains(&teeth[9]));

    step(&mut s, |s| s.set_locked(teeth[0], true));
    assert_eq!(s.is_locked(teeth[0]), Ok(true));
    fails(Status::LOCKED, s.remove(teeth[0]));
    s.set_locked(teeth[0], false).unwrap();

    let history = s.history().unwrap();
    assert!(history.undo >= 9 && history.complete && history.bytes > 0);
    s.set_history_limit(0).unwrap();
    assert_eq!(s.history().unwrap().undo, 0);
}

#[test]
fn cuts() {
    let (mut s, tooth) = clicked();
    let click = s.cut(tooth, 0).unwrap();
    let up = arch().1.occlusal().unwrap();
    let n = click.points.len();
    // The lowest point lies on gingiva, where a drag has room.
    let height = |p: [f64; 3]| p[0] * up[0] + p[1] * up[1] + p[2] * up[2];
    let at = (0..n).min_by(|&a, &b| height(click.points[a].position).total_cmp(&height(click.points[b].position)));
    let at = at.unwrap();
    let to = [0, 1, 2].map(|k| click.points[at].position[k] - 0.6 * up[k]);
    let to = model().nearest(to).unwrap().position;
    s.drag_cut(tooth, 0, at as u32, to, 0.0, None).unwrap();
    assert_ne!(s.cut(tooth, 0).unwrap(), click);

    let cut = s.cut(tooth, 0).unwrap().points;
    let near = (0..cut.len()).min_by(|&a, &b| distance(cut[a].position, to).total_cmp(&distance(cut[b].position, to)));
    let near = near.unwrap() + cut.len();
    let ends = [cut[(near - 5) % cut.len()].position, cut[(near + 5) % cut.len()].position];
    let middle = [0, 1, 2].map(|k| to[k] - 0.8 * up[k]);
    s.draw_cut(tooth, &[ends[0], model().nearest(middle).unwrap().position, ends[1]], None).unwrap();
    s.offset_cut(tooth, 0.1, None).unwrap();
    s.smooth_cut(tooth, 0.5, None).unwrap();

    let edits = s.cut_edits(tooth).unwrap();
    let kinds: Vec<EditKind> = edits.iter().map(|e| e.kind).collect();
    assert_eq!(kinds, [EditKind::DRAG, EditKind::DRAW, EditKind::OFFSET, EditKind::SMOOTH]);
    assert!(edits.iter().all(|e| e.status.is_ok()));
    assert_eq!((edits[0].points, edits[1].points, edits[2].amount, edits[3].amount), (2, 3, 0.1, 0.5));
    assert!(distance(edits[0].to, to) < 1e-6);
    s.reset_cut(tooth).unwrap();
    assert_eq!(s.cut(tooth, 0).unwrap(), click);
    assert!(s.cut_edits(tooth).unwrap().is_empty());
}
