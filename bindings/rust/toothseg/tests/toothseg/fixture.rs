// SPDX-License-Identifier: Apache-2.0
use std::any::Any;
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};
use toothseg::{Context, ContextOptions, Error, Features, Model, Segmentation, Status};

/// A file in the folder that test.sh has made.
pub fn file(name: &str) -> PathBuf {
    let folder = std::env::var_os("TOOTHSEG_TEST_DIR").expect("TOOTHSEG_TEST_DIR: run test.sh");
    PathBuf::from(folder).join(name)
}

pub fn context() -> Context {
    Context::with(ContextOptions::default().threads(1)).unwrap()
}

static ARCH: Mutex<Option<(Arc<Model>, Arc<Features>)>> = Mutex::new(None);

/// The arch with its features, which all tests share.
pub fn arch() -> (Arc<Model>, Arc<Features>) {
    let mut arch = ARCH.lock().unwrap_or_else(PoisonError::into_inner);
    let (model, features) = arch.get_or_insert_with(|| {
        let model = Model::load(&context(), file("arch.ply")).unwrap();
        let features = Features::detect(&model).unwrap();
        (Arc::new(model), Arc::new(features))
    });
    (Arc::clone(model), Arc::clone(features))
}

pub fn model() -> Arc<Model> {
    arch().0
}

/// A segmentation of the arch without a click.
pub fn prepared() -> Segmentation {
    Segmentation::new(&arch().1).unwrap()
}

/// One with the click that is proposed first; and the tooth clicked.
pub fn clicked() -> (Segmentation, u32) {
    let mut segmentation = prepared();
    let position = segmentation.propose_clicks().unwrap()[0];
    let click = segmentation.click(position, None).unwrap();
    let tooth = segmentation.click_info(click).unwrap().target;
    (segmentation, tooth)
}

/// The call fails with this status, and the error says so in all ways.
#[track_caller]
pub fn fails<T>(status: Status, result: Result<T, Error>) -> Error {
    let error = result.err().unwrap_or_else(|| panic!("no error instead of {status:?}"));
    assert_eq!(error.status(), status, "{error}");
    assert_eq!(error.name(), format!("TS_E_{status:?}"));
    assert!(!error.message().is_empty() && !error.message().contains('\n'), "{error:?}");
    assert_eq!(error.to_string(), format!("{}: {}", error.name(), error.message()));
    error
}

/// What the call panics with.
#[track_caller]
pub fn panics<T>(call: impl FnOnce() -> T) -> Box<dyn Any + Send> {
    catch_unwind(AssertUnwindSafe(call)).err().expect("no panic")
}

pub fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}
