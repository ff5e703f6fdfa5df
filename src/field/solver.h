// Eq. 3 for any click from one factorisation.
//
// With the vertices split into the free ones I and the nodes F, the Laplacian of Eqs. 4 and 5 is
//   [ A  B^T ]          and Eq. 3 reduces exactly to   (S + P) u_F = P b,   A u_I = -B^T u_F,
//   [ B  D   ]
// S = D - B A^-1 B^T the Schur complement: a dense matrix over the nodes only. A is factorised once, nodes ordered
// last, so S falls out of the same factorisation, and a click costs a small dense solve and one back-substitution.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <span>

#include "base/progress.h"
#include "field/nodes.h"

namespace ts::field {

// Value of a node that is not held.
inline constexpr double free_node = std::numeric_limits<double>::quiet_NaN();

class Solver {
 public:
  // Pieces of the surface that no node touches are left out. Throws Fault::solver.
  Solver(const mesh::Surface &surface, const Vec<double> &edge_weight, const Nodes &nodes,
         const Progress &progress = {});

  // -S_ij is the conductance between nodes i and j with all else free. Rows sum to zero.
  const Eigen::MatrixXd &schur() const { return schur_; }

  // Eq. 3 on the nodes: those with a value are held with penalty alpha (0: exactly), the others are free. NaN where no
  // held node is in reach.
  Eigen::VectorXd solve_nodes(std::span<const double> held, double alpha) const;

  // Values at all vertices from those at the nodes, a column each; NaN on pieces left out. Columns are solved up to
  // eight a sweep over the factor; each gives the same bytes as alone.
  Vec<Vec<double>> extend(std::span<const Eigen::VectorXd> at_nodes) const;

  // Harmonic measure of a vertex: the share of each node in its value, u(v) = measure . u_F; zero on pieces left out.
  // Touches the vertex' path in the elimination tree only.
  Eigen::VectorXd measure(Index vertex) const;

  // Of the factor, values and indices: what a sweep of `extend` reads.
  std::size_t factor_bytes() const { return value_.size() * sizeof(double) + row_.size() * sizeof(Index); }

 private:
  void factorise(const mesh::Surface &surface, const Vec<double> &edge_weight, const Progress &progress);
  template <int K>
  void sweep(double *x) const;

  Vec<Index> node_of_, slot_;  // a vertex: its node / its place among the free ones, or none
  Index interior_ = 0, nodes_ = 0;
  Vec<std::size_t> column_;  // the free columns of the factor; the diagonal first in each
  Vec<Index> row_;
  Vec<double> value_;
  Eigen::MatrixXd schur_;
};

}  // namespace ts::field
