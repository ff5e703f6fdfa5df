// Triangles of a mesh that run through each other.
#pragma once

#include <span>

#include "mesh/surface.h"

namespace ts::tooth {

using mesh::Index;
using mesh::Triangle;
using mesh::Vec3;

// Pairs of triangles of which at least one is from `first` on, each once, sorted. Triangles that share an edge cross
// where one is folded onto the other. In doubles: what lies in one
// plane counts as apart.
Vec<std::array<Index, 2>> crossings(std::span<const Vec3> position, std::span<const Triangle> triangle, Index first);

}  // namespace ts::tooth
