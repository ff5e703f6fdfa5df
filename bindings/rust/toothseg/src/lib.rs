// SPDX-License-Identifier: Apache-2.0
//! Separates the teeth of a scanned dental arch.
//!
//! The way of work: [`Context`], [`Model`] (a mesh after intake), [`Features`] (found, or set by hand), [`Segmentation`]
//! (prepared once, then clicks), [`Results`] (teeth, cuts, labels: what a segmentation derefs to), [`Mesh`] (a tooth as a
//! mesh of its own), [`Session`] (a segmentation gone on with).
//!
//! Lengths are millimetres, indices start at 0. Every handle is given back when it is dropped, in any order. A call that
//! fails changes nothing, and its [`Error`] says what was wrong. The header of the C API, `toothseg.h`, is the manual.
//!
//! Callbacks (progress, log, memory) must not call the library; only the change callback may read. One that panics does
//! not unwind through the library: the panic goes on out of the call that it happened in.

#![deny(missing_docs)]

mod context;
mod data;
mod error;
mod features;
mod job;
mod mesh;
mod model;
mod numbers;
mod options;
mod raw;
mod results;
mod segmentation;
mod values;

pub use context::{Context, ContextOptions, Log, MemoryHook};
pub use data::*;
pub use error::{Error, ErrorKind, Result};
pub use features::{Features, Place};
pub use job::{Canceller, Job};
pub use mesh::Mesh;
pub use model::{Coordinate, Corner, MeshInput, Model};
pub use numbers::{fdi_to_palmer, fdi_to_universal, universal_to_fdi};
pub use options::*;
pub use results::{Cut, Polyline, Results};
pub use segmentation::{Segmentation, Session};
pub use values::*;

/// The version of the library, such as "0.1.0".
pub fn version() -> &'static str {
    raw::static_text(unsafe { toothseg_sys::ts_version() })
}
