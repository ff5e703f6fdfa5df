// The linear algebra of one click, laid out for the baselines: the matrix of Eq. 3 as the paper solves it and the one
// that the library factorises once.
#pragma once

#include <vector>

#include "features/features.h"
#include "field/nodes.h"
#include "field/solver.h"

namespace ts::bench {

// The lower half of a symmetric matrix by columns, rows ascending, the diagonal first in each.
struct LowerMatrix {
  int n = 0;
  std::vector<int> start, row;
  std::vector<double> value;
};

struct Problem {
  const mesh::Surface *surface = nullptr;
  Vec<double> weight;  // an edge
  field::Nodes nodes;

  // Of Eq. 3: the vertices of all pieces that hold a constraint.
  std::vector<int> unknown;  // a vertex: its place, or -1
  int unknowns = 0;
};

// The weights and constraints of the default preset.
Problem make_problem(const mesh::Surface &surface, const features::Features &features);

// One click by the paper's way of work: (L + P) u = P b from the list of edges, alpha = 1e8 on every constraint vertex,
// b one on the tooth `group` and zero on all else.
struct ClickSystem {
  LowerMatrix matrix;
  std::vector<double> right;
};
ClickSystem assemble_click(const Problem &problem, mesh::Index group);

// The matrix of field::Solver: the free vertices, then a row a node, which is what its vertices add up to, with the
// mean of the diagonal added there.
LowerMatrix assemble_shared(const Problem &problem);

// Largest difference of a baseline's u from the library's field with the same values held.
double difference(const Problem &problem, const field::Solver &solver, mesh::Index group, const std::vector<double> &u);

}  // namespace ts::bench
