#include "field/nodal.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "base/error.h"

namespace ts::field {

Nodal::Nodal(Eigen::MatrixXd schur)
    : schur_(std::move(schur)), set_(static_cast<std::size_t>(schur_.rows()), mesh::none) {
  const Index n = static_cast<Index>(schur_.rows());
  for (Index i = 0; i < n; ++i) {
    schur_(i, i) = 0;
    schur_(i, i) = -schur_.row(i).sum();
  }
  Vec<Index> stack;
  for (Index i = 0; i < n; ++i) {
    if (set_[i] != mesh::none) continue;
    stack.assign(1, i);
    set_[i] = i;
    while (!stack.empty()) {
      const Index j = stack.back();
      stack.pop_back();
      for (Index k = 0; k < n; ++k)
        if (set_[k] == mesh::none && schur_(j, k) != 0) set_[k] = i, stack.push_back(k);
    }
  }
}

Eigen::VectorXd Nodal::solve(std::span<const double> held, double alpha) const {
  const auto nodes = static_cast<Index>(schur_.rows());
  Vec<std::uint8_t> anchored(nodes, 0);
  for (Index i = 0; i < nodes; ++i)
    if (!std::isnan(held[i])) anchored[set_[i]] = 1;
  Eigen::VectorXd u = Eigen::VectorXd::Constant(nodes, free_node);
  Vec<Index> unknown;
  for (Index i = 0; i < nodes; ++i) {
    if (!anchored[set_[i]]) continue;
    if (!std::isnan(held[i]) && alpha <= 0)
      u[i] = held[i];
    else
      unknown.push_back(i);
  }
  if (unknown.empty()) return u;
  const auto m = static_cast<Eigen::Index>(unknown.size());
  Eigen::MatrixXd a(m, m);
  Eigen::VectorXd b(m);
  for (Eigen::Index i = 0; i < m; ++i) {
    const Index node = unknown[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < m; ++j) a(i, j) = schur_(node, unknown[static_cast<std::size_t>(j)]);
    b[i] = 0;
    if (alpha > 0 && !std::isnan(held[node])) {
      a(i, i) += alpha;
      b[i] = alpha * held[node];
    } else {
      for (Index j = 0; j < nodes; ++j)
        if (alpha <= 0 && !std::isnan(held[j])) b[i] -= schur_(node, j) * held[j];
    }
  }
  const Eigen::LLT<Eigen::MatrixXd> llt(a);
  if (llt.info() != Eigen::Success) throw Error(Fault::solver, "the system of a click's constraints is singular");
  const Eigen::VectorXd x = llt.solve(b);
  if (!x.allFinite()) throw Error(Fault::solver, "the values of a click's constraints are not finite");
  for (Eigen::Index i = 0; i < m; ++i) u[unknown[static_cast<std::size_t>(i)]] = x[i];
  return u;
}

}  // namespace ts::field
