// Judges of closed meshes that are not the library: OpenMesh, and CGAL (GPL, for tests and benchmarks only) where it is
// installed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace judge {

using Point = std::array<double, 3>;
using Face = std::array<std::uint32_t, 3>;

// OpenMesh takes every face and finds every vertex manifold: so no edge has more than two faces, and none two in the
// same direction.
bool manifold_and_oriented(const std::vector<Point> &points, const std::vector<Face> &faces);
// And none less than two.
bool watertight(const std::vector<Point> &points, const std::vector<Face> &faces);

bool has_cgal();
// Pairs of faces that run through or touch each other other than at what they share, of those near the given ones:
// those with a vertex in common with one of them. Exact; empty without CGAL.
std::vector<std::array<std::size_t, 2>> crossings_near(const std::vector<Point> &points, const std::vector<Face> &faces,
                                                       const std::vector<std::uint8_t> &vertex_is_near);

}  // namespace judge
