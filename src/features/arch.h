// The arch curve: the ridge of roughness that the teeth form in plan view.
#pragma once

#include <span>

#include "features/orientation.h"

namespace ts::features {

using Vec2 = Eigen::Vector2d;

// Equidistant points along the arch, in plan coordinates, and the unit normals (the tangent turned left).
struct ArchCurve {
  double step = 0.25;  // mm
  Vec<Vec2> point, normal;
};

// `convexity` belongs to the samples and is that of faces that look outwards. Throws Error{no_teeth}.
ArchCurve arch_curve(std::span<const geometry::Sample> samples, std::span<const double> convexity, bool inside_out,
                     const Plan &plan);

}  // namespace ts::features
