#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "features/detect.h"

using namespace ts;
using features::DetectOptions;
using features::Features;
using mesh::Surface;
using mesh::Vec3;

namespace {

// Crowns along an arc of radius 30 on a rounded alveolar ridge: a height field over the arc's own coordinates.
struct Row {
  Vec<double> width;  // of the teeth, mm; negative: a gap of that width
  double radius = 30, spacing = 0.4;

  double length() const {
    double sum = 0;
    for (const double w : width) sum += std::abs(w);
    return sum;
  }
  Vec3 point(double s, double t, double h) const {
    const double a = (s - length() / 2) / radius + std::numbers::pi / 2;
    return {(radius + t) * std::cos(a), (radius + t) * std::sin(a), h};
  }
  double height(double s, double t) const {
    const double ridge = -7 - 0.06 * t * t;
    double from = 0, h = ridge;
    for (const double w : width) {
      const double to = from + std::abs(w), half = std::abs(w) / 2, x = (s - (from + to) / 2) / half;
      // posterior crowns: as wide across as along, with cusps at both sides; anterior ones: an edge
      const double across = half > 3.6 ? half : 2.6, y = t / across,
                   rim = std::pow(std::abs(x), 4) + std::pow(std::abs(y), 4);
      if (w > 0 && rim < 1) {
        const double body = 7 * std::pow(1 - rim, 0.3);
        const double top = half > 3.6 ? 0.9 * (std::pow(std::sin(2.2 * y), 2) - 0.6 * x * x) : -1.2 * y * y;
        h = std::max(h, ridge + body + top);
      }
      from = to;
    }
    return h;
  }
  Surface surface() const {
    const double l = length(), margin = 5;
    const int n = static_cast<int>((l + 2 * margin) / spacing), m = static_cast<int>(18 / spacing);
    Vec<Vec3> p;
    Vec<mesh::Triangle> f;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= m; ++j) {
        const double s = -margin + (l + 2 * margin) * i / n, t = -9 + 18.0 * j / m;
        p.push_back(point(s, t, height(s, t)));
      }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < m; ++j) {
        const auto a = static_cast<mesh::Index>(i * (m + 1) + j), b = a + 1, c = a + m + 1, d = c + 1;
        f.push_back({a, d, b});  // s runs from right to left seen from above, t outwards
        f.push_back({a, c, d});
      }
    Surface result = mesh::make_surface(p, f);
    if (result.face_normal[0].z() < 0) {
      for (mesh::Triangle &t : f) std::swap(t[1], t[2]);
      result = mesh::make_surface(p, f);
    }
    return result;
  }
};

const Row whole{{10, 11, 7.5, 7.3, 7.8, 6.6, 8.6, 8.6, 6.6, 7.8, 7.3, 7.5, 11, 10}};

Features find(const Surface &s, const DetectOptions &o = {}, unsigned threads = 1) {
  return features::detect(s, o, Executor(threads), {});
}

// Each tooth's extent holds exactly one group, with all its points inside it.
void check_groups(const Row &row, const Features &f, bool mirrored = false) {
  Vec<std::pair<double, double>> teeth;
  double from = 0;
  for (const double w : row.width) {
    if (w > 0) teeth.push_back({from, from + w});
    from += std::abs(w);
  }
  REQUIRE(f.groups.size() == teeth.size());
  Vec<int> owned(teeth.size(), 0);
  for (const features::Group &g : f.groups) {
    REQUIRE(!g.points.empty());
    REQUIRE(g.points.size() <= 8);
    CHECK(g.to > g.from);
    CHECK(g.confidence > 0);
    CHECK(g.confidence <= 1);
    Vec<std::size_t> owner;
    for (const features::Point &p : g.points) {
      double a = std::atan2(p.position.y(), (mirrored ? -1 : 1) * p.position.x());
      if (a < -std::numbers::pi / 2) a += 2 * std::numbers::pi;  // the open side is at the back
      const double s = (a - std::numbers::pi / 2) * row.radius + row.length() / 2;
      for (std::size_t k = 0; k < teeth.size(); ++k)
        if (s > teeth[k].first && s < teeth[k].second) owner.push_back(k);
    }
    REQUIRE(owner.size() == g.points.size());
    for (const std::size_t o : owner) CHECK(o == owner[0]);
    ++owned[owner[0]];
  }
  for (const int n : owned) CHECK(n == 1);
}

