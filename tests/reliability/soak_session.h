// One person's session on a scan, from the mesh to the files: all kinds of calls, some of them cancelled.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene.h"

struct Scan {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
};

struct SessionOutcome {
  std::uint64_t hash;  // of the labels at the end
  long edits;          // that were taken
};

// The same calls each time, with the same results. `soup`: the mesh comes as an STL file, welded on its way in. What is
// written goes to files whose names begin with `path`.
SessionOutcome soak_session(ts_context *context, const Scan &scan, bool soup, const std::string &path);

// All teeth of a scan, separated.
Handle<ts_segmentation> soak_case(ts_context *context, const Scan &scan);
// Corrections that are taken back, a mesh, a session's text: nothing has changed afterwards.
void soak_corrections(ts_segmentation *s);
