// Vertex normals.
#pragma once

#include "geometry/laplacian.h"

namespace ts::geometry {

enum class NormalWeight { angle, area };

// Unit normals, outwards; zero at a vertex whose faces cancel out.
Vec<Vec3> vertex_normals(const Surface &surface, NormalWeight weight, const Executor &executor);
// The same for other positions of the vertices.
Vec<Vec3> vertex_normals(const Surface &surface, const Vec<Vec3> &position, NormalWeight weight,
                         const Executor &executor);

// Unit normals smoothed over `radius` mm: (M + r^2 L_cot) N = M N0, then made unit again.
Vec<Vec3> smoothed_normals(const Surface &surface, const Vec<Vec3> &normal, const Graph &cotangent, double radius,
                           const Executor &executor);

}  // namespace ts::geometry
