#include "geometry/laplacian.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ts::geometry {
namespace {

constexpr std::size_t kGrain = 4096;

Vec3 dots(const Vec<Vec3> &a, const Vec<Vec3> &b, const Executor &executor) {
  Vec<Vec3> part((a.size() + kGrain - 1) / kGrain, Vec3::Zero());
  executor.ranges(a.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = begin; i < end; ++i) sum += a[i].cwiseProduct(b[i]);
    part[begin / kGrain] = sum;
  });
  Vec3 sum = Vec3::Zero();
  for (const Vec3 &p : part) sum += p;
  return sum;
}

Vec3 safe_ratio(const Vec3 &a, const Vec3 &b) {
  Vec3 r;
  for (int k = 0; k < 3; ++k) r[k] = b[k] > 0 ? a[k] / b[k] : 0;
  return r;
}

}  // namespace

Graph make_graph(const Surface &surface, const Vec<double> &edge_weight) {
  Graph g;
  g.start = surface.vertex_edges.start;
  g.neighbour.resize(surface.vertex_edges.item.size());
  g.weight.resize(g.neighbour.size());
  for (Index v = 0; v < surface.vertices(); ++v)
    for (Index k = g.start[v]; k < g.start[v + 1]; ++k) {
      const Index e = surface.vertex_edges.item[k];
      g.neighbour[k] = surface.other_end(e, v);
      g.weight[k] = edge_weight[e];
    }
  return g;
}

Vec<double> cotangent_weights(const Surface &surface, double least, const Executor &executor) {
  Vec<double> corner(3 * surface.faces());  // cotangent of the angle opposite to half-edge 3 f + k
  executor.ranges(surface.faces(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto &t = surface.triangle[f];
        const Vec3 &c = surface.position[t[(k + 2) % 3]];
        const Vec3 a = surface.position[t[k]] - c, b = surface.position[t[(k + 1) % 3]] - c;
        const double sine = a.cross(b).norm();
        corner[3 * f + k] = a.dot(b) / std::max(sine, std::numeric_limits<double>::min());
      }
  });
  Vec<double> weight(surface.edge.size(), 0);
  for (std::size_t h = 0; h < corner.size(); ++h) weight[surface.edge_of[h]] += corner[h] / 2;
  for (double &w : weight) w = std::isfinite(w) ? std::max(w, least) : least;
  return weight;
}

Vec<Vec3> smooth(const Surface &surface, const Graph &graph, double radius, const Vec<Vec3> &x0,
                 const Executor &executor) {
  const std::size_t n = surface.vertices();
  const double r2 = radius * radius;
  Vec<double> diagonal(n);
  const auto vertices = [&](const auto &body) {
    executor.ranges(n, kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) body(i);
    });
  };
  vertices([&](std::size_t i) {
    double sum = 0;
    for (Index k = graph.start[i]; k < graph.start[i + 1]; ++k) sum += graph.weight[k];
    diagonal[i] = surface.vertex_area[i] + r2 * sum;
  });
  const auto product = [&](const Vec<Vec3> &x, Vec<Vec3> &y) {
    vertices([&](std::size_t i) {
      Vec3 sum = Vec3::Zero();
      for (Index k = graph.start[i]; k < graph.start[i + 1]; ++k) sum += graph.weight[k] * x[graph.neighbour[k]];
      y[i] = diagonal[i] * x[i] - r2 * sum;
    });
  };

  Vec<Vec3> x = x0, residual(n), z(n), p(n), ap(n);
  product(x, ap);
  vertices([&](std::size_t i) {
    residual[i] = surface.vertex_area[i] * x0[i] - ap[i];
    z[i] = diagonal[i] > 0 ? Vec3(residual[i] / diagonal[i]) : Vec3(0, 0, 0);
    p[i] = z[i];
  });
  Vec3 rho = dots(residual, z, executor);
  const Vec3 goal = rho * 1e-8;  // 1e-4 of the first residual: what is left is on single slivers
  for (int iteration = 0; iteration < 500 && (rho.array() > goal.array()).any(); ++iteration) {
    product(p, ap);
    const Vec3 alpha = safe_ratio(rho, dots(p, ap, executor));
    vertices([&](std::size_t i) {
      x[i] += alpha.cwiseProduct(p[i]);
      residual[i] -= alpha.cwiseProduct(ap[i]);
      z[i] = diagonal[i] > 0 ? Vec3(residual[i] / diagonal[i]) : Vec3(0, 0, 0);
    });
    const Vec3 next = dots(residual, z, executor), beta = safe_ratio(next, rho);
    rho = next;
    vertices([&](std::size_t i) { p[i] = z[i] + beta.cwiseProduct(p[i]); });
  }
  return x;
}

}  // namespace ts::geometry
