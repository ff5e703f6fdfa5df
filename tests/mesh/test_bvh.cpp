// Picking against brute force.
#include "shapes.h"

using namespace shapes;

namespace {

double distance_to(const Surface &s, Index f, const Vec3 &p) {
  // Closest of the plane's foot point, if inside, and the three sides.
  const Vec3 a = s.position[s.triangle[f][0]], b = s.position[s.triangle[f][1]], c = s.position[s.triangle[f][2]];
  const Vec3 n = (b - a).cross(c - a).normalized();
  const Vec3 foot = p - n.dot(p - a) * n;
  const auto inside = [&](const Vec3 &u, const Vec3 &v) { return n.dot((v - u).cross(foot - u)) >= 0; };
  if (inside(a, b) && inside(b, c) && inside(c, a)) return std::abs(n.dot(p - a));
  double least = HUGE_VAL;
  for (const auto &[u, v] : {std::pair(a, b), {b, c}, {c, a}}) {
    const double t = std::clamp((p - u).dot(v - u) / (v - u).squaredNorm(), 0.0, 1.0);
    least = std::min(least, (u + t * (v - u) - p).norm());
  }
  return least;
}

// Along the ray, infinity if it misses: by solving for the weights.
double hit(const Surface &s, Index f, const Vec3 &o, const Vec3 &d) {
  const Vec3 a = s.position[s.triangle[f][0]], b = s.position[s.triangle[f][1]], c = s.position[s.triangle[f][2]];
  Eigen::Matrix3d m;
  m << b - a, c - a, -d.normalized();
  const Vec3 x = m.inverse() * (o - a);
  return x[0] >= 0 && x[1] >= 0 && x[0] + x[1] <= 1 && x[2] >= 0 ? x[2] : HUGE_VAL;
}

void check_point(const Surface &s, const SurfacePoint &p) {
  REQUIRE(p.face < s.faces());
  CHECK(p.barycentric.sum() == doctest::Approx(1));
  CHECK(p.barycentric.minCoeff() >= -1e-12);
  Vec3 q(0, 0, 0);
  for (int k = 0; k < 3; ++k) q += p.barycentric[k] * s.position[s.triangle[p.face][static_cast<std::size_t>(k)]];
  CHECK((q - p.position).norm() < 1e-9);
}

}  // namespace

TEST_CASE("the nearest point is that of a search through all faces") {
  const Model m = model_of(both(hills(12), cube({4, 4, 5}, 3)));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-6, 18);
  for (int i = 0; i < 400; ++i) {
    const Vec3 p(place(random), place(random), place(random));
    double least = HUGE_VAL;
    for (Index f = 0; f < m.surface.faces(); ++f) least = std::min(least, distance_to(m.surface, f, p));
    const SurfacePoint at = m.nearest(p);
    check_point(m.surface, at);
    CHECK(at.distance == doctest::Approx(least));
    CHECK((at.position - p).norm() == doctest::Approx(at.distance));
  }
}

TEST_CASE("a point on the surface is found where it is") {
  const Model m = model_of(hills(12));
  for (Index v = 0; v < m.surface.vertices(); ++v) {
    const SurfacePoint at = m.nearest(m.surface.position[v]);
    CHECK(at.distance == 0);
    CHECK(at.nearest_vertex(m.surface) == v);
  }
}

TEST_CASE("the first hit of a ray is that of a search through all faces, from either side") {
  const Model m = model_of(both(hills(12), cube({4, 4, 5}, 3)));
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-6, 18), way(-1, 1);
  int hits = 0;
  for (int i = 0; i < 600; ++i) {
    const Vec3 o(place(random), place(random), place(random)), d(way(random), way(random), way(random));
    double least = HUGE_VAL;
    for (Index f = 0; f < m.surface.faces(); ++f) least = std::min(least, hit(m.surface, f, o, d));
    const auto at = m.raycast(o, 7 * d);
    REQUIRE(at.has_value() == (least < HUGE_VAL));
    if (!at) continue;
    ++hits;
    check_point(m.surface, *at);
    CHECK(at->distance == doctest::Approx(least));
    CHECK((o + at->distance * d.normalized() - at->position).norm() < 1e-9);
  }
  CHECK(hits > 50);
}

TEST_CASE("no ray slips through an edge or a vertex") {
  const Model m = model_of(hills(12));
  const Surface &s = m.surface;
  const Vec3 inside(0.3, 0.2, 1);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(0, 1);
  for (Index e = 0; e < s.edge.size(); ++e) {
    if (s.on_boundary[s.edge[e][0]] || s.on_boundary[s.edge[e][1]]) continue;
    for (const double t : {0.0, 0.5, 1.0, part(random)}) {
      const Vec3 p = s.position[s.edge[e][0]] * (1 - t) + s.position[s.edge[e][1]] * t;
      for (const Vec3 &d : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(inside), Vec3(-inside)}) {
        const auto at = m.raycast(p - 20 * d, d);
        REQUIRE(at.has_value());
        CHECK(at->distance <= 20 * d.norm() + 1e-9);
      }
    }
  }
}

TEST_CASE("rays along the axes, in the plane of a face, and from the surface itself") {
  const Model m = model_of(cube({0, 0, 0}, 10));
  CHECK(m.raycast({5, 5, 20}, {0, 0, -3})->distance == doctest::Approx(10));
  CHECK(m.raycast({5, 5, 5}, {0, 1, 0})->distance == doctest::Approx(5));
  CHECK_FALSE(m.raycast({5, 5, 20}, {0, 0, 1}).has_value());
  CHECK_FALSE(m.raycast({15, 5, 20}, {0, 0, -1}).has_value());
  CHECK(m.raycast({-5, 5, 0}, {1, 0, 0}).has_value());
  CHECK(m.raycast({5, 5, 10}, {0, 0, 1})->distance == 0);
  CHECK(m.raycast({5, 5, 20}, {0, 0, -1e-200})->distance == doctest::Approx(10));
  CHECK(m.raycast({5, 5, 20}, {0, 0, -1e200})->distance == doctest::Approx(10));
}

TEST_CASE("questions without an answer have none") {
  const Model m = model_of(hills(3));
  const double nan = std::nan("");
  CHECK(m.nearest({nan, 0, 0}).face == none);
  CHECK(m.nearest({HUGE_VAL, 0, 0}).face == none);
  CHECK_FALSE(m.raycast({nan, 0, 0}, {0, 0, 1}).has_value());
  CHECK_FALSE(m.raycast({0, 0, 0}, {0, nan, 1}).has_value());
  CHECK_FALSE(m.raycast({0, 0, 0}, {0, 0, 0}).has_value());
  CHECK(Bvh().nearest(Surface(), {0, 0, 0}).face == none);
  CHECK_FALSE(Bvh().raycast(Surface(), {0, 0, 0}, {0, 0, 1}).has_value());
  CHECK(m.nearest({1e300, 0, 0}).face != none);
}

TEST_CASE("faces of very unequal size and all in one place make a tree too") {
  RawMesh raw;
  for (Index i = 0; i < 3000; ++i) {
    const double r = std::pow(1.006, i);
    for (const Vec3 &p : {Vec3(0, 0, 1), Vec3(r, 0, 1 + r), Vec3(0, r, 1)}) raw.position.push_back(p);
    for (Index k = 0; k < 3; ++k) raw.corner.push_back(3 * i + k);
  }
  const Model m = model_of(raw);
  CHECK(m.nearest({0, 0, 0}).distance == doctest::Approx(1));
  CHECK(m.nearest({0, 0, 0}).face == 0);  // the lowest of those that all have that corner
}
