// The shortest way along the surface from one point of it to another.
#pragma once

#include "geometry/marcher.h"
#include "mesh/surface_point.h"

namespace ts::geometry {

// A point (1 - t) a + t b of the edge from a to b.
struct EdgeCrossing {
  Index a, b;
  double t;
};

// Where the way from one point to the other crosses edges, in order; consecutive ones lie in one face. It runs down the
// gradient of the distance to `to`: as exact as the marcher is. Empty also where both lie
// in one face. Throws not_found where no way leads there, or none shorter than `limit`, mm.
Vec<EdgeCrossing> geodesic(const Surface &surface, const mesh::SurfacePoint &from, const mesh::SurfacePoint &to,
                           double limit, Marcher &march);

}  // namespace ts::geometry
