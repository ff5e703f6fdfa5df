// Sets of faces: grown from seeds, holes filled.
#pragma once

#include <span>

#include "cut/space.h"

namespace ts::cut {

// The connected set of faces with mean phi < level that touch a seed vertex, as the level rises.
class Growth {
 public:
  // `phi` is looked at as long as the growth is used. `inside` is clean at first and belongs to the growth from then
  // on, but for faces filled and taken out again.
  Growth(const Surface &surface, Values phi, std::span<const Index> seeds, Mask &inside);

  // Levels must not fall. Faces with a NaN stay outside.
  void rise(double level);

  // Of the faces inside those with a corner that is not below the level, and of those outside the ones beside them,
  // over an edge.
  const Vec<Index> &mixed() const { return mixed_; }
  const Vec<Index> &beside() const { return beside_; }
  double area() const { return area_; }

 private:
  double mean(Index face) const;

  const Surface &surface_;
  Values phi_;
  Mask &inside_;
  Vec<Index> beside_, mixed_, stack_;
  double area_ = 0;
};

// Leaves only the connected sets of faces inside that touch a seed vertex.
void keep_seeded(const Surface &surface, std::span<const Index> seeds, Mask &inside);

// Takes in what is enclosed: connected sets of faces outside, of at most `area` mm^2, without a vertex that is foreign
// (of the seeds of other teeth) and without an edge on a border of the scan. `beside`: faces outside, at least one of
// each set that may be enclosed. Gives the faces taken in.
Vec<Index> fill_holes(const Surface &surface, double area, Kinds foreign, std::span<const Index> beside, Mask &inside);

Vec<Index> faces_of(const Mask &inside);                        // ascending
Vec<Index> beside(const Surface &surface, const Mask &inside);  // faces outside with an edge to one inside
Vec<Index> vertices_of(const Surface &surface, std::span<const Index> faces, Space &space);  // ascending
double area_of(const Surface &surface, std::span<const Index> faces);

}  // namespace ts::cut
