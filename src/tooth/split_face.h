// One face of the scan, cut convexly along straight chords from border to border.
#pragma once

#include <span>

#include "base/function_ref.h"
#include "mesh/surface.h"

namespace ts::tooth {

using mesh::Index;
using mesh::Triangle;
using mesh::Vec3;

// A corner of the face or a point on one of its edges.
struct RingPoint {
  Index id = mesh::none;
  Vec3 weight = Vec3::Zero();  // barycentric
};

// From one point of the ring to another that is not on the same edge of the face, with `line` on its left.
struct Chord {
  Index from = mesh::none, to = mesh::none;  // ids
  Index line = mesh::none;
};

// The side of a piece that runs along a chord, in the chord's direction.
struct Mark {
  Index from, to;
  Index line;
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the 0 in what the compiler makes of it for a pointer
  friend auto operator<=>(const Mark &, const Mark &) = default;
};

// Appends the pieces, counter-clockwise as the ring is, and the marks of their sides. Chords may meet inside the face:
// add(weights) gives such a point an id. On which side of a chord a point of the ring lies is a matter of the order
// along the ring, never of rounding; where rounding makes a piece look as if a chord crossed it other than once, it is
// left whole.
void split_face(std::span<const RingPoint> ring, std::span<const Chord> chords, FunctionRef<Index(const Vec3 &)> add,
                Vec<Vec<Index>> &pieces, Vec<Mark> &marks);

// Appends the triangles of a convex polygon, corners in the middle of a side allowed: of all ways that with the best
// worst triangle.
void triangulate_convex(std::span<const Vec3> position, std::span<const Index> polygon, Vec<Triangle> &out);

}  // namespace ts::tooth
