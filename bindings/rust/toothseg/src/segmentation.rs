// SPDX-License-Identifier: Apache-2.0
use crate::context::{keep_first, Payload};
use crate::error::Result;
use crate::features::Features;
use crate::job::Job;
use crate::model::Model;
use crate::options::{NumberOptions, SegmentOptions};
use crate::raw::{count32, path_text, FromRaw, Handle, Shared};
use crate::results::Results;
use crate::values::Status;
use std::mem::replace;
use std::ops::Deref;
use std::os::raw::c_void;
use std::panic::{catch_unwind, resume_unwind, AssertUnwindSafe};
use std::path::Path;
use std::ptr::null_mut;
use std::slice;
use toothseg_sys as sys;

/// A prepared scan and the teeth separated so far; a session with undo. What it found is read through [`Results`].
#[derive(Debug)]
pub struct Segmentation {
    results: Results,
    listener: Option<Shared<Listener>>, // after the results: it outlives the handle, which knows its address
}

impl Deref for Segmentation {
    type Target = Results;
    fn deref(&self) -> &Results {
        &self.results
    }
}

type Callback = Box<dyn FnMut(&Results, &[u32]) + Send>;

struct Listener {
    callback: Callback,
    results: Results, // for the callback to read by
    panic: Option<Payload>,
}

unsafe extern "C" fn on_change(user: *mut c_void, teeth: *const u32, count: u32) {
    let listener = &mut *(user as *mut Listener);
    let teeth = if count == 0 { &[] } else { slice::from_raw_parts(teeth, count as usize) };
    if let Err(payload) = catch_unwind(AssertUnwindSafe(|| (listener.callback)(&listener.results, teeth))) {
        keep_first(&mut listener.panic, payload);
    }
}

impl Segmentation {
    /// Prepares a scan.
    pub fn new(features: &Features) -> Result<Self> {
        Self::new_with(features, &SegmentOptions::default(), None)
    }

    /// Prepares a scan, with options.
    pub fn new_with(features: &Features, options: &SegmentOptions, job: Option<&mut Job>) -> Result<Self> {
        let features = features.handle();
        let handle = Handle::make(features.hooks(), job, |job, out| unsafe {
            sys::ts_segmentation_create(features.pointer(), &options.raw(), job, out)
        })?;
        Ok(Self::from_handle(handle))
    }

    fn from_handle(handle: Handle<sys::ts_segmentation>) -> Self {
        Segmentation { results: Results::from_handle(handle), listener: None }
    }

    /// A call that may change something, with the panics of the callbacks it led to.
    fn change(
        &mut self,
        job: Option<&mut Job>,
        call: impl FnOnce(*mut sys::ts_segmentation, *mut sys::ts_job) -> sys::ts_status,
    ) -> Result<()> {
        let h = self.results.handle();
        let status = call(h.pointer(), Job::pointer(&job));
        let panic = self.listener.as_ref().and_then(|l| unsafe { (*l.pointer()).panic.take() });
        h.hooks().finish(status, job)?;
        match panic {
            Some(payload) => resume_unwind(payload),
            None => Ok(()),
        }
    }

    /// Separates the tooth under `position` and its neighbour; the number of the click.
    pub fn click(&mut self, position: [f64; 3], job: Option<&mut Job>) -> Result<u32> {
        let mut number = 0;
        self.change(job, |s, job| unsafe { sys::ts_segment_click(s, position.as_ptr(), job, &mut number) })?;
        Ok(number)
    }

    /// Several clicks at once; a status each. One that fails leaves no trace, the others stand.
    pub fn clicks(&mut self, positions: &[[f64; 3]], job: Option<&mut Job>) -> Result<Vec<Status>> {
        if positions.is_empty() {
            return Ok(Vec::new());
        }
        let count = count32(positions.len())?;
        let mut statuses = vec![sys::TS_OK; positions.len()];
        self.change(job, |s, job| unsafe {
            sys::ts_segment_clicks(s, positions.as_ptr().cast(), count, job, statuses.as_mut_ptr())
        })?;
        Ok(statuses.into_iter().map(Status::from_raw).collect())
    }

