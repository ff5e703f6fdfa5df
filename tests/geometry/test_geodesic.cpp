#include <doctest/doctest.h>

#include "base/error.h"
#include "forms.h"
#include "geometry/geodesic.h"
#include "mesh/bvh.h"

using namespace ts;
using namespace ts::geometry;

namespace {

Vec<double> distances_from(const Surface &s, Index vertex, double limit = 1e9,
                           Marcher::Front front = Marcher::Front::round) {
  Marcher march(s);
  march.begin(front);
  march.start(vertex, 0);
  march.run([&](Index, double d) { return d <= limit; });
  Vec<double> d;
  for (Index v = 0; v < s.vertices(); ++v) d.push_back(march.distance(v));
  return d;
}

// Length of a way, and how far at most it is from `ideal`.
template <class Ideal>
std::pair<double, double> measure(const Surface &s, const mesh::SurfacePoint &a, const mesh::SurfacePoint &b,
                                  const Ideal &ideal) {
  Marcher march(s);
  double length = 0, off = 0;
  Vec3 at = a.position;
  Index face = a.face;
  for (const EdgeCrossing &c : geodesic(s, a, b, 1e9, march)) {
    const Vec3 p = (1 - c.t) * s.position[c.a] + c.t * s.position[c.b];
    length += (p - at).norm();
    off = std::max(off, ideal(p));
    at = p;
    face = s.vertex_faces[c.a].front();
  }
  CHECK(face < s.faces());
  return {length + (b.position - at).norm(), off};
}

}  // namespace

TEST_CASE("distances across faces are straight, where those along edges are not") {
  const Surface s = forms::plane(10, 10, 40, 40);
  const Vec<double> d = distances_from(s, 820);
  for (Index v = 0; v < s.vertices(); ++v) {
    const double straight = (s.position[v] - s.position[820]).norm();
    CHECK(d[v] == doctest::Approx(straight));
  }
  const Vec<double> flat = distances_from(s, 820, 1e9, Marcher::Front::straight);
  for (Index v = 0; v < s.vertices(); ++v) {
    const double straight = (s.position[v] - s.position[820]).norm();
    CHECK(flat[v] >= straight - 1e-9);
    CHECK(flat[v] < 1.06 * straight + 0.06);
  }
}

TEST_CASE("from a line the distances of a straight front are exact on a plane") {
  const Surface s = forms::plane(10, 10, 40, 40);
  Marcher march(s);
  march.begin(Marcher::Front::straight);
  for (Index v = 0; v < s.vertices(); ++v)  // the line x + y = 10, from one corner to the other
    if (const double off = std::abs(s.position[v].x() + s.position[v].y() - 10) / std::sqrt(2.0); off < 0.3)
      march.start(v, off);
  march.run([](Index, double) { return true; });
  for (Index v = 0; v < s.vertices(); ++v) {
    const double x = s.position[v].x(), y = s.position[v].y(), off = std::abs(x + y - 10) / std::sqrt(2.0);
    if (std::abs(x - y) + std::abs(x + y - 10) < 10) CHECK(march.distance(v) == doctest::Approx(off).epsilon(0.01));
  }
}

TEST_CASE("a march stops where it is told to") {
  const Surface s = forms::plane(10, 10, 40, 40);
  const Vec<double> d = distances_from(s, 820, 2);
  std::size_t known = 0;
  for (Index v = 0; v < s.vertices(); ++v) {
    const double straight = (s.position[v] - s.position[820]).norm();
    if (straight < 1.8) CHECK(d[v] < 2);
    if (straight > 2.8) CHECK(std::isinf(d[v]));
    known += std::isfinite(d[v]);
  }
  CHECK(known < s.vertices() / 4);
}

TEST_CASE("distances on a sphere are arcs") {
  const Surface s = forms::sphere(5, 5);
  const Vec<double> d = distances_from(s, 0);
  for (Index v = 0; v < s.vertices(); ++v) {
    const double arc = 5 * std::acos(std::clamp(s.position[v].dot(s.position[0]) / 25, -1.0, 1.0));
    CHECK(std::abs(d[v] - arc) < 0.04 * arc + 0.05);
  }
}

TEST_CASE("a geodesic on a plane is straight, on a tube a helix") {
  const Surface flat = forms::plane(10, 10, 40, 40);
  const mesh::Bvh flat_tree(flat);
  const Vec3 ends[][2] = {{{1, 1, 0}, {9, 8.3, 0}},
                          {{1.1, 5.03, 0}, {8, 5.03, 0}},
                          {{3.3, 9, 0}, {3.9, 1, 0}},
                          {{2, 2, 0}, {2.1, 2.2, 0}},
                          {{0, 0, 0}, {10, 3, 0}}};
  for (const auto &[a, b] : ends) {
    const Vec3 from = a, way = (b - a).normalized();
    const auto [length, off] = measure(flat, flat_tree.nearest(flat, a), flat_tree.nearest(flat, b),
                                       [&](const Vec3 &p) { return (p - from).cross(way).norm(); });
    CHECK(length < 1.005 * (b - a).norm() + 0.01);
    CHECK(off < 0.125);  // half an edge
  }
  const Surface tube = forms::tube(4, 12, 90, 60);
  const mesh::Bvh tree(tube);
  const auto on = [](double angle, double z) { return Vec3(4 * std::cos(angle), 4 * std::sin(angle), z); };
  const auto [length, off] =
      measure(tube, tree.nearest(tube, on(0.1, 1)), tree.nearest(tube, on(2.1, 9)), [&](const Vec3 &p) {
        const double x = 4 * (std::atan2(p.y(), p.x()) - 0.1), z = p.z() - 1;
        return std::abs(x * 1 - z * 1) / std::sqrt(2.0);  // 8 along for 8 around
      });
  CHECK(length == doctest::Approx(std::hypot(8.0, 8.0)).epsilon(0.01));
  CHECK(off < 0.15);
}

TEST_CASE("no way: another piece of the surface, or one too long") {
  Vec<Vec3> position;
  Vec<mesh::Triangle> triangle;
  for (const double x : {0.0, 20.0}) {
    const Surface part = forms::plane(4, 4, 8, 8);
    const Index first = static_cast<Index>(position.size());
    for (const Vec3 &p : part.position) position.push_back(p + Vec3(x, 0, 0));
    for (const auto &t : part.triangle) triangle.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  const Surface s = mesh::make_surface(position, triangle);
  const mesh::Bvh tree(s);
  Marcher march(s);
  const auto fault = [&](const Vec3 &a, const Vec3 &b, double limit) {
    try {
      geodesic(s, tree.nearest(s, a), tree.nearest(s, b), limit, march);
    } catch (const Error &e) {
      return e.fault();
    }
    return Fault::internal;
  };
  CHECK(fault({1, 1, 0}, {22, 1, 0}, 1e9) == Fault::not_found);
  CHECK(fault({1, 1, 0}, {3, 3, 0}, 1) == Fault::not_found);
  CHECK(fault({1, 1, 0}, {3, 3, 0}, 10) == Fault::internal);  // there is one
}
