#include "geometry/concavity.h"

#include <algorithm>
#include <cmath>

namespace ts::geometry {
namespace {

constexpr std::size_t kConcavityGrain = 4096;
// Slivers would tie their ends together and cost most of the iterations.
constexpr double kLeastCotangent = 0.01, kMostCotangent = 5;

// How far the faces beside half-edge h bend towards each other (radians) over the distance of their middles across the
// edge, a third of the sum of their heights; 0 if they bend away. `side` -1: the other way round.
double bend(const Surface &s, const Vec<Vec3> &position, const Vec<Vec3> &normal, Index h, double side) {
  const Index f = mesh::face_of(h), g = mesh::face_of(s.twin[h]);
  const Vec3 along = position[s.to(h)] - position[s.from(h)];
  const double length = along.norm();
  const double across = (normal[f].norm() + normal[g].norm()) / (3 * length);
  if (!(length > 0) || !(across > 0)) return 0;
  const double sine = normal[g].cross(normal[f]).dot(along) / length;
  if (side * sine < 0) return 0;  // half of all edges: no need of the angle
  return std::max(0.0, side * (std::atan2(sine, normal[f].dot(normal[g])) / across));
}

Vec<double> edge_concavity(const Surface &surface, const Vec<Vec3> &position, bool inside_out,
                           const Executor &executor) {
  Vec<Vec3> normal(surface.faces());  // twice the area long
  executor.ranges(surface.faces(), kConcavityGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const auto &[a, b, c] = surface.triangle[f];
      normal[f] = (position[b] - position[a]).cross(position[c] - position[a]);
    }
  });
  Vec<double> edge(surface.edge.size(), 0);
  executor.ranges(surface.twin.size(), kConcavityGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t h = begin; h < end; ++h)
      if (surface.twin[h] != mesh::none && h < surface.twin[h])
        edge[surface.edge_of[h]] = bend(surface, position, normal, static_cast<Index>(h), inside_out ? -1 : 1);
  });
  return edge;
}

Vec<double> valley_curvature(const Surface &surface, const Vec<Vec3> &position, const Vec<Vec3> &normal,
                             bool inside_out, const Executor &executor) {
  Principal k = principal_curvatures(surface, position, normal, executor);
  Vec<double> valley = std::move(inside_out ? k.greatest : k.least);
  for (double &x : valley) x = std::max(0.0, inside_out ? x : -x);
  return valley;
}

// What smoothing takes off the sum of the edge lengths and off the area is what noise had added.
void compare(const Surface &surface, const Vec<Vec3> &smoothed, Concavity &c) {
  double length = 0, area = 0;
  for (const auto &[a, b] : surface.edge) length += (smoothed[a] - smoothed[b]).norm();
  for (const auto &[i, j, k] : surface.triangle)
    area += (smoothed[j] - smoothed[i]).cross(smoothed[k] - smoothed[i]).norm() / 2;
  if (length > 0) c.lengthened = std::max(1.0, surface.mean_edge * static_cast<double>(surface.edge.size()) / length);
  if (area > 0) c.widened = std::max(1.0, surface.area / area);
}

}  // namespace

double noise_gauge(const Surface &surface, const Vec<Vec3> &normal, const Executor &executor) {
  const std::size_t n = surface.vertices();
  Vec<double> offset(n, 0), residual(n, 0);
  executor.ranges(n, kConcavityGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const auto ring = surface.vertex_edges[v];
      if (ring.empty()) continue;
      Vec3 mean = Vec3::Zero();
      for (const Index e : ring) mean += surface.position[surface.other_end(e, static_cast<Index>(v))];
      offset[v] = (surface.position[v] - mean / static_cast<double>(ring.size())).dot(normal[v]);
    }
  });
  executor.ranges(n, kConcavityGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const auto ring = surface.vertex_edges[v];
      if (ring.empty()) continue;
      double mean = 0;
      for (const Index e : ring) mean += offset[surface.other_end(e, static_cast<Index>(v))];
      residual[v] = std::abs(offset[v] - mean / static_cast<double>(ring.size()));
    }
  });
  if (n == 0 || !(surface.mean_edge > 0)) return 0;
  const auto middle = residual.begin() + static_cast<std::ptrdiff_t>(n / 2);
  std::nth_element(residual.begin(), middle, residual.end());
  return *middle / surface.mean_edge;
}

double presmoothing(double gauge, double mean_edge) {
  // Noise of g edges of length e leaves about g e^2 / r^3 in curvature at a radius r: for the same remainder r grows as
  // e^(2/3). The line in g was chosen on scans with edges of .85.
  constexpr double kEdge = 0.85, kMost = 1.5;
  return gauge < 0.06 ? 0
                      : std::min(kMost, std::min(1.0, 2 * (gauge - 0.06)) * std::cbrt(std::pow(mean_edge / kEdge, 2)));
}

Concavity concavity(const Surface &surface, double normal_radius, bool inside_out, const Executor &executor) {
  Concavity c;
  c.cotangent = cotangent_weights(surface, kLeastCotangent, executor);
  Graph graph = make_graph(surface, c.cotangent, executor, kMostCotangent);
  Vec<Vec3> normal = vertex_normals(surface, NormalWeight::angle, executor);
  const double pre = presmoothing(noise_gauge(surface, normal, executor), surface.mean_edge);
  Vec<Vec3> smoothed;
  if (pre > 0) {
    smoothed = smooth(surface, graph, pre, surface.position, executor);
    normal = vertex_normals(surface, smoothed, NormalWeight::angle, executor);
  }
  const Vec<Vec3> &position = pre > 0 ? smoothed : surface.position;
  normal = smoothed_normals(surface, normal, graph, normal_radius, executor);
  graph = {};
  c.vertex = valley_curvature(surface, position, normal, inside_out, executor);
  normal = {};
  if (pre > 0) compare(surface, smoothed, c);
  c.edge = edge_concavity(surface, position, inside_out, executor);
  return c;
}

}  // namespace ts::geometry
