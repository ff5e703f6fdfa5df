// A smooth piece of surface in a closed loop.
#pragma once

#include <span>

#include "base/function_ref.h"
#include "base/progress.h"
#include "mesh/surface.h"

namespace ts::tooth {

using mesh::Index;
using mesh::Triangle;
using mesh::Vec3;

struct Fill {
  Vec<Vec3> position;      // the loop's, then those inside
  Vec<Triangle> triangle;  // the sides of the loop in its own direction
};

struct FillOptions {
  double growth = 1.15;  // of the distance of points, from each ring to the next
  int rounds = 3;        // of making it a membrane; 0: as first triangulated
};

// The way of Liepa (Filling holes in meshes, SGP 2003): the triangulation of least area (Barequet and Sharir 1995),
// points added until they are as dense as those of the loop, edges flipped to Delaunay; in place of his thin plate a
// membrane, the discrete minimal surface (Pinkall and Polthier 1993), which does not bulge through what it closes.
// `spacing` is the distance of points wanted at each point of the loop, mm; `taken` says which two points of the loop
// an edge joins already that is no side of the loop: none of the fill will.
Fill fill_loop(std::span<const Vec3> loop, std::span<const double> spacing, FunctionRef<bool(Index, Index)> taken,
               const FillOptions &options, const Progress &progress);

}  // namespace ts::tooth
