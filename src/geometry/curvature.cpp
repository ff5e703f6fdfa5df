#include "geometry/curvature.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ts::geometry {
namespace {

constexpr std::size_t kCurvatureGrain = 2048;

using Tensor = std::array<double, 6>;  // xx, xy, xz, yy, yz, zz

// The symmetric S in the plane of the face that best maps its edges to the differences of the normals along them.
Tensor face_shape(const std::array<Vec3, 3> &p, const std::array<Vec3, 3> &n) {
  const Vec3 e0 = p[1] - p[0], cross = e0.cross(p[2] - p[0]);
  const double length = e0.norm(), twice = cross.norm();
  if (!(length > 0) || !(twice > 0)) return {};
  const Vec3 s = e0 / length, t = (cross / twice).cross(s);
  double xx = 0, xy = 0, yy = 0, xp = 0, mix = 0, yq = 0;
  for (int k = 0; k < 3; ++k) {
    const Vec3 e = p[(k + 1) % 3] - p[k], d = n[(k + 1) % 3] - n[k];
    const double x = e.dot(s), y = e.dot(t), u = d.dot(s), v = d.dot(t);
    xx += x * x, xy += x * y, yy += y * y;
    xp += x * u, mix += y * u + x * v, yq += y * v;
  }
  // Normal equations: a xx + b xy = xp; a xy + b (xx + yy) + c xy = mix; b xy + c yy = yq.
  const double schur = xx + yy - xy * xy / xx - xy * xy / yy;
  if (!(schur > 0)) return {};
  const double b = (mix - xy * xp / xx - xy * yq / yy) / schur, a = (xp - b * xy) / xx, c = (yq - b * xy) / yy;
  const Vec3 ss = a * s + b * t, tt = b * s + c * t;  // S = ss s^T + tt t^T
  return {ss[0] * s[0] + tt[0] * t[0], ss[0] * s[1] + tt[0] * t[1], ss[0] * s[2] + tt[0] * t[2],
          ss[1] * s[1] + tt[1] * t[1], ss[1] * s[2] + tt[1] * t[2], ss[2] * s[2] + tt[2] * t[2]};
}

Vec3 times(const Tensor &m, const Vec3 &v) {
  return {m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[1] * v[0] + m[3] * v[1] + m[4] * v[2],
          m[2] * v[0] + m[4] * v[1] + m[5] * v[2]};
}

}  // namespace

Principal principal_curvatures(const Surface &surface, const Vec<Vec3> &position, const Vec<Vec3> &normal,
                               const Executor &executor) {
  Vec<Tensor> shape(surface.faces());
  executor.ranges(surface.faces(), kCurvatureGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const auto &t = surface.triangle[f];
      shape[f] =
          face_shape({position[t[0]], position[t[1]], position[t[2]]}, {normal[t[0]], normal[t[1]], normal[t[2]]});
    }
  });
  Principal k;
  k.least.assign(surface.vertices(), 0);
  k.greatest.assign(surface.vertices(), 0);
  executor.ranges(surface.vertices(), kCurvatureGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Tensor sum{};
      double area = 0;
      for (const Index f : surface.vertex_faces[v]) {
        for (std::size_t i = 0; i < 6; ++i) sum[i] += surface.face_area[f] * shape[f][i];
        area += surface.face_area[f];
      }
      if (!(area > 0) || normal[v].squaredNorm() < 0.5) continue;
      const Vec3 s = normal[v].unitOrthogonal(), t = normal[v].cross(s);
      const double a = s.dot(times(sum, s)) / area, b = s.dot(times(sum, t)) / area, c = t.dot(times(sum, t)) / area;
      const double mean = (a + c) / 2, half = std::sqrt((a - c) * (a - c) / 4 + b * b);
      k.least[v] = mean - half;
      k.greatest[v] = mean + half;
    }
  });
  return k;
}

Vec<double> gaussian_curvature(const Surface &surface, const Executor &executor) {
  using std::numbers::pi;
  Vec<double> curvature(surface.vertices(), 0);
  executor.ranges(surface.vertices(), kCurvatureGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      double defect = surface.on_boundary[v] ? pi : 2 * pi;
      for (const Index f : surface.vertex_faces[v]) {
        const auto &t = surface.triangle[f];
        const int k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
        const Vec3 a = surface.position[t[(k + 1) % 3]] - surface.position[v];
        const Vec3 b = surface.position[t[(k + 2) % 3]] - surface.position[v];
        defect -= std::atan2(a.cross(b).norm(), a.dot(b));
      }
      if (surface.vertex_area[v] > 0) curvature[v] = defect / surface.vertex_area[v];
    }
  });
  return curvature;
}

Vec<std::uint8_t> concave_by_edges(const Surface &surface, const Vec<Vec3> &normal, double theta,
                                   const Executor &executor) {
  Vec<std::uint8_t> concave(surface.vertices(), 0);
  executor.ranges(surface.vertices(), kCurvatureGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      for (const Index e : surface.vertex_edges[v]) {
        const Index w = surface.other_end(e, static_cast<Index>(v));
        const Vec3 d = surface.position[v] - surface.position[w];
        if (d.dot(normal[w] - normal[v]) > theta * d.norm()) {
          concave[v] = 1;
          break;
        }
      }
  });
  return concave;
}

}  // namespace ts::geometry
