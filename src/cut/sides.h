// What lies within lines on the surface: the way back from a line to vertices and faces.
#pragma once

#include <span>

#include "cut/space.h"

namespace ts::cut {

// An edge that a line crosses, and which point of which line that is.
struct CrossedEdge {
  Index edge, line, place;
  EdgePoint point;
};

// By edge. No line crosses an edge twice, nor two lines the same one.
class CrossedEdges {
 public:
  CrossedEdges(const Surface &surface, std::span<const Polyline *const> lines);
  const CrossedEdge *find(Index edge) const;  // null where nothing crosses
  const Vec<CrossedEdge> &all() const { return all_; }

 private:
  Vec<CrossedEdge> all_;
};

// Marks of vertices in space.marks; 0: outside, and not on an edge that is crossed.
inline constexpr std::uint8_t kWithin = 1, kBeside = 2;

// Marks the vertices within the lines (on their left), and those beside them on edges that they cross.
void mark_sides(const Surface &surface, std::span<const Polyline *const> lines, Space &space);

// The part of a face's area that lies within the line that crosses it; `within` of its vertices.
double share_within(const Surface &surface, Index face, FunctionRef<bool(Index)> within, const CrossedEdges &crossed);

// The faces of which more than half lies within, from the marks of the vertices, into space.inside.
void take_within(const Surface &surface, const CrossedEdges &crossed, Space &space);

}  // namespace ts::cut
