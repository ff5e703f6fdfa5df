// SPDX-License-Identifier: Apache-2.0
use crate::context::{Context, Payload};
use crate::error::Result;
use crate::raw::{Handle, Shared};
use std::ffi::CStr;
use std::os::raw::{c_char, c_int, c_void};
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::ptr::null_mut;
use std::sync::Arc;
use toothseg_sys as sys;

type Callback = Box<dyn FnMut(f64, &str) -> bool + Send>;

struct Progress {
    callback: Callback,
    panic: Option<Payload>,
}

/// Progress and cancellation of one long call at a time.
#[derive(Debug)]
pub struct Job {
    handle: Arc<Handle<sys::ts_job>>,
    // A handle that a canceller keeps may outlive it, but will not use it: no call can take the job any more.
    progress: Option<Shared<Progress>>,
}

impl Job {
    /// A job that serves to cancel only.
    pub fn new(context: &Context) -> Result<Self> {
        Self::make(context, None)
    }

    /// A job whose callback gets the share that is done, from 0 to 1, and the name of the stage, and says whether to go
    /// on. It is called from a thread that works for the call, one call at a time. A panic cancels too, and then goes on
    /// out of the call.
    pub fn with_progress(context: &Context, callback: impl FnMut(f64, &str) -> bool + Send + 'static) -> Result<Self> {
        Self::make(context, Some(Box::new(callback)))
    }

    fn make(context: &Context, callback: Option<Callback>) -> Result<Self> {
        let context = context.handle();
        let progress = callback.map(|callback| Shared::new(Progress { callback, panic: None }));
        let function: sys::ts_progress_fn = progress.as_ref().and(Some(on_progress));
        let user = progress.as_ref().map_or(null_mut(), |p| p.pointer().cast());
        let handle = Handle::make(context.hooks(), None, |_, out| unsafe {
            sys::ts_job_create(context.pointer(), function, user, out)
        })?;
        Ok(Job { handle: Arc::new(handle), progress })
    }

    /// What can cancel the job from any thread.
    pub fn canceller(&self) -> Canceller {
        Canceller { handle: Arc::clone(&self.handle) }
    }

    /// Cancels the next call that takes the job; see [`Job::reset`].
    pub fn cancel(&self) {
        unsafe { sys::ts_job_cancel(self.handle.pointer()) }
    }

    /// Makes a cancelled job usable again.
    pub fn reset(&mut self) {
        unsafe { sys::ts_job_reset(self.handle.pointer()) }
    }

    /// The last reported fraction, 0 before any.
    pub fn progress(&self) -> f64 {
        unsafe { sys::ts_job_progress(self.handle.pointer()) }
    }

    pub(crate) fn pointer(job: &Option<&mut Job>) -> *mut sys::ts_job {
        job.as_ref().map_or(null_mut(), |job| job.handle.pointer())
    }

    /// The panic of the callback during the call that has just come back.
    pub(crate) fn take_panic(&mut self) -> Option<Payload> {
        self.progress.as_ref().and_then(|progress| unsafe { (*progress.pointer()).panic.take() })
    }
}

unsafe extern "C" fn on_progress(fraction: f64, stage: *const c_char, user: *mut c_void) -> c_int {
    let progress = &mut *(user as *mut Progress);
    if progress.panic.is_some() {
        return 1;
    }
    let stage = CStr::from_ptr(stage).to_string_lossy();
    match catch_unwind(AssertUnwindSafe(|| (progress.callback)(fraction, &stage))) {
        Ok(goes_on) => (!goes_on).into(),
        Err(payload) => {
            progress.panic = Some(payload);
            1
        }
    }
}

/// Cancels a job from any thread, at any time; also when the job is gone already.
#[derive(Clone, Debug)]
pub struct Canceller {
    handle: Arc<Handle<sys::ts_job>>,
}

impl Canceller {
    /// Asks the running call to stop: it fails soon, with nothing changed. Sticky until [`Job::reset`].
    pub fn cancel(&self) {
        unsafe { sys::ts_job_cancel(self.handle.pointer()) }
    }

    /// The last reported fraction, 0 before any.
    pub fn progress(&self) -> f64 {
        unsafe { sys::ts_job_progress(self.handle.pointer()) }
    }
}
