// New lines for a tooth, and the tooth that they give.
#pragma once

#include "cut/line.h"
#include "cut/reroute.h"
#include "cut/sides.h"
#include "tooth/prepared.h"
#include "tooth/tooth.h"

namespace ts::tooth {

// A stretch of one loop, in the direction of its line: the points between the two, which stay themselves.
struct Stretch {
  Index loop = 0, first = 0, last = 0;
};

// Of one use: each of the three functions that give a tooth may be called once. They throw edit_... and leave the tooth
// as it is. What is measured on the field of a click is not set anew.
class Relining {
 public:
  Relining(const Prepared &prepared, const Tooth &tooth);

  cut::Reroute &border() { return border_; }
  // How far along the border the stretch can be, mm.
  double reach_along(const Stretch &stretch) const;
  std::uint8_t kind(Index v) const { return kind_for(p_, tooth_.group, v); }

  // The stretch, whose border has been freed, replaced by `way`, which runs along edges from the first to the last
  // vertex of what was freed. The line is smoothed as that of a click, passes by `through`, takes the points of `drawn`
  // on edges that it crosses, and is the same to the bit outside the stretch.
  Tooth follow(const Stretch &stretch, std::span<const Index> way, std::span<const cut::Through> through,
               const cut::Polyline &drawn);

  // All lines moved along the surface, outwards where `mm` > 0.
  Tooth offset(double mm);

  // All lines smoothed by (M + r^2 L) psi = M psi0 as those of a click are, psi0 by the area within.
  Tooth smooth(double radius);

 private:
  bool within(Index v) const { return (space_->marks[v] & cut::kWithin) != 0; }
  void hold_inside();
  void hold_kept(const Vec<cut::CrossedEdge> &kept);
  Tooth finish(Vec<Index> zone, const Vec<cut::CrossedEdge> &kept, const cut::Polyline &drawn);
  void join_kept(Vec<cut::Polyline> &lines, const Vec<cut::CrossedEdge> &kept, const cut::Polyline &drawn) const;
  void take_faces(std::span<const Index> around, Tooth &made);
  void check_points(const Tooth &made) const;
  double radius() const;

  const Prepared &p_;
  const mesh::Surface &s_;
  const Tooth &tooth_;
  cut::Spaces::Lease space_;
  Vec<const cut::Polyline *> lines_;
  cut::CrossedEdges crossed_;
  cut::Reroute border_;
};

}  // namespace ts::tooth
