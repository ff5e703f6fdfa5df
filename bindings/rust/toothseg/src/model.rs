// SPDX-License-Identifier: Apache-2.0
use crate::context::Context;
use crate::data::{IntakeReport, SurfacePoint};
use crate::error::Result;
use crate::job::Job;
use crate::options::IntakeOptions;
use crate::raw::{check, count32, elements, info, path_text, usage, FromRaw, Handle};
use crate::values::{FileFormat, Scalar};
use std::marker::PhantomData;
use std::mem::size_of;
use std::os::raw::c_void;
use std::path::Path;
use std::ptr::null;
use toothseg_sys as sys;

mod sealed {
    pub trait Sealed {}
}

/// What an array of positions holds: f32 or f64, one by one or three a vertex.
pub trait Coordinate: sealed::Sealed {
    /// Type of the numbers.
    const SCALAR: Scalar;
    /// Numbers an element.
    const NUMBERS: usize;
}

/// What an array of triangles holds: u32, one by one or three a face.
pub trait Corner: sealed::Sealed {
    /// Indices an element.
    const INDICES: usize;
}

macro_rules! coordinate {
    ($($type:ty: $scalar:ident, $numbers:expr;)*) => {$(
        impl sealed::Sealed for $type {}
        impl Coordinate for $type {
            const SCALAR: Scalar = Scalar::$scalar;
            const NUMBERS: usize = $numbers;
        }
    )*};
}
coordinate! { f32: FLOAT32, 1; f64: FLOAT64, 1; [f32; 3]: FLOAT32, 3; [f64; 3]: FLOAT64, 3; }

macro_rules! corner {
    ($($type:ty: $indices:expr;)*) => {$(
        impl sealed::Sealed for $type {}
        impl Corner for $type {
            const INDICES: usize = $indices;
        }
    )*};
}
corner! { u32: 1; [u32; 3]: 3; }

/// The caller's mesh, which is read when a model is made from it, without a copy before.
#[derive(Clone, Copy, Debug)]
pub struct MeshInput<'a> {
    scalar: Scalar,
    positions: *const c_void,
    numbers: usize,
    stride: usize,
    triangles: *const u32,
    indices: usize,
    arrays: PhantomData<&'a ()>,
}

// Two slices of numbers that are only read.
unsafe impl Send for MeshInput<'_> {}
unsafe impl Sync for MeshInput<'_> {}

impl<'a> MeshInput<'a> {
    /// Vertices, 3 numbers each, and triangles, 3 indices each.
    pub fn new<P: Coordinate, T: Corner>(positions: &'a [P], triangles: &'a [T]) -> Self {
        MeshInput {
            triangles: triangles.as_ptr().cast(),
            indices: triangles.len() * T::INDICES,
            ..Self::soup(positions)
        }
    }

    /// Triangles by themselves: every three vertices are a face.
    pub fn soup<P: Coordinate>(positions: &'a [P]) -> Self {
        MeshInput {
            scalar: P::SCALAR,
            positions: positions.as_ptr().cast(),
            numbers: positions.len() * P::NUMBERS,
            stride: 3,
            triangles: null(),
            indices: 0,
            arrays: PhantomData,
        }
    }

    /// So many numbers from one vertex to the next, 3 unless set: for vertices with more than a position.
    pub fn stride(mut self, numbers: usize) -> Self {
        self.stride = numbers;
        self
    }

    fn raw(&self) -> Result<sys::ts_mesh_input> {
        if self.stride < 3 {
            return Err(usage(format!("stride is {}, at least 3", self.stride)));
        }
        if self.stride == 3 && self.numbers % 3 != 0 {
            return Err(usage(format!("{} numbers are not 3 a vertex", self.numbers)));
        }
        if self.indices % 3 != 0 {
            return Err(usage(format!("{} indices are not 3 a triangle", self.indices)));
        }
        let bytes = if self.scalar == Scalar::FLOAT32 { size_of::<f32>() } else { size_of::<f64>() };
        // The last vertex need not be followed by what stands between two.
        let vertices = if self.numbers < 3 { 0 } else { (self.numbers - 3) / self.stride + 1 };
        let mut raw = sys::ts_mesh_input::default();
        check(unsafe { sys::ts_mesh_input_init(&mut raw, raw.struct_size) })?;
        raw.scalar = self.scalar.code();
        raw.positions = self.positions;
        raw.vertex_count = count32(vertices)?;
        raw.stride = count32(self.stride.saturating_mul(bytes))?;
        raw.triangles = self.triangles;
        raw.triangle_count = count32(self.indices / 3)?;
        Ok(raw)
    }
}

/// A mesh after intake: welded, clean, manifold, consistently wound. Never changes once made; threads may share it.
#[derive(Debug)]
pub struct Model {
    handle: Handle<sys::ts_model>,
}

