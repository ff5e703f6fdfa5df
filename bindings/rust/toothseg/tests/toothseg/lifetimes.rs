// SPDX-License-Identifier: Apache-2.0
use crate::fixture::*;
use toothseg::*;

/// Children keep their parents alive.
#[test]
fn children_outlive_their_parents() {
    let context = context();
    let mut job = Job::new(&context).unwrap();
    let model = Model::load(&context, file("small.ply")).unwrap();
    drop(context);
    let features = Features::detect_with(&model, &Default::default(), Some(&mut job)).unwrap();
    drop(model);
    let mut segmentation = Segmentation::new(&features).unwrap();
    drop(features);
    segmentation.segment_all(Some(&mut job)).unwrap();
    drop(job);
    let tooth = segmentation.teeth().unwrap()[0];
    let mesh = Mesh::tooth(&segmentation, tooth, &Default::default(), None).unwrap();
    drop(segmentation);
    assert!(mesh.info().unwrap().area > 1.0);
}

/// A segmentation goes where it is moved to, and its callbacks with it.
#[test]
fn handles_can_be_moved() {
    let (mut s, tooth) = clicked();
    let (told, is_told) = std::sync::mpsc::channel();
    s.on_change(move |results, teeth| told.send((results.teeth().unwrap(), teeth.to_vec())).unwrap()).unwrap();
    let s = std::thread::spawn(move || {
        let mut boxed = Box::new(s);
        boxed.remove(tooth).unwrap();
        boxed
    })
    .join()
    .unwrap();
    let (left, changed) = is_told.recv().unwrap();
    assert_eq!((left, changed), (s.teeth().unwrap(), vec![tooth]));
}
