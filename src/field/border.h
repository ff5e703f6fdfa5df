// Constraint nodes that come after the factorisation, without another one.
//
// To hold free vertices K at u_K is to put in the flux that brings them there: with G the part of A^-1 on K and H the
// harmonic measures of K, f = G^-1 (u_K - H u_F). G = Y^T Y with Y = L^-1 E_K, which lives on the paths from K to the
// root. An added node has one value, u_K = C c; the fluxes of its vertices add up, and so S grows a border:
//   [ S + H^T G^-1 H   -H^T G^-1 C ]
//   [ -C^T G^-1 H       C^T G^-1 C ]
// Back-substitution with Y f on the right-hand side gives all else.
#pragma once

#include <Eigen/Cholesky>

#include "field/forward.h"
#include "field/solver.h"

namespace ts::field {

class Border {
 public:
  // `solver` has to outlive this. A node for each of `added`, numbered after the solver's. Of its vertices those count
  // that are free: vertices of the solver's nodes and of nodes added before stay what they are, those on pieces left
  // out are no part of the problem. Throws Fault::no_constraint if that leaves a node without a vertex, Fault::solver.
  Border(const Solver &solver, std::span<const Vec<Index>> added, const Executor &executor);

  Index added() const { return static_cast<Index>(member_.cols()); }

  // As of a Solver that has had all these nodes from the beginning.
  const Eigen::MatrixXd &schur() const { return nodal_.schur(); }
  Eigen::VectorXd solve_nodes(std::span<const double> held, double alpha) const { return nodal_.solve(held, alpha); }
  Solution extend(const Eigen::VectorXd &at_nodes) const;
  Eigen::VectorXd measure(Index vertex) const;
  Eigen::VectorXd measure(std::span<const Index> vertices, std::span<const double> weights) const;

 private:
  const Solver *solver_;
  Eigen::MatrixXd member_;            // C: a vertex of K, an added node
  std::unique_ptr<Forward> forward_;  // of K
  Eigen::MatrixXd measures_;          // H
  Eigen::LLT<Eigen::MatrixXd> llt_;   // of G
  Nodal nodal_;
};

}  // namespace ts::field
