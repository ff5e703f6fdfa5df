// The final line: the border of a set of faces, smoothed.
#pragma once

#include "cut/region.h"

namespace ts::cut {

// A point that a line is to pass through: the weights of a face's corners.
struct Through {
  Index face;
  Vec3 weight;
};

// psi is space.level, 1 where nothing is set. Solves (M + r^2 L) psi = M psi on the vertices `near` (ascending), psi
// held elsewhere, and with psi all but 0 at the points of `through` in faces of nothing else.
void smooth_psi(const Surface &surface, std::span<const double> cotangent, double radius, std::span<const Index> near,
                std::span<const Through> through, Space &space);

// Gives the vertices of `near` on one side of psi that cannot be reached on that side from the vertices that `start`
// names, or from beyond `near`, to the other side; their area, mm^2.
double drop_unreached(const Surface &surface, std::span<const Index> near, bool negative, std::span<const Index> start,
                      Space &space);

// The zero contour of psi, (M + r^2 L) psi = M psi0 near the border and psi0 elsewhere, psi0 = -1 inside and 1 outside.
// `length` and `cotangent` are of the edges. The region is space.inside, and hangs together with the seeds; of the line
// only what bounds the part with them is kept: no islands, no pinched-off holes. Longest first; the inside is on the
// left.
Vec<Polyline> smooth_line(const Surface &surface, std::span<const double> length, std::span<const double> cotangent,
                          double radius, std::span<const Index> seeds, Space &space);

}  // namespace ts::cut
