#include "geometry/concavity.h"

#include <algorithm>
#include <cmath>

namespace ts::geometry {
namespace {

constexpr std::size_t kGrain = 4096;
// Slivers would tie their ends together and cost most of the iterations.
constexpr double kLeastCotangent = 0.01, kMostCotangent = 5;

}  // namespace

double noise_gauge(const Surface &surface, const Vec<Vec3> &normal, const Executor &executor) {
  const std::size_t n = surface.vertices();
  Vec<double> offset(n, 0), residual(n, 0);
  executor.ranges(n, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const auto ring = surface.vertex_edges[v];
      if (ring.empty()) continue;
      Vec3 mean = Vec3::Zero();
      for (const Index e : ring) mean += surface.position[surface.other_end(e, static_cast<Index>(v))];
      offset[v] = (surface.position[v] - mean / static_cast<double>(ring.size())).dot(normal[v]);
    }
  });
  executor.ranges(n, kGrain, [&](std::size_t begin, std::size_t end) {
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

double presmoothing(double gauge) {
  return gauge < 0.06 ? 0 : std::min(1.0, 2 * (gauge - 0.06));
}

Vec<double> concavity(const Surface &surface, double normal_radius, bool inside_out, const Executor &executor) {
  Vec<double> weight = cotangent_weights(surface, kLeastCotangent, executor);
  for (double &w : weight) w = std::min(w, kMostCotangent);
  const Graph cotangent = make_graph(surface, weight);
  Vec<Vec3> normal = vertex_normals(surface, NormalWeight::angle, executor);
  const double pre = presmoothing(noise_gauge(surface, normal, executor));
  Vec<Vec3> smoothed;
  if (pre > 0) {
    smoothed = smooth(surface, cotangent, pre, surface.position, executor);
    normal = vertex_normals(surface, smoothed, NormalWeight::angle, executor);
  }
  const Vec<Vec3> &position = pre > 0 ? smoothed : surface.position;
  normal = smoothed_normals(surface, normal, cotangent, normal_radius, executor);
  Principal k = principal_curvatures(surface, position, normal, executor);
  Vec<double> c = std::move(inside_out ? k.greatest : k.least);
  for (double &x : c) x = std::max(0.0, inside_out ? x : -x);
  return c;
}

}  // namespace ts::geometry
