// SPDX-License-Identifier: Apache-2.0
//! What all calls of the C API have in common.

use crate::context::Hooks;
use crate::error::{Error, Result};
use crate::job::Job;
use crate::values::Status;
use std::ffi::{CStr, CString};
use std::fmt;
use std::os::raw::c_char;
use std::path::Path;
use std::ptr::{null_mut, NonNull};
use std::sync::Arc;
use toothseg_sys as sys;

/// A value of the C API as this crate has it.
pub(crate) trait FromRaw<Raw> {
    fn from_raw(raw: Raw) -> Self;
}

/// A value of this crate as the C API has it.
pub(crate) trait IntoRaw<Raw> {
    fn into_raw(self) -> Raw;
}

macro_rules! same {
    ($($type:ty),*) => {$(
        impl FromRaw<$type> for $type {
            fn from_raw(raw: $type) -> Self {
                raw
            }
        }
        impl IntoRaw<$type> for $type {
            fn into_raw(self) -> $type {
                self
            }
        }
    )*};
}
same!(u32, u64, f64, [f64; 3]);

impl FromRaw<u32> for bool {
    fn from_raw(raw: u32) -> Self {
        raw != 0
    }
}
impl IntoRaw<u32> for bool {
    fn into_raw(self) -> u32 {
        self.into()
    }
}
impl FromRaw<u32> for Option<u32> {
    fn from_raw(raw: u32) -> Self {
        (raw != sys::TS_NONE).then_some(raw)
    }
}
impl IntoRaw<u32> for Option<u32> {
    fn into_raw(self) -> u32 {
        self.unwrap_or(sys::TS_NONE)
    }
}
/// NaN: there is none.
impl FromRaw<f64> for Option<f64> {
    fn from_raw(raw: f64) -> Self {
        (!raw.is_nan()).then_some(raw)
    }
}
/// 0, 0, 0: no direction.
impl FromRaw<[f64; 3]> for Option<[f64; 3]> {
    fn from_raw(raw: [f64; 3]) -> Self {
        (raw != [0.0; 3]).then_some(raw)
    }
}
impl IntoRaw<[f64; 3]> for Option<[f64; 3]> {
    fn into_raw(self) -> [f64; 3] {
        self.unwrap_or([0.0; 3])
    }
}
impl<const N: usize> FromRaw<[c_char; N]> for String {
    fn from_raw(raw: [c_char; N]) -> Self {
        let bytes: Vec<u8> = raw.iter().take_while(|&&c| c != 0).map(|&c| c as u8).collect();
        String::from_utf8_lossy(&bytes).into_owned()
    }
}

/// Text that the library keeps for ever.
pub(crate) fn static_text(text: *const c_char) -> &'static str {
    unsafe { CStr::from_ptr(text) }.to_str().unwrap_or("?")
}

/// The error of a call that has just come back on this thread.
pub(crate) fn check(status: sys::ts_status) -> Result<()> {
    if status == sys::TS_OK {
        return Ok(());
    }
    let message = unsafe { CStr::from_ptr(sys::ts_last_error_message()) };
    Err(Error::new(Status::from_raw(status), message.to_string_lossy()))
}

pub(crate) fn usage(message: impl Into<String>) -> Error {
    Error::new(Status::INVALID_ARGUMENT, message)
}

pub(crate) fn count32(count: usize) -> Result<u32> {
    u32::try_from(count).map_err(|_| usage(format!("{count} elements are more than 2^32 - 1")))
}

pub(crate) fn path_text(path: &Path) -> Result<CString> {
    let text = path.to_str().ok_or_else(|| usage(format!("{path:?} is not UTF-8")))?;
    CString::new(text).map_err(|_| usage(format!("{path:?} has a zero in it")))
}

/// A struct that the call fills in; with `struct_size`, where it has one.
pub(crate) fn info<Raw: Default>(hooks: &Hooks, get: impl FnOnce(*mut Raw) -> sys::ts_status) -> Result<Raw> {
    let mut raw = Raw::default();
    hooks.finish(get(&mut raw), None)?;
    Ok(raw)
}

/// The two calls of a getter, for the number of elements and for these: get(buffer, capacity, count). Written by the
/// library straight into the vector. T: any bytes are a value of it.
pub(crate) fn elements<T: Copy>(
    hooks: &Hooks,
    mut get: impl FnMut(*mut T, u32, *mut u32) -> sys::ts_status,
) -> Result<Vec<T>> {
    let mut count = 0;
    hooks.finish(get(null_mut(), 0, &mut count), None)?;
    let mut out = Vec::with_capacity(count as usize);
    if count != 0 {
        let capacity = count;
        hooks.finish(get(out.as_mut_ptr(), capacity, &mut count), None)?;
        // The library has written `count` elements, which are not more than the capacity that it was told.
        unsafe { out.set_len(count.min(capacity) as usize) };
    }
    Ok(out)
}

