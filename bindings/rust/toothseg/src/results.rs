// SPDX-License-Identifier: Apache-2.0
use crate::data::*;
use crate::error::{Error, Result};
use crate::job::Job;
use crate::options::SaveOptions;
use crate::raw::{elements, info, path_text, structs, FromRaw, Handle};
use crate::values::{OutputFormat, Status};
use std::path::Path;
use std::ptr::null_mut;
use toothseg_sys as sys;

/// A loop of a tooth's cut.
#[derive(Clone, Debug, PartialEq)]
pub struct Cut {
    /// Its length and quality.
    pub info: CutInfo,
    /// Its points, seen from outside counter-clockwise around the tooth.
    pub points: Vec<EdgePoint>,
}

/// A piece of a contour.
#[derive(Clone, Debug, PartialEq)]
pub struct Polyline {
    /// Its points; a closed one repeats none.
    pub points: Vec<EdgePoint>,
    /// The last point is joined to the first.
    pub closed: bool,
}

/// What can be read of a [`Segmentation`](crate::Segmentation), which derefs to it. Threads may read at the same time.
#[derive(Debug)]
pub struct Results {
    handle: Handle<sys::ts_segmentation>,
}

impl Results {
    pub(crate) fn from_handle(handle: Handle<sys::ts_segmentation>) -> Self {
        Results { handle }
    }

    pub(crate) fn handle(&self) -> &Handle<sys::ts_segmentation> {
        &self.handle
    }

    fn info<Raw: Default, T: FromRaw<Raw>>(
        &self,
        get: impl FnOnce(*const sys::ts_segmentation, *mut Raw) -> sys::ts_status,
    ) -> Result<T> {
        info(self.handle.hooks(), |out| get(self.handle.pointer(), out)).map(T::from_raw)
    }

    fn elements<T: Copy>(
        &self,
        mut get: impl FnMut(*const sys::ts_segmentation, *mut T, u32, *mut u32) -> sys::ts_status,
    ) -> Result<Vec<T>> {
        elements(self.handle.hooks(), |out, capacity, count| get(self.handle.pointer(), out, capacity, count))
    }

    fn structs<Raw: Copy, T: FromRaw<Raw>>(
        &self,
        mut get: impl FnMut(*const sys::ts_segmentation, *mut Raw, u32, *mut u32) -> sys::ts_status,
    ) -> Result<Vec<T>> {
        structs(self.handle.hooks(), |out, capacity, count| get(self.handle.pointer(), out, capacity, count))
    }

    /// The fewest clicks that cover every group not yet separated.
    pub fn propose_clicks(&self) -> Result<Vec<[f64; 3]>> {
        self.elements(|s, out: *mut [f64; 3], capacity, count| unsafe {
            sys::ts_propose_clicks(s, out.cast(), capacity, count)
        })
    }

    /// Number of clicks so far.
    pub fn click_count(&self) -> Result<u32> {
        self.info(|s, out| unsafe { sys::ts_get_click_count(s, out) })
    }

    /// What a click did.
    pub fn click_info(&self, click: u32) -> Result<ClickInfo> {
        self.info(|s, out| unsafe { sys::ts_get_click(s, click, out) })
    }

    /// The field of a click, a value a model vertex: 0 on the target, 1 on the neighbour.
    pub fn field(&self, click: u32) -> Result<Vec<f64>> {
        self.elements(|s, out, capacity, count| unsafe { sys::ts_get_field(s, click, out, capacity, count) })
    }

    /// The histogram of a click's field: vertices a bin.
    pub fn histogram(&self, click: u32) -> Result<Vec<u32>> {
        self.elements(|s, out, capacity, count| unsafe { sys::ts_get_histogram(s, click, out, capacity, count) })
    }

    /// The contours of a click's field.
    pub fn contours(&self, click: u32) -> Result<Vec<ContourInfo>> {
        self.structs(|s, out, capacity, count| unsafe { sys::ts_get_contours(s, click, out, capacity, count) })
    }

    /// The polylines of one contour.
    pub fn contour(&self, click: u32, contour: u32) -> Result<Vec<Polyline>> {
        let infos = self.contours(click)?;
        let info = infos
            .get(contour as usize)
            .ok_or_else(|| Error::new(Status::NOT_FOUND, format!("click {click} has no contour {contour}")))?;
        let mut starts = vec![0; info.polylines as usize];
        let mut closed = vec![0u8; info.polylines as usize];
        let all: Vec<sys::ts_edge_point> = self.elements(|s, out: *mut sys::ts_edge_point, capacity, count| {
            let (starts, closed) =
                if out.is_null() { (null_mut(), null_mut()) } else { (starts.as_mut_ptr(), closed.as_mut_ptr()) };
            unsafe { sys::ts_get_contour_points(s, click, contour, out, capacity, count, starts, closed) }
        })?;
        let ends = starts.iter().skip(1).map(|&start| start as usize).chain([all.len()]);
        Ok(starts
            .iter()
            .zip(ends)
            .zip(&closed)
            .map(|((&start, end), &closed)| Polyline {
                points: all[start as usize..end].iter().copied().map(EdgePoint::from_raw).collect(),
                closed: closed != 0,
            })
            .collect())
    }

    /// Ids of the teeth separated so far, along the arch.
    pub fn teeth(&self) -> Result<Vec<u32>> {
        self.elements(|s, out, capacity, count| unsafe { sys::ts_get_teeth(s, out, capacity, count) })
    }

    /// A separated tooth.
    pub fn tooth(&self, tooth: u32) -> Result<ToothInfo> {
        self.info(|s, out| unsafe { sys::ts_get_tooth(s, tooth, out) })
    }

