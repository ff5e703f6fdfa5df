#include "field/solver.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace ts::field {
namespace {

Vec<std::uint8_t> pieces_with_node(const mesh::Surface &surface, const Vec<Index> &node_of) {
  Vec<std::uint8_t> has(surface.components, 0);
  for (Index v = 0; v < surface.vertices(); ++v)
    if (node_of[v] != mesh::none && surface.vertex_component[v] != mesh::none) has[surface.vertex_component[v]] = 1;
  return has;
}

// Sets of nodes that S connects: the first node of each node's set.
Vec<Index> connected_sets(const Eigen::MatrixXd &s) {
  const Index n = static_cast<Index>(s.rows());
  Vec<Index> set(n, mesh::none), stack;
  for (Index i = 0; i < n; ++i) {
    if (set[i] != mesh::none) continue;
    stack.assign(1, i);
    set[i] = i;
    while (!stack.empty()) {
      const Index j = stack.back();
      stack.pop_back();
      for (Index k = 0; k < n; ++k)
        if (set[k] == mesh::none && s(j, k) != 0) set[k] = i, stack.push_back(k);
    }
  }
  return set;
}

}  // namespace

Solver::Solver(const mesh::Surface &surface, Vec<double> edge_weight, const Nodes &nodes, const Executor &executor,
               const Progress &progress, std::size_t most_bytes)
    : node_of_(nodes.of_vertex) {
  const Vec<std::uint8_t> used = pieces_with_node(surface, node_of_);
  Vec<Index> free;
  for (Index v = 0; v < surface.vertices(); ++v) {
    const Index piece = surface.vertex_component[v];
    if (node_of_[v] == mesh::none && piece != mesh::none && used[piece]) free.push_back(v);
  }
  progress(0);
  Dissection dissection = dissect(surface, free, executor);
  Vec<Index> place(surface.vertices(), mesh::none);
  for (Index k = 0; k < dissection.order.size(); ++k) place[dissection.order[k]] = k;
  const auto interior = static_cast<Index>(free.size());
  for (Index v = 0; v < surface.vertices(); ++v)
    if (node_of_[v] != mesh::none) place[v] = interior + node_of_[v];
  free = {};
  progress(0.2);
  const std::size_t own = node_of_.size() * sizeof(Index) + nodes.size() * nodes.size() * sizeof(double);
  factor_ = std::make_unique<const Factor>(
      Laplacian{surface, std::move(edge_weight), node_of_, static_cast<Index>(nodes.size())}, std::move(dissection),
      place, most_bytes > own ? most_bytes - own : 0, executor, progress.part(0.2, 1, "factorisation"));
  schur_ = factor_->corner();
  // Constants are in the kernel of S exactly.
  for (Eigen::Index i = 0; i < schur_.rows(); ++i) schur_(i, i) = -schur_.row(i).sum();
  set_ = connected_sets(schur_);
  progress(1);
}

Eigen::VectorXd Solver::solve_nodes(std::span<const double> held, double alpha) const {
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
  for (Eigen::Index i = 0; i < m; ++i) u[unknown[static_cast<std::size_t>(i)]] = x[i];
  return u;
}

Solution Solver::extend(const Eigen::VectorXd &at_nodes) const {
  return {*factor_, spaces_, {at_nodes.data(), static_cast<std::size_t>(at_nodes.size())}};
}

Vec<double> Solver::extend_to_all(const Eigen::VectorXd &at_nodes) const {
  Solution solution = extend(at_nodes);
  Vec<double> u(node_of_.size());
  for (Index v = 0; v < u.size(); ++v) u[v] = solution(v);
  return u;
}

Eigen::VectorXd Solver::measure(Index vertex) const {
  const Factor &f = *factor_;
  Eigen::VectorXd share = Eigen::VectorXd::Zero(f.nodes());
  const Index place = f.place(vertex);
  if (place == mesh::none) return share;
  if (place >= f.interior()) {
    share[place - f.interior()] = 1;
    return share;
  }
  // What is put into the vertex goes to the root: a part passes b on to its rows as -L21 L11^-1 b.
  Vec<double> at_rows, next;
  std::span<const Index> rows;
  Block made;
  for (Index part = f.part_of(place); part != mesh::none; part = f.parts()[part].parent) {
    const Part &p = f.parts()[part];
    if (!f.kept(f.chunk_of(part)) && !made) made = f.make(f.chunk_of(part));
    const Factor::Panel panel = f.panel(part, made);
    const std::span<const Index> below = f.rows(part);
    Vec<double> y(panel.columns, 0);
    next.assign(below.size(), 0);
    if (rows.empty() && at_rows.empty()) y[place - p.begin] = 1;
    for (std::size_t i = 0, to = 0; i < rows.size(); ++i) {
      if (rows[i] < p.end) {
        y[rows[i] - p.begin] = at_rows[i];
        continue;
      }
      while (below[to] < rows[i]) ++to;
      next[to] = at_rows[i];
    }
    for (std::size_t j = 0; j < panel.columns; ++j) {
      for (std::size_t i = 0; i < below.size(); ++i) next[i] -= panel.touched[j * panel.stride + i] * y[j];
    }
    at_rows.swap(next);
    rows = below;
    if (rows.empty()) return share;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) share[rows[i] - f.interior()] = at_rows[i];
  return share;
}

std::size_t Solver::whole_bytes() const {
  return bytes() + factor_->left_out_bytes();
}

std::size_t Solver::solution_bytes() const {
  return sizeof(double) * (std::size_t{factor_->interior()} + factor_->nodes()) +
         factor_->parts().size() * (1 + sizeof(Index));
}

std::size_t Solver::bytes() const {
  return factor_->bytes() + node_of_.size() * sizeof(Index) + sizeof(double) * static_cast<std::size_t>(schur_.size());
}

}  // namespace ts::field
