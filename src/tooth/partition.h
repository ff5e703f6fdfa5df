// The scan cut exactly along the cuts of the separated teeth.
#pragma once

#include <span>

#include "tooth/split_face.h"
#include "tooth/tooth.h"

namespace ts::tooth {

struct Partition {
  Vec<Vec3> position;      // the surface's vertices, then the points of the cuts
  Vec<Triangle> triangle;  // in the order of the faces that they are of, wound as these
  Vec<Index> face;         // a triangle: its face
  Vec<Index> owner;        // a triangle: place in the teeth given, none: gingiva
  Index vertices = 0;      // of the surface: from there on positions are points of cuts
  Vec<double> lost;        // a tooth: mm^2 that its cuts enclose and another, or the gingiva, has
};

// What a tooth's cuts enclose is its own. Where the cuts of several teeth enclose the same, it is that of the one with
// the nearest seed, as Session::labels has it for faces: the teeth meet in the line of equal distance. What is left of
// a tooth beside another, without a seed, goes to what it has the longest border with.
// Throws no_cut where the cuts of a tooth do not part it from the rest.
Partition partition(const mesh::Surface &surface, std::span<const Tooth *const> teeth);

}  // namespace ts::tooth
