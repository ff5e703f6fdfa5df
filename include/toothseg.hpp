// toothseg.hpp - toothseg.h for C++17: owners, vectors and exceptions instead of destroy functions, buffers and
// statuses. SPDX-License-Identifier: Apache-2.0
//
// Nothing but inline code over toothseg.h, whose comments are the manual: units, indices, threads and lifetimes are as
// said there, and the C structs and enumerators are used as they are. In addition:
//
// Owners are move-only. A moved-from one may only be assigned to or destroyed. Children keep their parents alive, so
// owners may go in any order. get() gives the C handle to call toothseg.h with.
//
// Failures throw Exception, with nothing changed. What a progress callback throws comes out of the call it stopped;
// what a change callback throws comes out of the call that made the change, which stands.
//
// Jobs are given by pointer; nullptr: no progress, no cancellation.
#ifndef TOOTHSEG_HPP
#define TOOTHSEG_HPP

#include "toothseg/base.hpp"          // Exception, Context, Job
#include "toothseg/mesh.hpp"          // Mesh: a tooth or the gingiva
#include "toothseg/scan.hpp"          // Model, Features
#include "toothseg/segmentation.hpp"  // Segmentation, Session, numbers

#endif  // TOOTHSEG_HPP
