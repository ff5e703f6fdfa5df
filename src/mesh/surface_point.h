// A point on the surface: a face and the weights of its corners.
#pragma once

#include "mesh/surface.h"

namespace ts::mesh {

struct SurfacePoint {
  Index face = none;
  Vec3 barycentric = Vec3::Zero();
  Vec3 position = Vec3::Zero();
  double distance = 0;  // from the query, mm

  Index nearest_vertex(const Surface &s) const {
    Eigen::Index k = 0;
    barycentric.maxCoeff(&k);
    return s.triangle[face][static_cast<std::size_t>(k)];
  }
};

}  // namespace ts::mesh
