#include "geometry/normals.h"

#include <cmath>

namespace ts::geometry {
namespace {

constexpr std::size_t kNormalsGrain = 4096;

Vec3 unit(const Vec3 &v) {
  const double length = v.norm();
  return length > 0 ? Vec3(v / length) : Vec3(0, 0, 0);
}

}  // namespace

Vec<Vec3> vertex_normals(const Surface &surface, NormalWeight weight, const Executor &executor) {
  return vertex_normals(surface, surface.position, weight, executor);
}

Vec<Vec3> vertex_normals(const Surface &surface, const Vec<Vec3> &position, NormalWeight weight,
                         const Executor &executor) {
  Vec<Vec3> twice(surface.faces());  // unit normal times twice the area
  executor.ranges(surface.faces(), kNormalsGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const auto &t = surface.triangle[f];
      twice[f] = (position[t[1]] - position[t[0]]).cross(position[t[2]] - position[t[0]]);
    }
  });
  const auto share = [&](Index f, Index v) -> Vec3 {
    if (weight == NormalWeight::area) return twice[f];
    const auto &t = surface.triangle[f];
    const int k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
    const Vec3 a = position[t[(k + 1) % 3]] - position[v], b = position[t[(k + 2) % 3]] - position[v];
    const double sine = twice[f].norm();
    return sine > 0 ? Vec3(twice[f] * (std::atan2(sine, a.dot(b)) / sine)) : Vec3(0, 0, 0);
  };
  Vec<Vec3> normal(surface.vertices());
  executor.ranges(surface.vertices(), kNormalsGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Vec3 sum = Vec3::Zero();
      for (const Index f : surface.vertex_faces[v]) sum += share(f, static_cast<Index>(v));
      normal[v] = unit(sum);
    }
  });
  return normal;
}

Vec<Vec3> smoothed_normals(const Surface &surface, const Vec<Vec3> &normal, const Graph &cotangent, double radius,
                           const Executor &executor) {
  if (radius <= 0) return normal;
  Vec<Vec3> smoothed = smooth(surface, cotangent, radius, normal, executor);
  executor.ranges(smoothed.size(), kNormalsGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) smoothed[v] = unit(smoothed[v]);
  });
  return smoothed;
}

}  // namespace ts::geometry
