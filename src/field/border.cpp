#include "field/border.h"

#include <algorithm>

#include "base/error.h"

namespace ts::field {

Border::Border(const Solver &solver, std::span<const Vec<Index>> added, const Executor &executor) : solver_(&solver) {
  const Factor &f = solver.factor();
  const mesh::Surface &surface = f.surface();
  Vec<std::array<Index, 2>> of;  // place, added node; by place
  for (Index k = 0; k < added.size(); ++k) {
    const std::size_t before = of.size();
    for (const Index v : added[k]) {
      const Index place = f.place(v);
      if (place == mesh::none || place >= f.interior()) continue;
      if (std::ranges::none_of(of, [&](const auto &o) { return o[0] == place; })) of.push_back({place, k});
    }
    if (of.size() == before)
      throw Error(Fault::no_constraint, "added node " + std::to_string(k) + " has no vertex that is free");
  }
  std::ranges::sort(of);
  // The flux of a vertex among those of its own node alone is zero: it need not be held.
  const auto node_at = [&](Index vertex) {
    const Index place = f.place(vertex);
    const auto at = std::ranges::lower_bound(of, place, {}, [](const auto &o) { return o[0]; });
    return at == of.end() || (*at)[0] != place ? mesh::none : (*at)[1];
  };
  Vec<Index> places, node;
  for (std::size_t k = 0; k < added.size(); ++k)
    for (const Index v : added[k]) {
      if (node_at(v) != k) continue;
      const auto edges = surface.vertex_edges[v];
      if (std::ranges::all_of(edges, [&](Index e) { return node_at(surface.other_end(e, v)) == k; })) continue;
      places.push_back(f.place(v));
      node.push_back(static_cast<Index>(k));
    }
  const auto rank = static_cast<Eigen::Index>(places.size()), extra = static_cast<Eigen::Index>(added.size());
  member_ = Eigen::MatrixXd::Zero(rank, extra);
  for (Eigen::Index i = 0; i < rank; ++i) member_(i, static_cast<Eigen::Index>(node[static_cast<std::size_t>(i)])) = 1;

  forward_ = std::make_unique<Forward>(f, places, executor);
  measures_ = forward_->measures();
  llt_.compute(forward_->products(*forward_));
  if (llt_.info() != Eigen::Success) throw Error(Fault::solver, "the vertices of the added nodes are not independent");

  const auto nodes = static_cast<Eigen::Index>(f.nodes());
  Eigen::MatrixXd of_all(rank, nodes + extra);  // what brings K to 0 for a node's 1, or to its node's 1
  of_all << -measures_, member_;
  Eigen::MatrixXd schur = of_all.transpose() * llt_.solve(of_all);
  schur.topLeftCorner(nodes, nodes) += solver.schur();
  nodal_ = Nodal((schur + schur.transpose()) / 2);
}

Solution Border::extend(const Eigen::VectorXd &at_nodes) const {
  const Eigen::VectorXd given = at_nodes.head(measures_.cols());
  Eigen::VectorXd target = member_ * at_nodes.tail(member_.cols());
  // A piece without a held node is NaN as a whole, and the others are none of its business.
  for (Eigen::Index i = 0; i < target.size(); ++i)
    for (Eigen::Index j = 0; j < given.size(); ++j)
      if (measures_(i, j) != 0) target[i] -= measures_(i, j) * given[j];
  Eigen::VectorXd flux = target.array().isNaN().select(0, target);
  llt_.solveInPlace(flux);
  return solver_->extend(given, forward_->source(flux));
}

Eigen::VectorXd Border::measure(Index vertex) const {
  const double one = 1;
  return measure({&vertex, 1}, {&one, 1});
}

Eigen::VectorXd Border::measure(std::span<const Index> vertices, std::span<const double> weights) const {
  const Weighed w = weigh(solver_->factor(), vertices, weights);
  const Eigen::Index nodes = measures_.cols();
  Eigen::VectorXd share = Eigen::VectorXd::Zero(nodes + member_.cols());
  share.head(nodes) = w.held;
  if (w.place.empty()) return share;
  const Forward forward(solver_->factor(), w.place, w.weight);
  const Eigen::VectorXd drawn = llt_.solve(forward_->products(forward));  // G^-1 (A^-1)_Kv
  share.head(nodes) += forward.measures().transpose() - measures_.transpose() * drawn;
  share.tail(member_.cols()) = member_.transpose() * drawn;
  return share;
}

}  // namespace ts::field
