// SPDX-License-Identifier: Apache-2.0
use crate::fixture::*;
use std::thread;
use toothseg::*;

/// Where the compiler accepts this, it is so. That a context is not Sync is among the programs that must not compile.
#[test]
fn what_may_go_between_threads() {
    fn send<T: Send>() {}
    fn both<T: Send + Sync>() {}
    send::<Context>();
    send::<ContextOptions>();
    both::<Job>();
    both::<Canceller>();
    both::<Model>();
    both::<Features>();
    both::<Segmentation>();
    both::<Results>();
    both::<Session>();
    both::<Mesh>();
    both::<MeshInput>();
    both::<Error>();
}

#[test]
fn two_threads_read_one_model() {
    let (model, features) = arch();
    let (segmentation, tooth) = clicked();
    let expected = (model.positions().unwrap(), segmentation.labels().unwrap(), features.points().unwrap());
    thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                for _ in 0..20 {
                    assert_eq!(model.positions().unwrap(), expected.0);
                    assert_eq!(segmentation.labels().unwrap(), expected.1);
                    assert_eq!(features.points().unwrap(), expected.2);
                    assert!(segmentation.click_info(0).unwrap().neighbour_distance > 0.0);
                    assert!(model.nearest([0.0; 3]).unwrap().distance > 0.0);
                    // errors are each thread's own
                    fails(Status::NOT_FOUND, segmentation.tooth(tooth + 1000));
                }
            });
        }
    });
}

#[test]
fn two_threads_click_on_segmentations_of_their_own() {
    let (_, features) = arch();
    let labels = || {
        let mut s = Segmentation::new(&features).unwrap();
        s.segment_all(None).unwrap();
        s.labels().unwrap()
    };
    let (a, b) = thread::scope(|scope| {
        let (a, b) = (scope.spawn(labels), scope.spawn(labels));
        (a.join().unwrap(), b.join().unwrap())
    });
    assert_eq!(a, b);
}
