// Lines on the surface, as points on edges.
#pragma once

#include "mesh/surface.h"

namespace ts::cut {

using mesh::Index;
using mesh::Surface;
using mesh::Vec3;

// The point (1 - t) a + t b of the edge from vertex a to vertex b.
struct EdgePoint {
  Index a = mesh::none, b = mesh::none;
  double t = 0;
  Vec3 position = Vec3::Zero();
};

struct Polyline {
  Vec<EdgePoint> points;  // a closed one repeats no point; an open one begins and ends on borders of the surface
  Vec<Index> faces;       // of the segment that begins at each point (an open line has one less)
  bool closed = false;
  double length = 0;  // mm
};

}  // namespace ts::cut
