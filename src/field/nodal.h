// Eq. 3 on the nodes alone: the dense system of a Schur complement.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <span>

#include "mesh/surface.h"

namespace ts::field {

using mesh::Index;

// Value of a node that is not held.
inline constexpr double free_node = std::numeric_limits<double>::quiet_NaN();

// The conductances between nodes, and which of them see each other at all.
class Nodal {
 public:
  // The diagonal of `schur` is not read: constants are in the kernel exactly.
  explicit Nodal(Eigen::MatrixXd schur);
  Nodal() = default;

  // -S_ij is the conductance between nodes i and j with all else free. Rows sum to zero.
  const Eigen::MatrixXd &schur() const { return schur_; }

  // The nodes with a value are held with penalty alpha (0: exactly), the others are free. NaN where no held node is in
  // reach. Throws Fault::solver.
  Eigen::VectorXd solve(std::span<const double> held, double alpha) const;

 private:
  Eigen::MatrixXd schur_;
  Vec<Index> set_;  // of nodes that S connects: the first node of each node's
};

}  // namespace ts::field
