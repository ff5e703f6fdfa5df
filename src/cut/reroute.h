// Leads a stretch of the border of a region another way.
#pragma once

#include "cut/region.h"

namespace ts::cut {

// The region is space.inside; space.marks gets marks of vertices beside those of cut/sides.h.
class Reroute {
 public:
  Reroute(const Surface &surface, Space &space);

  // The vertex of the border nearest to a point of an edge; none within `reach`, mm.
  Index nearest(const EdgePoint &at, std::span<const double> length, double reach) const;
  bool on_border(Index v) const { return (space_.marks[v] & kBorder) != 0; }

  // Frees the stretch of the border that runs from one of its vertices to another, the region on its left; `reach`
  // is how long it can be, mm. Throws edit_crossing where there is none.
  void free_stretch(Index from, Index to, std::span<const double> length, double reach);
  const Vec<Index> &freed() const { return freed_; }  // its vertices

  // Marks the vertices within `far` of what was freed, along edges: what the border is led away from.
  void leave(double far, std::span<const double> length);
  bool is_left(Index v) const { return (space_.marks[v] & kLeft) != 0; }

  // On what stays of the border, or on a way bolted before.
  bool barred(Index v) const { return (space_.marks[v] & (kBorder | kWay)) != 0; }
  void bolt(Index v) { space_.marks.set(v, space_.marks[v] | kWay); }
  void unbolt(Index v) { space_.marks.set(v, space_.marks[v] & static_cast<std::uint8_t>(~kWay)); }

  // The cheapest way along edges, both ends included; empty where there is none of a finite cost. Vertices that are
  // barred are not passed.
  Vec<Index> cheapest(Index from, Index to, FunctionRef<double(Index)> cost);

  // The faces around the seeds that the border encloses with `way` (vertices, along edges) in place of what was freed:
  // 1 in space.faces. Throws edit_crossing where they are not all on the left of the new border, and none on its right.
  void take(std::span<const Index> way, std::span<const Index> seeds);

 private:
  static constexpr std::uint8_t kBorder = 4, kWay = 8, kLeft = 32;
  bool is_border(Index halfedge) const;

  const Surface &s_;
  Space &space_;
  Vec<Index> border_;  // half-edges of the region
  Vec<Index> freed_;
};

}  // namespace ts::cut