Surface moved(const Surface &s, const Eigen::Matrix3d &by, const Vec3 &shift, bool flip) {
  Vec<Vec3> p = s.position;
  for (Vec3 &x : p) x = by * x + shift;
  Vec<mesh::Triangle> t = s.triangle;
  if (flip)
    for (mesh::Triangle &x : t) std::swap(x[1], x[2]);
  return mesh::make_surface(p, t);
}

Fault fault_of(const Surface &s) {
  try {
    find(s);
  } catch (const Error &e) {
    return e.fault();
  }
  return Fault::internal;
}

// n by m quads over [0, 1]^2, wrapped or not as `at` has it.
Surface patch(int n, int m, const auto &at) {
  Vec<Vec3> p;
  Vec<mesh::Triangle> t;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j) p.push_back(at(static_cast<double>(i) / n, static_cast<double>(j) / m));
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const auto a = static_cast<mesh::Index>(i * (m + 1) + j), b = a + 1, c = a + m + 1, d = c + 1;
      t.push_back({a, c, d});
      t.push_back({a, d, b});
    }
  return mesh::make_surface(p, t);
}

}  // namespace

TEST_CASE("a whole arch: one group a tooth, in order, looking up") {
  const Surface s = whole.surface();
  const Features f = find(s);
  check_groups(whole, f);
  CHECK(f.occlusal.z() > 0.95);
  CHECK(f.occlusal.norm() == doctest::Approx(1));
  CHECK(!f.inside_out);
  for (std::size_t i = 0; i + 1 < f.groups.size(); ++i) CHECK(f.groups[i].to <= f.groups[i + 1].from);
  CHECK(f.arch.size() > 50);
  for (const features::Group &g : f.groups)
    for (const features::Point &p : g.points) {
      CHECK((s.position[p.vertex] - p.position).norm() < 0.5);
      CHECK(p.convexity > 0.05);
    }
}

TEST_CASE("any pose, mirrored, inside out" * doctest::test_suite("many arches")) {
  const Surface s = whole.surface();
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Matrix3d turn = Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
                                     .normalized()
                                     .toRotationMatrix();
    const Vec3 shift(40 * k, -7, 3);
    Features f = find(moved(s, turn, shift, false));
    CHECK(f.occlusal.dot(turn.col(2)) > 0.95);
    for (features::Group &g : f.groups)
      for (features::Point &p : g.points) p.position = turn.transpose() * (p.position - shift);
    check_groups(whole, f);
  }
  const Eigen::Matrix3d mirror = Eigen::Vector3d(-1, 1, 1).asDiagonal();
  check_groups(whole, find(moved(s, mirror, {0, 0, 0}, true)), true);
  const Features f = find(moved(s, Eigen::Matrix3d::Identity(), {0, 0, 0}, true));
  CHECK(f.inside_out);
  CHECK(f.occlusal.z() > 0.95);
  check_groups(whole, f);
}

TEST_CASE("a gap, half an arch, a single tooth") {
  const Row gap{{10, 11, -7.5, 7.3, 7.8, 6.6, 8.6, 8.6, 6.6, 7.8, 7.3, 7.5, -11, 10}};
  check_groups(gap, find(gap.surface()));
  const Row half{{8.6, 6.6, 7.8, 7.3, 7.5, 11, 10}};
  check_groups(half, find(half.surface()));
  const Row single{{10.5}};
  check_groups(single, find(single.surface()));
}

TEST_CASE("resolution and order of the faces do not matter" * doctest::test_suite("many arches")) {
  Row fine = whole;
  fine.spacing = 0.2;
  check_groups(fine, find(fine.surface()));
  Row coarse = whole;
  coarse.spacing = 0.8;
  check_groups(coarse, find(coarse.surface()));

  const Surface s = whole.surface();
  Vec<mesh::Triangle> t = s.triangle;
  std::mt19937 random(1);
  std::shuffle(t.begin(), t.end(), random);
  check_groups(whole, find(mesh::make_surface(s.position, t)));
}

