#include "geometry/laplacian.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ts::geometry {
namespace {

constexpr std::size_t kLaplacianGrain = 4096;

Vec3 safe_ratio(const Vec3 &a, const Vec3 &b) {
  Vec3 r;
  for (int k = 0; k < 3; ++k) r[k] = b[k] > 0 ? a[k] / b[k] : 0;
  return r;
}

}  // namespace

Graph make_graph(const Surface &surface, const Vec<double> &edge_weight, const Executor &executor, double most) {
  Graph g;
  g.start = surface.vertex_edges.start;
  g.neighbour.resize(surface.vertex_edges.item.size());
  g.weight.resize(g.neighbour.size());
  executor.ranges(surface.vertices(), kLaplacianGrain, [&](std::size_t begin, std::size_t end) {
    for (Index v = static_cast<Index>(begin); v < end; ++v)
      for (Index k = g.start[v]; k < g.start[v + 1]; ++k) {
        const Index e = surface.vertex_edges.item[k];
        g.neighbour[k] = surface.other_end(e, v);
        g.weight[k] = std::min(edge_weight[e], most);
      }
  });
  return g;
}

Vec<double> cotangent_weights(const Surface &surface, double least, const Executor &executor) {
  // Half the cotangent of the angle opposite to half-edge h.
  const auto half_cotangent = [&](Index h) {
    const auto &t = surface.triangle[mesh::face_of(h)];
    const Index k = h % 3;
    const Vec3 &c = surface.position[t[(k + 2) % 3]];
    const Vec3 a = surface.position[t[k]] - c, b = surface.position[t[(k + 1) % 3]] - c;
    const double sine = a.cross(b).norm();
    return a.dot(b) / std::max(sine, std::numeric_limits<double>::min()) / 2;
  };
  const auto clamped = [&](double w) { return std::isfinite(w) ? std::max(w, least) : least; };
  Vec<double> weight(surface.edge.size(), 0);
  executor.ranges(surface.twin.size(), kLaplacianGrain, [&](std::size_t begin, std::size_t end) {
    for (Index h = static_cast<Index>(begin); h < end; ++h)
      if (const Index g = surface.twin[h]; g != mesh::none && h < g)
        weight[surface.edge_of[h]] = clamped(half_cotangent(h) + half_cotangent(g));
  });
  // Edges of a rim; where faces meet that are not joined, several half-edges without a twin are on one.
  Vec<Index> rim;
  for (Index h = 0; h < surface.twin.size(); ++h)
    if (surface.twin[h] == mesh::none) rim.push_back(h);
  for (const Index h : rim) weight[surface.edge_of[h]] += half_cotangent(h);
  Vec<Index> edges;
  for (const Index h : rim) edges.push_back(surface.edge_of[h]);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const Index e : edges) weight[e] = clamped(weight[e]);
  return weight;
}

Vec<Vec3> smooth(const Surface &surface, const Graph &graph, double radius, const Vec<Vec3> &x0,
                 const Executor &executor) {
  const std::size_t n = surface.vertices();
  const double r2 = radius * radius;
  const auto vertices = [&](const auto &body) {
    executor.ranges(n, kLaplacianGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) body(i);
    });
  };
  // The sum of what `body` gives for each vertex.
  Vec<Vec3> part((n + kLaplacianGrain - 1) / kLaplacianGrain);
  const auto total = [&](const auto &body) -> Vec3 {
    executor.ranges(n, kLaplacianGrain, [&](std::size_t begin, std::size_t end) {
      Vec3 sum = Vec3::Zero();
      for (std::size_t i = begin; i < end; ++i) sum += body(i);
      part[begin / kLaplacianGrain] = sum;
    });
    Vec3 sum = Vec3::Zero();
    for (const Vec3 &p : part) sum += p;
    return sum;
  };
  Vec<double> diagonal(n);
  vertices([&](std::size_t i) {
    double sum = 0;
    for (Index k = graph.start[i]; k < graph.start[i + 1]; ++k) sum += graph.weight[k];
    diagonal[i] = surface.vertex_area[i] + r2 * sum;
  });
  const auto product = [&](const Vec<Vec3> &x, std::size_t i) -> Vec3 {
    Vec3 sum = Vec3::Zero();
    for (Index k = graph.start[i]; k < graph.start[i + 1]; ++k) sum += graph.weight[k] * x[graph.neighbour[k]];
    return diagonal[i] * x[i] - r2 * sum;
  };

  Vec<Vec3> x = x0, residual(n), p(n), ap(n);
  // The residual by the preconditioner: cheaper to divide again than to keep.
  const auto scaled = [&](std::size_t i) { return diagonal[i] > 0 ? Vec3(residual[i] / diagonal[i]) : Vec3(0, 0, 0); };
  Vec3 rho = total([&](std::size_t i) -> Vec3 {
    residual[i] = surface.vertex_area[i] * x0[i] - product(x0, i);
    p[i] = scaled(i);
    return residual[i].cwiseProduct(p[i]);
  });
  const Vec3 goal = rho * 1e-8;  // 1e-4 of the first residual: what is left is on single slivers
  for (int iteration = 0; iteration < 500 && (rho.array() > goal.array()).any(); ++iteration) {
    const Vec3 curvature = total([&](std::size_t i) -> Vec3 {
      ap[i] = product(p, i);
      return p[i].cwiseProduct(ap[i]);
    });
    const Vec3 alpha = safe_ratio(rho, curvature);
    const Vec3 next = total([&](std::size_t i) -> Vec3 {
      x[i] += alpha.cwiseProduct(p[i]);
      residual[i] -= alpha.cwiseProduct(ap[i]);
      return residual[i].cwiseProduct(scaled(i));
    });
    const Vec3 beta = safe_ratio(next, rho);
    rho = next;
    vertices([&](std::size_t i) { p[i] = scaled(i) + beta.cwiseProduct(p[i]); });
  }
  return x;
}

}  // namespace ts::geometry