impl Model {
    /// From arrays.
    pub fn new(context: &Context, input: &MeshInput) -> Result<Self> {
        Self::new_with(context, input, &IntakeOptions::default(), None)
    }

    /// From arrays, with options.
    pub fn new_with(
        context: &Context,
        input: &MeshInput,
        options: &IntakeOptions,
        job: Option<&mut Job>,
    ) -> Result<Self> {
        let input = input.raw()?;
        Self::make(context, job, |context, job, out| unsafe {
            sys::ts_model_create(context, &input, &options.raw(), job, out)
        })
    }

    /// From a file: STL, PLY, OBJ or OFF.
    pub fn load(context: &Context, path: impl AsRef<Path>) -> Result<Self> {
        Self::load_with(context, path, &IntakeOptions::default(), None)
    }

    /// From a file, with options.
    pub fn load_with(
        context: &Context,
        path: impl AsRef<Path>,
        options: &IntakeOptions,
        job: Option<&mut Job>,
    ) -> Result<Self> {
        let path = path_text(path.as_ref())?;
        Self::make(context, job, |context, job, out| unsafe {
            sys::ts_model_load(context, path.as_ptr(), &options.raw(), job, out)
        })
    }

    /// From a file already in memory.
    pub fn read(context: &Context, bytes: &[u8]) -> Result<Self> {
        Self::read_with(context, bytes, FileFormat::AUTO, &IntakeOptions::default(), None)
    }

    /// From a file already in memory, with options.
    pub fn read_with(
        context: &Context,
        bytes: &[u8],
        format: FileFormat,
        options: &IntakeOptions,
        job: Option<&mut Job>,
    ) -> Result<Self> {
        Self::make(context, job, |context, job, out| unsafe {
            sys::ts_model_read(context, bytes.as_ptr().cast(), bytes.len(), format.code(), &options.raw(), job, out)
        })
    }

    fn make(
        context: &Context,
        job: Option<&mut Job>,
        make: impl FnOnce(*mut sys::ts_context, *mut sys::ts_job, *mut *mut sys::ts_model) -> sys::ts_status,
    ) -> Result<Self> {
        let context = context.handle();
        let handle = Handle::make(context.hooks(), job, |job, out| make(context.pointer(), job, out))?;
        Ok(Model { handle })
    }

    /// What intake found and repaired.
    pub fn report(&self) -> Result<IntakeReport> {
        let h = &self.handle;
        info(h.hooks(), |out| unsafe { sys::ts_model_get_report(h.pointer(), out) }).map(FromRaw::from_raw)
    }

    /// Vertices of the model.
    pub fn positions(&self) -> Result<Vec<[f64; 3]>> {
        let h = &self.handle;
        elements(h.hooks(), |out: *mut [f64; 3], capacity, count| unsafe {
            sys::ts_model_get_positions(h.pointer(), out.cast(), capacity, count)
        })
    }

    /// Faces of the model.
    pub fn triangles(&self) -> Result<Vec<[u32; 3]>> {
        let h = &self.handle;
        elements(h.hooks(), |out: *mut [u32; 3], capacity, count| unsafe {
            sys::ts_model_get_triangles(h.pointer(), out.cast(), capacity, count)
        })
    }

    /// For each model face the caller's face it came from.
    pub fn face_sources(&self) -> Result<Vec<u32>> {
        let h = &self.handle;
        elements(h.hooks(), |out, capacity, count| unsafe {
            sys::ts_model_get_face_sources(h.pointer(), out, capacity, count)
        })
    }

    /// For each of the caller's vertices the model vertex that stands for it; none if it was dropped.
    pub fn vertex_map(&self) -> Result<Vec<Option<u32>>> {
        let h = &self.handle;
        let map: Vec<u32> = elements(h.hooks(), |out, capacity, count| unsafe {
            sys::ts_model_get_vertex_map(h.pointer(), out, capacity, count)
        })?;
        Ok(map.into_iter().map(FromRaw::from_raw).collect())
    }

    /// The surface point nearest to a position.
    pub fn nearest(&self, position: [f64; 3]) -> Result<SurfacePoint> {
        let h = &self.handle;
        info(h.hooks(), |out| unsafe { sys::ts_model_nearest(h.pointer(), position.as_ptr(), out) })
            .map(FromRaw::from_raw)
    }

    /// The first surface point hit by a ray.
    pub fn raycast(&self, origin: [f64; 3], direction: [f64; 3]) -> Result<SurfacePoint> {
        let h = &self.handle;
        info(h.hooks(), |out| unsafe { sys::ts_model_raycast(h.pointer(), origin.as_ptr(), direction.as_ptr(), out) })
            .map(FromRaw::from_raw)
    }

    pub(crate) fn handle(&self) -> &Handle<sys::ts_model> {
        &self.handle
    }
}
