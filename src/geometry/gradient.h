// Gradient of a scalar field that is linear on each face.
#pragma once

#include "mesh/surface.h"

namespace ts::geometry {

// In the plane of face f, units of u per mm; zero on a face without area.
inline mesh::Vec3 face_gradient(const mesh::Surface &s, mesh::Index f, double u0, double u1, double u2) {
  if (!(s.face_area[f] > 0)) return mesh::Vec3::Zero();
  const auto &t = s.triangle[f];
  const mesh::Vec3 &a = s.position[t[0]], &b = s.position[t[1]], &c = s.position[t[2]];
  return s.face_normal[f].cross(u0 * (c - b) + u1 * (a - c) + u2 * (b - a)) / (2 * s.face_area[f]);
}

}  // namespace ts::geometry
