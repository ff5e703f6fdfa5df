#include "bench/bench_problem.h"

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "field/weights.h"
#include "geometry/concavity.h"
#include "tooth/options.h"

namespace ts::bench {
namespace {

constexpr double kAlpha = 1e8;  // the paper's penalty

using mesh::Index;
using mesh::Surface;

}  // namespace

Problem make_problem(const Surface &surface, const features::Features &features) {
  const tooth::Options o = tooth::default_options();
  const Executor executor(0);
  Problem problem;
  problem.surface = &surface;
  field::Sites sites;
  sites.groups = static_cast<Index>(features.groups.size());
  for (Index g = 0; g < sites.groups; ++g)
    for (const auto &point : features.groups[g].points) {
      sites.point.push_back(point.vertex);
      sites.group.push_back(g);
    }
  const geometry::Concavity valleys = geometry::concavity(surface, o.normal_radius, features.inside_out, executor);
  problem.weight = field::edge_weights(surface, valleys.vertex,
                                       {o.weights, o.beta, o.gamma, o.theta, o.c0, features.inside_out}, executor);
  problem.nodes = field::make_nodes(surface, sites, {o.seed_radius, true, o.gingiva_distance, valleys.lengthened});

  std::vector<bool> used(surface.components, false);
  for (Index v = 0; v < surface.vertices(); ++v)
    if (problem.nodes.of_vertex[v] != mesh::none && surface.vertex_component[v] != mesh::none)
      used[surface.vertex_component[v]] = true;
  problem.unknown.assign(surface.vertices(), -1);
  for (Index v = 0; v < surface.vertices(); ++v)
    if (const Index piece = surface.vertex_component[v]; piece != mesh::none && used[piece])
      problem.unknown[v] = problem.unknowns++;
  return problem;
}

ClickSystem assemble_click(const Problem &problem, Index group) {
  const Surface &surface = *problem.surface;
  const auto n = static_cast<std::size_t>(problem.unknowns);
  ClickSystem system;
  LowerMatrix &m = system.matrix;
  m.n = problem.unknowns;
  m.start.assign(n + 1, 0);
  system.right.assign(n, 0);
  for (std::size_t j = 0; j < n; ++j) m.start[j + 1] = 1;
  for (const mesh::Edge &e : surface.edge)
    if (const int j = problem.unknown[e[0]]; j >= 0) ++m.start[static_cast<std::size_t>(j) + 1];
  std::partial_sum(m.start.begin(), m.start.end(), m.start.begin());
  m.row.resize(static_cast<std::size_t>(m.start.back()));
  m.value.resize(m.row.size());
  std::vector<int> fill(m.start.begin(), m.start.end() - 1);
  const auto put = [&](int row, int column, double value) {
    const auto k = static_cast<std::size_t>(fill[static_cast<std::size_t>(column)]++);
    m.row[k] = row;
    m.value[k] = value;
  };
  for (int j = 0; j < m.n; ++j) put(j, j, 0);
  const auto diagonal = [&](int j) -> double & {
    return m.value[static_cast<std::size_t>(m.start[static_cast<std::size_t>(j)])];
  };
  // Edges come in lexicographic order and places rise with the vertices: each column is in order as it fills.
  for (Index e = 0; e < surface.edge.size(); ++e) {
    const int i = problem.unknown[surface.edge[e][1]], j = problem.unknown[surface.edge[e][0]];
    if (j < 0) continue;
    put(i, j, -problem.weight[e]);
    diagonal(i) += problem.weight[e];
    diagonal(j) += problem.weight[e];
  }
  for (Index v = 0; v < surface.vertices(); ++v) {
    const Index node = problem.nodes.of_vertex[v];
    const int j = problem.unknown[v];
    if (node == mesh::none || j < 0) continue;
    diagonal(j) += kAlpha;
    if (problem.nodes.group[node] == group) system.right[static_cast<std::size_t>(j)] = kAlpha;
  }
  return system;
}

LowerMatrix assemble_shared(const Problem &problem) {
  const Surface &surface = *problem.surface;
  std::vector<int> place(surface.vertices(), -1);
  int n = 0;
  for (Index v = 0; v < surface.vertices(); ++v)
    if (problem.unknown[v] >= 0 && problem.nodes.of_vertex[v] == mesh::none) place[v] = n++;
  const int interior = n;
  n += static_cast<int>(problem.nodes.size());
  for (Index v = 0; v < surface.vertices(); ++v)
    if (const Index node = problem.nodes.of_vertex[v]; node != mesh::none) place[v] = interior + static_cast<int>(node);
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> diagonal(static_cast<std::size_t>(n), 0);
  for (Index e = 0; e < surface.edge.size(); ++e) {
    const int i = place[surface.edge[e][0]], j = place[surface.edge[e][1]];
    if (i < 0 || j < 0 || i == j) continue;
    entries.emplace_back(std::max(i, j), std::min(i, j), -problem.weight[e]);
    diagonal[static_cast<std::size_t>(i)] += problem.weight[e];
    diagonal[static_cast<std::size_t>(j)] += problem.weight[e];
  }
  const double sigma = std::accumulate(diagonal.begin(), diagonal.end(), 0.0) / n;
  for (int j = 0; j < n; ++j)
    entries.emplace_back(j, j, diagonal[static_cast<std::size_t>(j)] + (j >= interior ? sigma : 0));
  Eigen::SparseMatrix<double> sparse(n, n);
  sparse.setFromTriplets(entries.begin(), entries.end());
  LowerMatrix m;
  m.n = n;
  m.start.assign(sparse.outerIndexPtr(), sparse.outerIndexPtr() + n + 1);
  m.row.assign(sparse.innerIndexPtr(), sparse.innerIndexPtr() + sparse.nonZeros());
  m.value.assign(sparse.valuePtr(), sparse.valuePtr() + sparse.nonZeros());
  return m;
}

double difference(const Problem &problem, const field::Solver &solver, Index group, const std::vector<double> &u) {
  std::vector<double> held;
  for (const Index g : problem.nodes.group) held.push_back(g == group ? 1 : 0);
  const Eigen::VectorXd at_nodes = solver.solve_nodes(held, kAlpha);
  const Vec<double> ours = solver.extend_to_all(at_nodes);
  double worst = 0;
  for (std::size_t v = 0; v < problem.unknown.size(); ++v)
    if (problem.unknown[v] >= 0)
      worst = std::max(worst, std::abs(ours[v] - u[static_cast<std::size_t>(problem.unknown[v])]));
  return worst;
}

}  // namespace ts::bench