    /// All separated teeth, along the arch.
    pub fn tooth_infos(&self) -> Result<impl Iterator<Item = Result<ToothInfo>> + '_> {
        Ok(self.teeth()?.into_iter().map(move |tooth| self.tooth(tooth)))
    }

    /// Model faces of a tooth.
    pub fn tooth_faces(&self, tooth: u32) -> Result<Vec<u32>> {
        self.elements(|s, out, capacity, count| unsafe { sys::ts_get_tooth_faces(s, tooth, out, capacity, count) })
    }

    /// Model vertices of these.
    pub fn tooth_vertices(&self, tooth: u32) -> Result<Vec<u32>> {
        self.elements(|s, out, capacity, count| unsafe { sys::ts_get_tooth_vertices(s, tooth, out, capacity, count) })
    }

    /// Model vertices held as a tooth's constraint.
    pub fn tooth_seeds(&self, tooth: u32) -> Result<Vec<u32>> {
        self.elements(|s, out, capacity, count| unsafe { sys::ts_get_tooth_seeds(s, tooth, out, capacity, count) })
    }

    /// A loop of a tooth's cut, 0 being the longest.
    pub fn cut(&self, tooth: u32, loop_index: u32) -> Result<Cut> {
        let mut info = sys::ts_cut_info::default();
        let points = self.structs(|s, out, capacity, count| unsafe {
            sys::ts_get_cut(s, tooth, loop_index, &mut info, out, capacity, count)
        })?;
        Ok(Cut { info: FromRaw::from_raw(info), points })
    }

    /// A label for each of the caller's faces, in the caller's order: 0 = no tooth, else [`ToothInfo::label`].
    pub fn labels(&self) -> Result<Vec<u32>> {
        self.elements(|s, out, capacity, count| unsafe { sys::ts_get_labels(s, out, capacity, count) })
    }

    /// Which way a tooth looks.
    pub fn tooth_frame(&self, tooth: u32) -> Result<ToothFrame> {
        self.info(|s, out| unsafe { sys::ts_get_tooth_frame(s, tooth, out) })
    }

    /// Whether a tooth is locked.
    pub fn is_locked(&self, tooth: u32) -> Result<bool> {
        self.info(|s, out: *mut u32| unsafe { sys::ts_tooth_get_locked(s, tooth, out) })
    }

    /// Teeth that want a look, those that need it most first.
    pub fn review(&self) -> Result<Vec<ReviewItem>> {
        self.structs(|s, out, capacity, count| unsafe { sys::ts_get_review(s, out, capacity, count) })
    }

    /// Faces that two teeth hold.
    pub fn overlaps(&self) -> Result<Vec<Overlap>> {
        self.structs(|s, out, capacity, count| unsafe { sys::ts_get_overlaps(s, out, capacity, count) })
    }

    /// The edits of a tooth's cut, in their order.
    pub fn cut_edits(&self, tooth: u32) -> Result<Vec<CutEdit>> {
        self.structs(|s, out, capacity, count| unsafe { sys::ts_get_cut_edits(s, tooth, out, capacity, count) })
    }

    /// The number of a tooth.
    pub fn number(&self, tooth: u32) -> Result<NumberInfo> {
        self.info(|s, out| unsafe { sys::ts_get_number(s, tooth, out) })
    }

    /// The jaw that the numbers are of.
    pub fn jaw(&self) -> Result<JawInfo> {
        self.info(|s, out| unsafe { sys::ts_get_jaw(s, out) })
    }

    /// What can be undone.
    pub fn history(&self) -> Result<HistoryInfo> {
        self.info(|s, out| unsafe { sys::ts_get_history(s, out) })
    }

    /// Ids of the teeth that the last step changed.
    pub fn changes(&self) -> Result<Vec<u32>> {
        self.elements(|s, out, capacity, count| unsafe { sys::ts_get_changes(s, out, capacity, count) })
    }

    /// How long the preparation took.
    pub fn prepare_times(&self) -> Result<PrepareTimes> {
        self.info(|s, out| unsafe { sys::ts_get_prepare_times(s, out) })
    }

    /// Bytes that are kept.
    pub fn memory(&self) -> Result<MemoryInfo> {
        self.info(|s, out| unsafe { sys::ts_get_memory(s, out) })
    }

    /// The session as JSON, for [`Session::read`](crate::Session::read).
    pub fn write_session(&self) -> Result<String> {
        let bytes: Vec<u8> = self.elements(|s, out: *mut u8, capacity, count| unsafe {
            sys::ts_session_write(s, out.cast(), capacity, count)
        })?;
        String::from_utf8(bytes).map_err(|error| Error::new(Status::INTERNAL, error.to_string()))
    }

    /// The session into a file, for [`Session::load`](crate::Session::load).
    pub fn save_session(&self, path: impl AsRef<Path>) -> Result<()> {
        let h = &self.handle;
        let path = path_text(path.as_ref())?;
        h.hooks().finish(unsafe { sys::ts_session_save(h.pointer(), path.as_ptr()) }, None)
    }

    /// Writes the whole scan with its teeth.
    pub fn save(&self, path: impl AsRef<Path>, format: OutputFormat) -> Result<()> {
        self.save_with(path, format, &SaveOptions::default(), None)
    }

    /// Writes the whole scan with its teeth, with options.
    pub fn save_with(
        &self,
        path: impl AsRef<Path>,
        format: OutputFormat,
        options: &SaveOptions,
        job: Option<&mut Job>,
    ) -> Result<()> {
        let h = &self.handle;
        let path = path_text(path.as_ref())?;
        let pointer = Job::pointer(&job);
        let status =
            unsafe { sys::ts_segmentation_save(h.pointer(), path.as_ptr(), format.code(), &options.raw(), pointer) };
        h.hooks().finish(status, job)
    }
}
