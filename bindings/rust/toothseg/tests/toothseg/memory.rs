// SPDX-License-Identifier: Apache-2.0
use crate::fixture::*;
use std::sync::atomic::{AtomicIsize, Ordering};
use std::sync::Arc;
use toothseg::*;

/// Counts what is out, and refuses once `left` are had.
#[derive(Clone, Default)]
struct Counter(Arc<Counts>);

#[derive(Default)]
struct Counts {
    blocks: AtomicIsize,
    bytes: AtomicIsize,
    granted: AtomicIsize,
    refuse_after: AtomicIsize,
}

impl MemoryHook for Counter {
    fn grant(&self, bytes: usize) -> bool {
        let limit = self.0.refuse_after.load(Ordering::SeqCst);
        if self.0.granted.fetch_add(1, Ordering::SeqCst) >= limit && limit > 0 {
            return false;
        }
        self.0.blocks.fetch_add(1, Ordering::SeqCst);
        self.0.bytes.fetch_add(bytes as isize, Ordering::SeqCst);
        true
    }
    fn release(&self, bytes: usize) {
        self.0.blocks.fetch_sub(1, Ordering::SeqCst);
        self.0.bytes.fetch_sub(bytes as isize, Ordering::SeqCst);
    }
}

impl Counter {
    fn context(&self) -> Context {
        Context::with(ContextOptions::default().threads(1).memory(self.clone())).unwrap()
    }
    fn live(&self) -> (isize, isize) {
        (self.0.blocks.load(Ordering::SeqCst), self.0.bytes.load(Ordering::SeqCst))
    }
    fn granted(&self) -> isize {
        self.0.granted.load(Ordering::SeqCst)
    }
    fn refuse_after(&self, more: isize) {
        let after = if more == 0 { 0 } else { self.granted() + more };
        self.0.refuse_after.store(after, Ordering::SeqCst);
    }
}

/// Some dozens of everything, given back in every order that five handles can be.
#[test]
fn nothing_is_lost() {
    let counter = Counter::default();
    let bytes = std::fs::read(file("small.ply")).unwrap();
    for round in 0..36 {
        let context = counter.context();
        let model = Model::read(&context, &bytes).unwrap();
        let features = if round % 6 == 0 { Features::detect(&model).unwrap() } else { Features::new(&model).unwrap() };
        if round % 6 != 0 {
            let mut by_hand = features.try_clone().unwrap();
            let position = model.positions().unwrap()[round];
            by_hand.add_point(position, None).unwrap();
            drop(Segmentation::new(&by_hand).unwrap());
            let mut job = Job::with_progress(&context, |_, _| false).unwrap();
            assert!(Segmentation::new_with(&by_hand, &Default::default(), Some(&mut job)).unwrap_err().is_cancelled());
            let canceller = job.canceller();
            drop((job, by_hand, canceller));
            assert!(counter.live().0 > 0);
            let mut handles: Vec<Box<dyn std::any::Any>> = vec![Box::new(context), Box::new(model), Box::new(features)];
            handles.rotate_left(round % 3);
            if round % 2 == 0 {
                handles.swap(0, 1);
            }
            handles.into_iter().for_each(drop);
        } else {
            let mut s = Segmentation::new(&features).unwrap();
            s.on_change(|_, _| ()).unwrap();
            s.segment_all(None).unwrap();
            let tooth = s.teeth().unwrap()[0];
            let mesh = Mesh::tooth(&s, tooth, &Default::default(), None).unwrap();
            let session = Session::read(&model, &s.write_session().unwrap(), None).unwrap();
            let mut handles: Vec<Box<dyn std::any::Any>> = vec![
                Box::new(context),
                Box::new(model),
                Box::new(features),
                Box::new(s),
                Box::new(mesh),
                Box::new(session.segmentation),
                Box::new(session.features),
            ];
            handles.rotate_left(round / 6);
            handles.into_iter().for_each(drop);
        }
        assert_eq!(counter.live(), (0, 0), "after round {round}");
        assert_eq!(Arc::strong_count(&counter.0), 1, "after round {round}");
    }
    assert!(counter.granted() > 1000);
}

#[test]
fn memory_runs_out_200() {
    let counter = Counter::default();
    let context = counter.context();
    let model = Model::load(&context, file("small.ply")).unwrap();
    let features = Features::detect(&model).unwrap();
    let mut s = Segmentation::new(&features).unwrap();
    let position = s.propose_clicks().unwrap()[0];
    let (teeth, labels, session) = (s.teeth().unwrap(), s.labels().unwrap(), s.write_session().unwrap());
    for more in [1, 3, 10] {
        counter.refuse_after(more);
        let error = fails(Status::OUT_OF_MEMORY, s.click(position, None));
        assert_eq!(error.kind(), ErrorKind::Surroundings);
        fails(Status::OUT_OF_MEMORY, Model::load(&context, file("small.ply")));
        fails(Status::OUT_OF_MEMORY, Segmentation::new(&features));
        counter.refuse_after(0);
        assert_eq!(
            (s.teeth().unwrap(), s.labels().unwrap(), s.write_session().unwrap()),
            (teeth.clone(), labels.clone(), session.clone())
        );
    }
    s.click(position, None).unwrap();
    assert_eq!(s.teeth().unwrap().len(), 2);
    let limit = SegmentOptions { memory_limit: 1, ..Default::default() };
    fails(Status::OUT_OF_MEMORY, Segmentation::new_with(&features, &limit, None));
    drop((s, features, model, context));
    assert_eq!(counter.live(), (0, 0));
}

#[test]
fn a_memory_hook_panics() {
    struct Panicking;
    impl MemoryHook for Panicking {
        fn grant(&self, _: usize) -> bool {
            panic!("no memory from me")
        }
        fn release(&self, _: usize) {}
    }
    let context = Context::with(ContextOptions::default().memory(Panicking)).unwrap();
    let payload = panics(|| Model::load(&context, file("small.ply")));
    assert_eq!(payload.downcast_ref::<&str>(), Some(&"no memory from me"));
}
