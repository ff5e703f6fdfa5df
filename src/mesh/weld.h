// Which vertices are one.
#pragma once

#include <span>

#include "base/executor.h"
#include "mesh/surface.h"

namespace ts::mesh {

// For each vertex the one that stands for it: of equal positions the first. With a tolerance, in lexicographic order of
// position (so that the numbering does not matter), a vertex joins the nearest earlier one kept within the tolerance,
// or is kept: no vertex moves further, none of those kept are closer, and no chain of close vertices collapses.
Vec<Index> weld(std::span<const Vec3> position, double tolerance, const Executor &executor);

}  // namespace ts::mesh
