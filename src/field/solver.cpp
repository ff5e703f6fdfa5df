#include "field/solver.h"

#include "field/forward.h"

namespace ts::field {
namespace {

Vec<std::uint8_t> pieces_with_node(const mesh::Surface &surface, const Vec<Index> &node_of) {
  Vec<std::uint8_t> has(surface.components, 0);
  for (Index v = 0; v < surface.vertices(); ++v)
    if (node_of[v] != mesh::none && surface.vertex_component[v] != mesh::none) has[surface.vertex_component[v]] = 1;
  return has;
}

}  // namespace

Solver::Solver(const mesh::Surface &surface, Vec<double> edge_weight, const Nodes &nodes, const Executor &executor,
               const Progress &progress, std::size_t most_bytes)
    : node_of_(nodes.of_vertex), piece_of_(surface.vertex_component), pieces_(surface.components) {
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
  // What lies between nodes alone is in no pivot.
  if (!factor_->corner().allFinite()) throw Error(Fault::solver, "the weights between the constraints are not finite");
  nodal_ = Nodal(factor_->corner());
  for (Index v = 0; v < surface.vertices(); ++v)
    if (const Index piece = surface.vertex_component[v]; node_of_[v] != mesh::none && piece != mesh::none)
      touched_.emplace_back(node_of_[v], piece);
  std::ranges::sort(touched_);
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  progress(1);
}

Solution Solver::extend(const Eigen::VectorXd &at_nodes, Source source) const {
  Solution::Dark dark{piece_of_, {}};
  if (at_nodes.hasNaN()) {
    dark.piece.assign(pieces_, 1);
    for (const auto &[node, piece] : touched_)
      if (!std::isnan(at_nodes[static_cast<Eigen::Index>(node)])) dark.piece[piece] = 0;
  }
  return {*factor_,
          spaces_,
          {at_nodes.data(), static_cast<std::size_t>(at_nodes.size())},
          std::move(dark),
          std::move(source)};
}

Vec<double> Solver::extend_to_all(const Eigen::VectorXd &at_nodes) const {
  Solution solution = extend(at_nodes);
  Vec<double> u(node_of_.size());
  for (Index v = 0; v < u.size(); ++v) u[v] = solution(v);
  return u;
}

Eigen::VectorXd Solver::measure(Index vertex) const {
  const double one = 1;
  return measure({&vertex, 1}, {&one, 1});
}

Eigen::VectorXd Solver::measure(std::span<const Index> vertices, std::span<const double> weights) const {
  const Weighed w = weigh(*factor_, vertices, weights);
  if (w.place.empty()) return w.held;
  return w.held + Forward(*factor_, w.place, w.weight).measures().transpose();
}

std::size_t Solver::whole_bytes() const {
  return bytes() + factor_->left_out_bytes();
}

std::size_t Solver::solution_bytes() const {
  return sizeof(double) * (std::size_t{factor_->interior()} + factor_->nodes()) +
         factor_->tiles().size() * (1 + sizeof(Index));
}

std::size_t Solver::bytes() const {
  return factor_->bytes() + node_of_.size() * sizeof(Index) + sizeof(double) * static_cast<std::size_t>(schur().size());
}

}  // namespace ts::field