    /// Every tooth without a click of the caller's, as one step.
    pub fn segment_all(&mut self, job: Option<&mut Job>) -> Result<()> {
        self.change(job, |s, job| unsafe { sys::ts_segment_all(s, job) })
    }

    /// "This too": a disc around `position` is held for the tooth, which is cut anew.
    pub fn include(&mut self, tooth: u32, position: [f64; 3], job: Option<&mut Job>) -> Result<()> {
        self.change(job, |s, job| unsafe { sys::ts_tooth_include(s, tooth, position.as_ptr(), job) })
    }

    /// "Not this": the disc is held for what is beside the tooth.
    pub fn exclude(&mut self, tooth: u32, position: [f64; 3], job: Option<&mut Job>) -> Result<()> {
        self.change(job, |s, job| unsafe { sys::ts_tooth_exclude(s, tooth, position.as_ptr(), job) })
    }

    /// Two teeth of one; the id of the new one.
    pub fn split(&mut self, tooth: u32, keep: [f64; 3], part: [f64; 3], job: Option<&mut Job>) -> Result<u32> {
        let mut second = 0;
        self.change(job, |s, job| unsafe {
            sys::ts_tooth_split(s, tooth, keep.as_ptr(), part.as_ptr(), job, &mut second)
        })?;
        Ok(second)
    }

    /// Moves a feature point of the tooth.
    pub fn move_point(&mut self, tooth: u32, from: [f64; 3], to: [f64; 3], job: Option<&mut Job>) -> Result<()> {
        self.change(job, |s, job| unsafe { sys::ts_tooth_move_point(s, tooth, from.as_ptr(), to.as_ptr(), job) })
    }

    /// One tooth of two: `other` is no tooth any more.
    pub fn merge(&mut self, tooth: u32, other: u32, job: Option<&mut Job>) -> Result<()> {
        self.change(job, |s, job| unsafe { sys::ts_tooth_merge(s, tooth, other, job) })
    }

    /// The tooth is as if it had not been separated.
    pub fn remove(&mut self, tooth: u32) -> Result<()> {
        self.change(None, |s, _| unsafe { sys::ts_tooth_remove(s, tooth) })
    }

    /// Locked: nothing changes the tooth until it is unlocked.
    pub fn set_locked(&mut self, tooth: u32, locked: bool) -> Result<()> {
        self.change(None, |s, _| unsafe { sys::ts_tooth_set_locked(s, tooth, locked.into()) })
    }

    /// Takes a point of the cut to another place; `reach` is half the length of the stretch that follows, 0: as long as
    /// the drag.
    pub fn drag_cut(
        &mut self,
        tooth: u32,
        loop_index: u32,
        point: u32,
        to: [f64; 3],
        reach: f64,
        job: Option<&mut Job>,
    ) -> Result<()> {
        self.change(job, |s, job| unsafe { sys::ts_cut_drag(s, tooth, loop_index, point, to.as_ptr(), reach, job) })
    }

    /// Draws a stretch of the cut, at least 2 points.
    pub fn draw_cut(&mut self, tooth: u32, points: &[[f64; 3]], job: Option<&mut Job>) -> Result<()> {
        let count = count32(points.len())?;
        self.change(job, |s, job| unsafe { sys::ts_cut_draw(s, tooth, points.as_ptr().cast(), count, job) })
    }

    /// Moves the whole cut along the surface, outwards where positive.
    pub fn offset_cut(&mut self, tooth: u32, mm: f64, job: Option<&mut Job>) -> Result<()> {
        self.change(job, |s, job| unsafe { sys::ts_cut_offset(s, tooth, mm, job) })
    }

    /// Smooths the whole cut; `strength` over 0 to 2 mm.
    pub fn smooth_cut(&mut self, tooth: u32, strength: f64, job: Option<&mut Job>) -> Result<()> {
        self.change(job, |s, job| unsafe { sys::ts_cut_smooth(s, tooth, strength, job) })
    }

    /// Gives the tooth the cut of its click again.
    pub fn reset_cut(&mut self, tooth: u32) -> Result<()> {
        self.change(None, |s, _| unsafe { sys::ts_cut_reset(s, tooth) })
    }

