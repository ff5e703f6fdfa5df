// Eq. 3 for any click from one factorisation.
//
// With the vertices split into the free ones I and the nodes F, the Laplacian of Eqs. 4 and 5 is
//   [ A  B^T ]          and Eq. 3 reduces exactly to   (S + P) u_F = P b,   A u_I = -B^T u_F,
//   [ B  D   ]
// S = D - B A^-1 B^T the Schur complement: a dense matrix over the nodes only. A is factorised once, nodes ordered
// last, so S falls out of the same factorisation, and a click costs a small dense solve and the back-substitution for
// the vertices it looks at.
#pragma once

#include <span>

#include "field/nodal.h"
#include "field/nodes.h"
#include "field/solution.h"

namespace ts::field {

class Solver {
 public:
  // Pieces of the surface that no node touches are left out. `most_bytes`: of the factor (Factor). Throws
  // Fault::solver, Fault::out_of_memory.
  Solver(const mesh::Surface &surface, Vec<double> edge_weight, const Nodes &nodes, const Executor &executor,
         const Progress &progress = {}, std::size_t most_bytes = SIZE_MAX);

  // -S_ij is the conductance between nodes i and j with all else free. Rows sum to zero.
  const Eigen::MatrixXd &schur() const { return nodal_.schur(); }

  // Eq. 3 on the nodes: those with a value are held with penalty alpha (0: exactly), the others are free. NaN where no
  // held node is in reach.
  Eigen::VectorXd solve_nodes(std::span<const double> held, double alpha) const { return nodal_.solve(held, alpha); }

  // The values at the vertices from those at the nodes, where they are asked for. `source`: what is put into free
  // vertices (Border).
  Solution extend(const Eigen::VectorXd &at_nodes, Source source = {}) const;
  // All of them; NaN on pieces left out.
  Vec<double> extend_to_all(const Eigen::VectorXd &at_nodes) const;

  // Harmonic measure of a vertex: the share of each node in its value, u(v) = measure . u_F; zero on pieces left out.
  // Of several: of the sum of their values with these weights. Touches their paths to the root of the tree only.
  Eigen::VectorXd measure(Index vertex) const;
  Eigen::VectorXd measure(std::span<const Index> vertices, std::span<const double> weights) const;

  const Factor &factor() const { return *factor_; }
  std::size_t bytes() const;                                           // of what is kept for the clicks
  std::size_t whole_bytes() const;                                     // ... if all of the factor were kept
  std::size_t solution_bytes() const;                                  // of what a solution works in
  double elimination_ms() const { return factor_->elimination_ms(); }  // of making it, the numbers alone

 private:
  Vec<Index> node_of_;
  std::unique_ptr<const Factor> factor_;
  Nodal nodal_;
  std::span<const Index> piece_of_;  // a vertex: its piece of the surface
  Index pieces_ = 0;
  Vec<std::pair<Index, Index>> touched_;  // nodes and the pieces they lie in
  mutable Pool<Solution::Space> spaces_;
};

}  // namespace ts::field
