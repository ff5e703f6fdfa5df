// How far a surface bulges at a physical radius.
#pragma once

#include <span>

#include "base/executor.h"
#include "geometry/samples.h"

namespace ts::geometry {

// cv = (q - C).N / r, C the area-weighted centroid and N the mean normal of the surface within r of q. Dimensionless:
// 0 on a plane, r / (4 R) on a sphere of radius R outside (to first order), negative in hollows; 0.25 to 0.4 on a cusp
// at r = 2. 0 where no surface is near or its normals cancel.
double convexity(const SampleBins &bins, const Vec3 &q, double radius);

// Of each query point. `wanted` may be empty (all) or hold 0 for queries to leave at 0.
Vec<double> convexity(const SampleBins &bins, std::span<const Vec3> queries, std::span<const std::uint8_t> wanted,
                      double radius, const Executor &executor);

}  // namespace ts::geometry
