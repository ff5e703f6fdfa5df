// SPDX-License-Identifier: Apache-2.0
use crate::fixture::*;
use std::sync::mpsc::channel;
use std::sync::{Arc, Mutex};
use std::thread;
use toothseg::*;

#[test]
fn progress_rises_to_the_end() {
    let seen = Arc::new(Mutex::new(Vec::new()));
    let in_callback = Arc::clone(&seen);
    let mut job = Job::with_progress(&context(), move |fraction, stage| {
        in_callback.lock().unwrap().push((fraction, stage.to_owned()));
        true
    })
    .unwrap();
    assert_eq!(job.progress(), 0.0);
    let mut s = Segmentation::new_with(&arch().1, &Default::default(), Some(&mut job)).unwrap();
    let seen = std::mem::take(&mut *seen.lock().unwrap());
    assert!(seen.len() > 2 && seen.iter().all(|(f, stage)| (0.0..=1.0).contains(f) && !stage.is_empty()));
    assert!(seen.windows(2).all(|pair| pair[0].0 <= pair[1].0));
    assert_eq!(job.progress(), seen.last().unwrap().0);
    s.segment_all(Some(&mut job)).unwrap(); // a job serves one call after another
}

#[test]
fn a_callback_cancels() {
    let mut job = Job::with_progress(&context(), |_, _| false).unwrap();
    let mut s = prepared();
    assert!(fails(Status::CANCELLED, s.segment_all(Some(&mut job))).is_cancelled());
    assert!(s.teeth().unwrap().is_empty());
    fails(Status::CANCELLED, Features::detect_with(&model(), &Default::default(), Some(&mut job)));
    let mut quiet = Job::new(&context()).unwrap();
    quiet.cancel();
    fails(Status::CANCELLED, s.segment_all(Some(&mut quiet))); // sticky ...
    quiet.reset();
    s.segment_all(Some(&mut quiet)).unwrap(); // ... until then
}

#[test]
fn a_progress_callback_panics() {
    let mut calls = 0;
    let mut job = Job::with_progress(&context(), move |_, _| {
        calls += 1;
        assert!(calls != 2, "the second call");
        true
    })
    .unwrap();
    let mut s = prepared();
    let payload = panics(|| s.segment_all(Some(&mut job)));
    assert_eq!(payload.downcast_ref::<&str>(), Some(&"the second call"));
    assert!(s.teeth().unwrap().is_empty());
    job.reset();
    s.segment_all(Some(&mut job)).unwrap();
    assert_eq!(s.teeth().unwrap().len(), 14);
}

#[test]
fn another_thread_cancels() {
    let (running, is_running) = channel();
    let (cancelled, is_cancelled) = channel();
    let mut job = Job::with_progress(&context(), move |_, _| {
        // waits, on the first call, until the other thread has cancelled
        if running.send(()).is_ok() {
            let _ = is_cancelled.recv();
        }
        true
    })
    .unwrap();
    let canceller = job.canceller();
    let other = thread::spawn(move || {
        is_running.recv().unwrap();
        canceller.clone().cancel();
        drop(is_running);
        cancelled.send(()).unwrap();
        canceller
    });
    let result = Segmentation::new_with(&arch().1, &Default::default(), Some(&mut job));
    let canceller = other.join().unwrap();
    assert!(fails(Status::CANCELLED, result).is_cancelled());
    drop(job);
    canceller.cancel(); // harms nobody
    assert!(canceller.progress() <= 1.0);
}

#[test]
fn changes_are_told() {
    let told = Arc::new(Mutex::new(Vec::new()));
    let in_callback = Arc::clone(&told);
    let (mut s, tooth) = clicked();
    s.on_change(move |results, teeth| {
        in_callback.lock().unwrap().push((teeth.to_vec(), results.changes().unwrap(), results.labels().unwrap()));
    })
    .unwrap();
    s.offset_cut(tooth, 0.3, None).unwrap();
    s.undo().unwrap();
    {
        let told = told.lock().unwrap();
        assert_eq!(told.len(), 2);
        assert_eq!((&told[0].0, &told[0].1), (&vec![tooth], &vec![tooth]));
        assert_eq!(told[1].2, s.labels().unwrap());
    }
    fails(Status::EDIT_NOTHING, s.offset_cut(tooth, 0.0, None));
    assert_eq!(told.lock().unwrap().len(), 2);

    // Another in its place, which panics: the change stands.
    s.on_change(|_, _| panic!("in the change callback")).unwrap();
    let before = s.labels().unwrap();
    let payload = panics(|| s.offset_cut(tooth, 0.3, None));
    assert_eq!(payload.downcast_ref::<&str>(), Some(&"in the change callback"));
    assert_ne!(s.labels().unwrap(), before);
    s.clear_on_change().unwrap();
    s.undo().unwrap();
    assert_eq!(s.labels().unwrap(), before);
    assert_eq!((told.lock().unwrap().len(), Arc::strong_count(&told)), (2, 1));
    s.on_change(|_, _| ()).unwrap(); // given back with the segmentation
}

#[test]
fn the_log_is_heard() {
    let lines = Arc::new(Mutex::new(Vec::new()));
    let in_hook = Arc::clone(&lines);
    let options = ContextOptions::default()
        .threads(1)
        .log(move |level, text| in_hook.lock().unwrap().push((level, text.to_owned())));
    let context = Context::with(options).unwrap();
    let model = Model::load(&context, file("arch.ply")).unwrap();
    drop(context); // the hook lives on with the model
    drop(Features::detect(&model).unwrap());
    let heard = lines.lock().unwrap().clone();
    assert!(heard.iter().any(|(level, text)| *level == LogLevel::INFO && text.starts_with("intake: ")), "{heard:?}");
    assert!(heard.iter().any(|(_, text)| text.starts_with("features: ")));
    drop(model);
    assert_eq!(Arc::strong_count(&lines), 1);
}

#[test]
fn a_log_hook_panics() {
    let context = Context::with(ContextOptions::default().log(|_, text| panic!("{}", text))).unwrap();
    let payload = panics(|| Model::load(&context, file("arch.ply")));
    assert!(payload.downcast_ref::<String>().unwrap().starts_with("intake: "));
    fails(Status::FILE_OPEN, Model::load(&context, file("not there"))); // and no more than once
}