/// The same for structs.
pub(crate) fn structs<Raw: Copy, T: FromRaw<Raw>>(
    hooks: &Hooks,
    get: impl FnMut(*mut Raw, u32, *mut u32) -> sys::ts_status,
) -> Result<Vec<T>> {
    Ok(elements(hooks, get)?.into_iter().map(T::from_raw).collect())
}

/// An opaque type of the C API with its function that gives it back.
pub(crate) trait Destroy {
    unsafe fn destroy(handle: *mut Self);
}

macro_rules! destroyed_by {
    ($($type:ident: $destroy:ident),*) => {$(
        impl Destroy for sys::$type {
            unsafe fn destroy(handle: *mut Self) {
                sys::$destroy(handle)
            }
        }
    )*};
}
destroyed_by!(
    ts_context: ts_context_destroy,
    ts_job: ts_job_destroy,
    ts_model: ts_model_destroy,
    ts_features: ts_features_destroy,
    ts_segmentation: ts_segmentation_destroy,
    ts_mesh: ts_mesh_destroy
);

/// An object of the library. The hooks of its context have to live as long as it does.
pub(crate) struct Handle<T: Destroy> {
    pointer: NonNull<T>,
    is_owner: bool,
    hooks: Arc<Hooks>,
}

// Objects may go from thread to thread, and functions that take them as const may run at the same time. What wraps a
// handle calls the others with &mut self only, or is not Sync.
unsafe impl<T: Destroy> Send for Handle<T> {}
unsafe impl<T: Destroy> Sync for Handle<T> {}

impl<T: Destroy> Handle<T> {
    /// What make(job, out) makes.
    pub fn make(
        hooks: &Arc<Hooks>,
        job: Option<&mut Job>,
        make: impl FnOnce(*mut sys::ts_job, *mut *mut T) -> sys::ts_status,
    ) -> Result<Self> {
        let mut out = null_mut();
        let status = make(Job::pointer(&job), &mut out);
        // Owned before the status is looked at: a callback may have panicked at the very end.
        let made = Self::own(hooks, out);
        hooks.finish(status, job)?;
        made.ok_or_else(|| Error::new(Status::INTERNAL, "nothing was made"))
    }

    pub fn own(hooks: &Arc<Hooks>, pointer: *mut T) -> Option<Self> {
        let pointer = NonNull::new(pointer)?;
        Some(Handle { pointer, is_owner: true, hooks: Arc::clone(hooks) })
    }

    /// A second handle of the same object, which does not give it back.
    ///
    /// # Safety
    /// Not to be used after the first one is gone, nor against the thread rules.
    pub unsafe fn view(&self) -> Self {
        Handle { pointer: self.pointer, is_owner: false, hooks: Arc::clone(&self.hooks) }
    }

    pub fn pointer(&self) -> *mut T {
        self.pointer.as_ptr()
    }

    pub fn hooks(&self) -> &Arc<Hooks> {
        &self.hooks
    }
}

impl<T: Destroy> fmt::Debug for Handle<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Pointer::fmt(&self.pointer, f)
    }
}

impl<T: Destroy> Drop for Handle<T> {
    fn drop(&mut self) {
        if self.is_owner {
            unsafe { T::destroy(self.pointer.as_ptr()) }
        }
    }
}

/// Owns what the library has the address of, and what it reaches by that address behind the compiler's back.
pub(crate) struct Shared<T>(NonNull<T>);

// The library reaches it only during calls that have its owner as &mut; so do its owners.
unsafe impl<T: Send> Send for Shared<T> {}
unsafe impl<T: Send> Sync for Shared<T> {}

impl<T> Shared<T> {
    pub fn new(value: T) -> Self {
        Shared(NonNull::from(Box::leak(Box::new(value))))
    }

    pub fn pointer(&self) -> *mut T {
        self.0.as_ptr()
    }
}

impl<T> fmt::Debug for Shared<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Pointer::fmt(&self.0, f)
    }
}

impl<T> Drop for Shared<T> {
    fn drop(&mut self) {
        drop(unsafe { Box::from_raw(self.0.as_ptr()) });
    }
}
