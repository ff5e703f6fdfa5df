// SPDX-License-Identifier: Apache-2.0
//! Tests of the crate, on the synthetic arch that test.sh makes.

mod callbacks;
mod edits;
mod errors;
mod fixture;
mod lifetimes;
mod memory;
mod results;
mod scan;
mod threads;
mod values;
