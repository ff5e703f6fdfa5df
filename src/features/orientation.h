// Where the biting surfaces look, and whether the faces are inside out.
#pragma once

#include <span>

#include "geometry/samples.h"

namespace ts::features {

using mesh::Vec3;

struct Orientation {
  Vec3 occlusal = Vec3::Zero();  // unit, from the gums to the biting surface
  bool inside_out = false;
  double clarity = 0;  // |sum W |cv| N| / sum W |cv|: 0 on closed symmetric bodies
  double outward = 0;  // sum W cv^3 / sum W |cv|^3 over the occlusal side; negative = inside out
};

// Teeth are what is rough on a scan, and their roughness faces the opposite jaw: d ~ sum W |cv| N. `given` replaces it
// if not zero. Convexities belong to the samples. Throws Error{no_teeth} for a surface without any roughness.
Orientation orientation(std::span<const geometry::Sample> samples, std::span<const double> convexity,
                        const Vec3 &given);

// Plan view along the occlusal direction: u, v and the height d. u and v follow the axes of the surface's own frame, so
// that what is measured on grids does not depend on the pose; a mirrored surface has the mirrored, left-handed plan.
struct Plan {
  Vec3 u, v, d, origin;

  Plan() = default;
  Plan(const Vec3 &occlusal, const geometry::Frame &frame);
  Vec3 of(const Vec3 &p) const {
    const Vec3 q = p - origin;
    return {q.dot(u), q.dot(v), q.dot(d)};
  }
  Vec3 back(const Vec3 &q) const { return origin + q.x() * u + q.y() * v + q.z() * d; }
};

}  // namespace ts::features
