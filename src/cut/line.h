// The final line: the border of a set of faces, smoothed.
#pragma once

#include "cut/region.h"

namespace ts::cut {

// The zero contour of psi, (M + r^2 L) psi = M psi0 near the border and psi0 elsewhere, psi0 = -1 inside and 1 outside.
// `length` and `cotangent` are of the edges. The region is space.inside, and hangs together with the seeds; of the line
// only what bounds the part with them is kept: no islands, no pinched-off holes. Longest first; the inside is on the
// left.
Vec<Polyline> smooth_line(const Surface &surface, std::span<const double> length, std::span<const double> cotangent,
                          double radius, std::span<const Index> seeds, Space &space);

}  // namespace ts::cut
