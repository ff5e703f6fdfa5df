#include "field/weights.h"

#include <algorithm>
#include <cmath>

#include "geometry/curvature.h"

namespace ts::field {
namespace {

constexpr std::size_t kGrain = 8192;
constexpr double kLeastCotangent = 1e-3;

template <class Weight>
Vec<double> each_edge(const mesh::Surface &surface, const Executor &executor, const Weight &weight) {
  Vec<double> w(surface.edge.size());
  executor.ranges(w.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) w[e] = weight(static_cast<mesh::Index>(e));
  });
  return w;
}

// Eq. 8 without the concave edges' share.
Vec<double> feature_weights(const mesh::Surface &surface, const WeightOptions &o, const Executor &executor) {
  const Vec<double> gauss = geometry::gaussian_curvature(surface, executor);
  return each_edge(surface, executor, [&](mesh::Index e) {
    const auto [i, j] = surface.edge[e];
    return surface.edge_length(e) / (std::abs(gauss[i] + gauss[j]) + o.gamma);
  });
}

Vec<double> paper_weights(const mesh::Surface &surface, const WeightOptions &o, const Executor &executor) {
  Vec<mesh::Vec3> normal = geometry::vertex_normals(surface, geometry::NormalWeight::angle, executor);
  if (o.inside_out)
    for (mesh::Vec3 &n : normal) n = -n;
  const Vec<std::uint8_t> concave = geometry::concave_by_edges(surface, normal, o.theta, executor);
  Vec<double> w = feature_weights(surface, o, executor);
  for (mesh::Index e = 0; e < w.size(); ++e)
    if (concave[surface.edge[e][0]] || concave[surface.edge[e][1]]) w[e] *= o.beta;
  return w;
}

}  // namespace

Vec<double> edge_weights(const mesh::Surface &surface, const Vec<double> &concavity, const WeightOptions &o,
                         const Executor &executor) {
  switch (o.scheme) {
    case Scheme::concavity:
      // The larger concavity of the two ends: an edge that only touches a seam crosses it as well.
      return each_edge(surface, executor, [&](mesh::Index e) {
        const auto [i, j] = surface.edge[e];
        return o.beta + (1 - o.beta) * std::exp(-std::max(concavity[i], concavity[j]) / o.c0);
      });
    case Scheme::paper: return paper_weights(surface, o, executor);
    case Scheme::cotangent: return geometry::cotangent_weights(surface, kLeastCotangent, executor);
    case Scheme::feature: return feature_weights(surface, o, executor);
    case Scheme::uniform: break;
  }
  return Vec<double>(surface.edge.size(), 1.0);
}

}  // namespace ts::field
