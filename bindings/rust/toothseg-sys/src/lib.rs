// SPDX-License-Identifier: Apache-2.0
//! The C API of toothseg as it is. The crate `toothseg` is the one to use; this one is for what is not safe.

#![allow(non_camel_case_types)]

#[rustfmt::skip]
mod generated;
pub use generated::*;
