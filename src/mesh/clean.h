// From welded polygons to the triangles worth keeping.
#pragma once

#include "base/executor.h"
#include "base/progress.h"
#include "mesh/raw_mesh.h"

namespace ts::mesh {

struct CleanFaces {
  Vec<Triangle> triangle;  // of raw vertices that stand for themselves; no two have the same corners
  Vec<Index> source;       // a triangle: the raw face it is part of; ascending
  Vec<Index> label;        // a raw face: the triangle whose label it takes
  Rows around;             // a raw vertex: its triangles, ascending
  Index polygons = 0, degenerate = 0, duplicate = 0;  // of raw faces
};

// `kept`: what weld() gave.
CleanFaces clean_faces(const RawMesh &raw, std::span<const Index> kept, const Executor &executor, Progress progress);

}  // namespace ts::mesh
