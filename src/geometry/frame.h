// Axes of a surface's own, so that a grid laid over it does not depend on the pose of the scan.
#pragma once

#include "mesh/surface.h"

namespace ts::geometry {

using mesh::Vec3;

struct Frame {
  Vec3 origin = Vec3::Zero();
  Vec3 axis[3] = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};  // unit, orthogonal, from the widest to the narrowest

  Vec3 of(const Vec3 &p) const {
    const Vec3 q = p - origin;
    return {q.dot(axis[0]), q.dot(axis[1]), q.dot(axis[2])};
  }
};

// Centre of area and principal axes, each to the side of its longer tail (third moment). A moved surface has the moved
// frame, a mirrored one the mirrored frame, which is why the frame may be left-handed. A surface as wide along two
// axes, or alike on both sides, has one of several frames, always the same for the same coordinates.
Frame principal_frame(const mesh::Surface &surface);

}  // namespace ts::geometry