TEST_CASE("the same bytes for any number of threads") {
  const Surface s = whole.surface();
  const Features a = find(s, {}, 1), b = find(s, {}, 3);
  REQUIRE(a.groups.size() == b.groups.size());
  CHECK(a.occlusal == b.occlusal);
  CHECK(a.arch == b.arch);
  for (std::size_t i = 0; i < a.groups.size(); ++i) {
    REQUIRE(a.groups[i].points.size() == b.groups[i].points.size());
    CHECK(a.groups[i].confidence == b.groups[i].confidence);
    for (std::size_t k = 0; k < a.groups[i].points.size(); ++k) {
      CHECK(a.groups[i].points[k].position == b.groups[i].points[k].position);
      CHECK(a.groups[i].points[k].vertex == b.groups[i].points[k].vertex);
    }
  }
}

TEST_CASE("options: fewer points, a direction by hand") {
  const Surface s = whole.surface();
  DetectOptions o;
  o.max_points = 2;
  for (const features::Group &g : find(s, o).groups) CHECK(g.points.size() <= 2);
  o = {};
  o.occlusal = Vec3(0.1, 0, 3);
  const Features f = find(s, o);
  CHECK((f.occlusal - o.occlusal.normalized()).norm() < 1e-12);
  check_groups(whole, f);
  const Features g = find(moved(s, Eigen::Matrix3d::Identity(), {0, 0, 0}, true), o);
  CHECK(g.inside_out);
  CHECK((g.occlusal - o.occlusal.normalized()).norm() < 1e-12);
  check_groups(whole, g);
}

TEST_CASE("what is no jaw has no teeth") {
  constexpr double tau = 2 * std::numbers::pi;
  const auto sphere = [&](double u, double v) {
    const double a = tau * u, b = tau / 2 * v;
    return Vec3(20 * std::sin(b) * std::cos(a), 20 * std::sin(b) * std::sin(a), 20 * std::cos(b));
  };
  CHECK(fault_of(patch(90, 60, sphere)) == Fault::no_teeth);
  CHECK(fault_of(patch(50, 50, [](double u, double v) { return Vec3(60 * u, 60 * v, 0); })) == Fault::no_teeth);
  CHECK(fault_of(patch(90, 50, [&](double u, double v) {
          return Vec3(20 * std::cos(tau * u), 20 * std::sin(tau * u), 50 * v);
        })) == Fault::no_teeth);
  const auto bowl = [&](double u, double v) { return sphere(u, 0.5 * v); };
  CHECK(fault_of(patch(90, 30, bowl)) == Fault::no_teeth);
  Vec<Vec3> p;
  for (int k = 0; k < 8; ++k) p.push_back(40 * Vec3(k & 1, k >> 1 & 1, k >> 2));
  const Vec<mesh::Triangle> cube{{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  CHECK(fault_of(mesh::make_surface(p, cube)) == Fault::no_teeth);
}

TEST_CASE("a surface larger than any jaw is refused before it is sampled") {
  const Surface s = mesh::make_surface({{0, 0, 0}, {1e5, 0, 0}, {1e5, 1e5, 0}, {0, 1e5, 0}}, {{0, 1, 2}, {0, 2, 3}});
  CHECK_THROWS_WITH_AS(features::detect(s, {}, Executor(1), {}), doctest::Contains("mm across: no jaw is"), Error);
}

TEST_CASE("progress rises and can cancel") {
  struct : Monitor {
    double last = 0;
    int calls = 0, stop_after = 1 << 20;
    bool falling = false;
    bool proceed(double fraction, const char *) noexcept override {
      falling |= fraction < last;
      last = fraction;
      return ++calls <= stop_after;
    }
  } monitor;
  const Surface s = whole.surface();
  features::detect(s, {}, Executor(1), Progress(&monitor));
  CHECK(!monitor.falling);
  CHECK(monitor.last == doctest::Approx(1));
  CHECK(monitor.calls > 3);
  monitor.calls = 0;
  monitor.stop_after = 2;
  Fault fault = Fault::internal;
  try {
    features::detect(s, {}, Executor(1), Progress(&monitor));
  } catch (const Error &e) {
    fault = e.fault();
  }
  CHECK(fault == Fault::cancelled);
}