    /// Takes back the last step.
    pub fn undo(&mut self) -> Result<()> {
        self.change(None, |s, _| unsafe { sys::ts_undo(s) })
    }

    /// Brings back what was undone.
    pub fn redo(&mut self) -> Result<()> {
        self.change(None, |s, _| unsafe { sys::ts_redo(s) })
    }

    /// How many bytes the steps may keep; the oldest are dropped over it.
    pub fn set_history_limit(&mut self, bytes: u64) -> Result<()> {
        self.change(None, |s, _| unsafe { sys::ts_set_history_limit(s, bytes) })
    }

    /// Gives the teeth their FDI numbers.
    pub fn assign_numbers(&mut self, options: &NumberOptions) -> Result<()> {
        self.change(None, |s, _| unsafe { sys::ts_assign_numbers(s, &options.raw()) })
    }

    /// Sets the number of a tooth by hand; none forgets one that was set.
    pub fn set_number(&mut self, tooth: u32, fdi: Option<u32>) -> Result<()> {
        self.change(None, |s, _| unsafe { sys::ts_set_number(s, tooth, fdi.unwrap_or(0)) })
    }

    /// `callback` is told, after each change, the ids of the teeth that it changed, on the thread of the call; it may read
    /// what is there now. Where it panics the change stands, and the panic goes on out of the call.
    pub fn on_change(&mut self, callback: impl FnMut(&Results, &[u32]) + Send + 'static) -> Result<()> {
        // A second handle, dropped before the first one, and used only within calls that have the segmentation as &mut.
        let results = Results::from_handle(unsafe { self.results.handle().view() });
        self.listen(Some(Listener { callback: Box::new(callback), results, panic: None }))
    }

    /// No change callback any more.
    pub fn clear_on_change(&mut self) -> Result<()> {
        self.listen(None)
    }

    fn listen(&mut self, listener: Option<Listener>) -> Result<()> {
        let listener = listener.map(Shared::new);
        let function: sys::ts_change_fn = listener.as_ref().and(Some(on_change));
        let user = listener.as_ref().map_or(null_mut(), |l| l.pointer().cast());
        let status = unsafe { sys::ts_set_change_callback(self.results.handle().pointer(), function, user) };
        // At once: the library has the address of the new one now, and has forgotten that of the old one.
        let _other = if status == sys::TS_OK { replace(&mut self.listener, listener) } else { listener };
        self.results.handle().hooks().finish(status, None)
    }
}

/// A session gone through again: the features as they were, and the segmentation, to go on with.
#[derive(Debug)]
pub struct Session {
    /// As they were.
    pub features: Features,
    /// To go on with.
    pub segmentation: Segmentation,
}

impl Session {
    /// From a file that [`Results::save_session`] wrote, on the model that it was of.
    pub fn load(model: &Model, path: impl AsRef<Path>, job: Option<&mut Job>) -> Result<Self> {
        let path = path_text(path.as_ref())?;
        Self::make(model, job, |model, job, features, out| unsafe {
            sys::ts_session_load(model, path.as_ptr(), job, features, out)
        })
    }

    /// From what [`Results::write_session`] gave.
    pub fn read(model: &Model, text: &str, job: Option<&mut Job>) -> Result<Self> {
        Self::make(model, job, |model, job, features, out| unsafe {
            sys::ts_session_read(model, text.as_ptr().cast(), text.len(), job, features, out)
        })
    }

    fn make(
        model: &Model,
        job: Option<&mut Job>,
        make: impl FnOnce(
            *const sys::ts_model,
            *mut sys::ts_job,
            *mut *mut sys::ts_features,
            *mut *mut sys::ts_segmentation,
        ) -> sys::ts_status,
    ) -> Result<Self> {
        let model = model.handle();
        let mut features = None;
        let segmentation = Handle::make(model.hooks(), job, |job, out| {
            let mut pointer = null_mut();
            let status = make(model.pointer(), job, &mut pointer, out);
            features = Handle::own(model.hooks(), pointer);
            status
        })?;
        let features = features.expect("a session has features");
        Ok(Session { features: Features::from_handle(features), segmentation: Segmentation::from_handle(segmentation) })
    }
}
