// SPDX-License-Identifier: Apache-2.0
use crate::data::MeshInfo;
use crate::error::Result;
use crate::job::Job;
use crate::options::ToothMeshOptions;
use crate::raw::{elements, info, path_text, structs, FromRaw, Handle};
use crate::results::Results;
use crate::values::{OutputFormat, VertexFlags};
use std::path::Path;
use toothseg_sys as sys;

/// A tooth, or the gingiva, as a mesh of its own, cut exactly along the cuts of the teeth. Never changes once made.
#[derive(Debug)]
pub struct Mesh {
    handle: Handle<sys::ts_mesh>,
}

impl Mesh {
    /// Of a tooth. A segmentation can be given as it is.
    pub fn tooth(results: &Results, tooth: u32, options: &ToothMeshOptions, job: Option<&mut Job>) -> Result<Self> {
        let results = results.handle();
        let handle = Handle::make(results.hooks(), job, |job, out| unsafe {
            sys::ts_tooth_mesh_create(results.pointer(), tooth, &options.raw(), job, out)
        })?;
        Ok(Mesh { handle })
    }

    /// Of what belongs to no tooth separated so far.
    pub fn gingiva(results: &Results, options: &ToothMeshOptions, job: Option<&mut Job>) -> Result<Self> {
        let results = results.handle();
        let handle = Handle::make(results.hooks(), job, |job, out| unsafe {
            sys::ts_gingiva_mesh_create(results.pointer(), &options.raw(), job, out)
        })?;
        Ok(Mesh { handle })
    }

    /// What it holds.
    pub fn info(&self) -> Result<MeshInfo> {
        let h = &self.handle;
        info(h.hooks(), |out| unsafe { sys::ts_mesh_get_info(h.pointer(), out) }).map(FromRaw::from_raw)
    }

    /// Vertices.
    pub fn positions(&self) -> Result<Vec<[f64; 3]>> {
        let h = &self.handle;
        elements(h.hooks(), |out: *mut [f64; 3], capacity, count| unsafe {
            sys::ts_mesh_get_positions(h.pointer(), out.cast(), capacity, count)
        })
    }

    /// Unit normals of the vertices, outwards.
    pub fn normals(&self) -> Result<Vec<[f64; 3]>> {
        let h = &self.handle;
        elements(h.hooks(), |out: *mut [f64; 3], capacity, count| unsafe {
            sys::ts_mesh_get_normals(h.pointer(), out.cast(), capacity, count)
        })
    }

    /// Triangles, counter-clockwise seen from outside.
    pub fn triangles(&self) -> Result<Vec<[u32; 3]>> {
        let h = &self.handle;
        elements(h.hooks(), |out: *mut [u32; 3], capacity, count| unsafe {
            sys::ts_mesh_get_triangles(h.pointer(), out.cast(), capacity, count)
        })
    }

    /// For each triangle the model face that it is of; none for those that close the mesh.
    pub fn faces(&self) -> Result<Vec<Option<u32>>> {
        let h = &self.handle;
        structs(h.hooks(), |out: *mut u32, capacity, count| unsafe {
            sys::ts_mesh_get_faces(h.pointer(), out, capacity, count)
        })
    }

    /// For each vertex what it is.
    pub fn vertex_flags(&self) -> Result<Vec<VertexFlags>> {
        let h = &self.handle;
        structs(h.hooks(), |out: *mut u8, capacity, count| unsafe {
            sys::ts_mesh_get_vertex_flags(h.pointer(), out, capacity, count)
        })
    }

    /// Writes it to a file, which is there whole or as it was.
    pub fn save(&self, path: impl AsRef<Path>, format: OutputFormat, job: Option<&mut Job>) -> Result<()> {
        let h = &self.handle;
        let path = path_text(path.as_ref())?;
        let pointer = Job::pointer(&job);
        let status = unsafe { sys::ts_mesh_save(h.pointer(), path.as_ptr(), format.code(), pointer) };
        h.hooks().finish(status, job)
    }
}
