// Nested dissection: an order of elimination that keeps the factor thin, and the tree it follows.
#pragma once

#include <span>

#include "base/executor.h"
#include "mesh/surface.h"

namespace ts::field {

using mesh::Index;

// A part is a set of vertices eliminated together: the separator of a piece of the surface, or a piece small enough not
// to be cut again. What a part touches and is eliminated later lies in the parts above it.
struct Part {
  Index begin = 0, end = 0;   // its places in the order
  Index first = 0;            // the piece it was cut from (itself included) holds the places [first, end)
  Index parent = mesh::none;  // mesh::none for the root
  Index children[2] = {mesh::none, mesh::none};
};

struct Dissection {
  Vec<Index> order;  // place -> vertex
  Vec<Part> parts;   // children before parents; empty if there is nothing to order
};

// Pieces are halved at the median along the longest side of their bounding box, in axes of the vertices' own, so that
// the order hardly depends on the pose: an arch is a long strip, and cuts across it are short. Only the positions are
// looked at to cut and only the edges to find what separates, so any surface has a correct order; a bad one costs time.
Dissection dissect(const mesh::Surface &surface, std::span<const Index> vertices, const Executor &executor);

}  // namespace ts::field
