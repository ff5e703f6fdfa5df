// Makes a clean triangle list a manifold with consistent winding, by turning faces round and doubling vertices only.
#pragma once

#include <span>

#include "base/executor.h"
#include "mesh/surface.h"

namespace ts::mesh {

struct Manifold {
  Vec<Triangle> triangle;     // the same faces in the same order
  Vec<Index> copy_of;         // vertices appended to the given ones: what each is a copy of
  Links links;                // what is known of them: all of a mesh without any fault, else some or nothing
  Vec<std::uint8_t> flipped;  // of each triangle, 1 if it was turned round; nothing if none was
  Index non_manifold_edges = 0, non_manifold_vertices = 0, unorientable_edges = 0;
};

// Faces that share an edge with one other face stay together. Where more than two meet, those go together that continue
// each other most smoothly among those wound alike; the rest comes apart. Each piece is wound as most of its area was.
// No degenerate or duplicate faces, each vertex used; `vertex_faces`: a vertex' faces, ascending.
Manifold make_manifold(std::span<const Vec3> position, Vec<Triangle> triangle, Rows vertex_faces,
                       const Executor &executor);

}  // namespace ts::mesh
