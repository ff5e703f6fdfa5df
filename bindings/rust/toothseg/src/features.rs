// SPDX-License-Identifier: Apache-2.0
use crate::data::{FeatureGroup, FeaturePoint, FeaturesInfo};
use crate::error::Result;
use crate::job::Job;
use crate::model::Model;
use crate::options::FeatureOptions;
use crate::raw::{elements, info, structs, FromRaw, Handle, IntoRaw};
use toothseg_sys as sys;

/// Where a feature point has been put.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Id of the point.
    pub point: u32,
    /// Id of its group.
    pub group: u32,
}

/// Feature points of the teeth in groups, one a tooth. A segmentation takes a copy.
#[derive(Debug)]
pub struct Features {
    handle: Handle<sys::ts_features>,
}

impl Features {
    /// An empty set, to be filled by hand.
    pub fn new(model: &Model) -> Result<Self> {
        let model = model.handle();
        let handle =
            Handle::make(model.hooks(), None, |_, out| unsafe { sys::ts_features_create(model.pointer(), out) })?;
        Ok(Features { handle })
    }

    /// Finds the features of a model.
    pub fn detect(model: &Model) -> Result<Self> {
        Self::detect_with(model, &FeatureOptions::default(), None)
    }

    /// Finds the features of a model, with options.
    pub fn detect_with(model: &Model, options: &FeatureOptions, job: Option<&mut Job>) -> Result<Self> {
        let model = model.handle();
        let handle = Handle::make(model.hooks(), job, |job, out| unsafe {
            sys::ts_detect_features(model.pointer(), &options.raw(), job, out)
        })?;
        Ok(Features { handle })
    }

    /// A copy; not `Clone`, as memory may be lacking.
    pub fn try_clone(&self) -> Result<Self> {
        let h = &self.handle;
        let handle = Handle::make(h.hooks(), None, |_, out| unsafe { sys::ts_features_clone(h.pointer(), out) })?;
        Ok(Features { handle })
    }

    /// Counts, and what the detection saw.
    pub fn info(&self) -> Result<FeaturesInfo> {
        let h = &self.handle;
        info(h.hooks(), |out| unsafe { sys::ts_features_get_info(h.pointer(), out) }).map(FromRaw::from_raw)
    }

    /// The unit vector from the gums to the biting surface.
    pub fn occlusal(&self) -> Result<[f64; 3]> {
        let h = &self.handle;
        info(h.hooks(), |out: *mut [f64; 3]| unsafe { sys::ts_features_get_occlusal(h.pointer(), out.cast()) })
    }

    /// Sets this direction.
    pub fn set_occlusal(&mut self, direction: [f64; 3]) -> Result<()> {
        self.change(|features| unsafe { sys::ts_features_set_occlusal(features, direction.as_ptr()) })
    }

    /// The arch curve as a polyline from one end of the arch to the other.
    pub fn arch(&self) -> Result<Vec<[f64; 3]>> {
        let h = &self.handle;
        elements(h.hooks(), |out: *mut [f64; 3], capacity, count| unsafe {
            sys::ts_features_get_arch(h.pointer(), out.cast(), capacity, count)
        })
    }

    /// All points, in the order of their groups.
    pub fn points(&self) -> Result<Vec<FeaturePoint>> {
        let h = &self.handle;
        structs(h.hooks(), |out, capacity, count| unsafe {
            sys::ts_features_get_points(h.pointer(), out, capacity, count)
        })
    }

    /// All groups, in the order of the arch.
    pub fn groups(&self) -> Result<Vec<FeatureGroup>> {
        let h = &self.handle;
        structs(h.hooks(), |out, capacity, count| unsafe {
            sys::ts_features_get_groups(h.pointer(), out, capacity, count)
        })
    }

    /// Adds a point at the surface point nearest to `position`, to a group or to a new one.
    pub fn add_point(&mut self, position: [f64; 3], group: Option<u32>) -> Result<Place> {
        let mut place = Place { point: 0, group: 0 };
        self.change(|features| unsafe {
            let group = group.into_raw();
            sys::ts_features_add_point(features, position.as_ptr(), group, &mut place.point, &mut place.group)
        })?;
        Ok(place)
    }

    /// Moves a point to the surface point nearest to `position`.
    pub fn move_point(&mut self, point: u32, position: [f64; 3]) -> Result<()> {
        self.change(|features| unsafe { sys::ts_features_move_point(features, point, position.as_ptr()) })
    }

    /// Puts a point into another group, or into a new one; the id of the group. A group without points ceases to exist.
    pub fn set_group(&mut self, point: u32, group: Option<u32>) -> Result<u32> {
        let mut now = 0;
        self.change(|features| unsafe { sys::ts_features_set_group(features, point, group.into_raw(), &mut now) })?;
        Ok(now)
    }

    /// Removes a point.
    pub fn remove_point(&mut self, point: u32) -> Result<()> {
        self.change(|features| unsafe { sys::ts_features_remove_point(features, point) })
    }

    /// Removes a group with its points.
    pub fn remove_group(&mut self, group: u32) -> Result<()> {
        self.change(|features| unsafe { sys::ts_features_remove_group(features, group) })
    }

    fn change(&mut self, call: impl FnOnce(*mut sys::ts_features) -> sys::ts_status) -> Result<()> {
        self.handle.hooks().finish(call(self.handle.pointer()), None)
    }

    pub(crate) fn handle(&self) -> &Handle<sys::ts_features> {
        &self.handle
    }

    pub(crate) fn from_handle(handle: Handle<sys::ts_features>) -> Self {
        Features { handle }
    }
}
