// Symmetric edge weights as rows a vertex, and what is done with them: products and screened smoothing.
#pragma once

#include <limits>

#include "base/executor.h"
#include "mesh/surface.h"

namespace ts::geometry {

using mesh::Index;
using mesh::Surface;
using mesh::Vec3;

// The off-diagonal part of a Laplacian D - W: row v holds the neighbours of v and the weights of the edges to them.
struct Graph {
  Vec<Index> start;  // vertices + 1
  Vec<Index> neighbour;
  Vec<double> weight;

  std::size_t size() const { return start.empty() ? 0 : start.size() - 1; }
};

// Weights above `most` are taken for that.
Graph make_graph(const Surface &surface, const Vec<double> &edge_weight, const Executor &executor = Executor(1),
                 double most = std::numeric_limits<double>::infinity());

// (cot a + cot b) / 2 an edge, at least `least`: a clamped one keeps the maximum principle on bad triangles.
Vec<double> cotangent_weights(const Surface &surface, double least, const Executor &executor);

// Solves (M + r^2 L) x = M x0, M the vertex areas, by conjugate gradients with the diagonal as preconditioner. r is an
// edge length or so: the matrix is well conditioned and needs no factorisation. Sums are taken over fixed ranges, so
// the result is the same for any number of threads.
Vec<Vec3> smooth(const Surface &surface, const Graph &graph, double radius, const Vec<Vec3> &x0,
                 const Executor &executor);

}  // namespace ts::geometry
