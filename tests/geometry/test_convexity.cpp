#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "geometry/convexity.h"

using namespace ts;
using geometry::Sample;
using mesh::Surface;
using mesh::Vec3;

namespace {

// A piece of the graph of z(x, y) over [-size, size]^2, n by n quads.
Surface graph(double size, int n, const auto &z) {
  Vec<Vec3> p;
  Vec<mesh::Triangle> t;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = size * (2.0 * i / n - 1), y = size * (2.0 * j / n - 1);
      p.emplace_back(x, y, z(x, y));
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const auto a = static_cast<mesh::Index>(j * (n + 1) + i), b = a + 1, c = a + n + 1, d = c + 1;
      t.push_back({a, b, d});
      t.push_back({a, d, c});
    }
  return mesh::make_surface(p, t);
}

double total_area(const Vec<Sample> &samples) {
  double sum = 0;
  for (const Sample &s : samples) sum += s.area;
  return sum;
}

}  // namespace

TEST_CASE("samples carry the whole area, however the surface is cut into triangles") {
  const auto flat = [](double, double) { return 0.0; };
  for (const int n : {1, 7, 200}) {
    const Vec<Sample> samples = geometry::area_samples(graph(10, n, flat), 0.5);
    CHECK(total_area(samples) == doctest::Approx(400));
    CHECK(samples.size() >= 40 * 40);
    CHECK(samples.size() <= 43 * 43);
    for (const Sample &s : samples) REQUIRE((s.normal - Vec3(0, 0, 1)).norm() < 1e-12);
  }
}

TEST_CASE("a sliver is sampled along its length only") {
  const Surface s = mesh::make_surface({{0, 0, 0}, {100, 0, 0}, {50, 0.01, 0}}, {{0, 1, 2}});
  const Vec<Sample> samples = geometry::area_samples(s, 0.5);
  CHECK(total_area(samples) == doctest::Approx(0.5));
  CHECK(samples.size() <= 201);
  CHECK(samples.size() >= 150);
}

TEST_CASE("a ball query finds what a search through all finds") {
  const Surface s = graph(5, 40, [](double x, double y) { return std::sin(x) * std::cos(y); });
  const Vec<Sample> samples = geometry::area_samples(s, 0.4);
  for (const double bin : {0.3, 1.0, 50.0}) {
    const geometry::SampleBins bins(samples, bin);
    for (const Vec3 &q : {Vec3(0, 0, 0), Vec3(4.9, -4.9, 0.3), Vec3(-9, 0, 0), Vec3(1.3, 2.2, -0.5)}) {
      int found = 0, all = 0;
      bins.ball(q, 1.7, [&](const Sample &, double) { ++found; });
      for (const Sample &x : samples) all += (x.position - q).norm() <= 1.7;
      CHECK(found == all);
    }
  }
}

TEST_CASE("convexity is 0 on a plane, r / 4R outside a sphere and its negative inside") {
  const double r = 2, radius = 12;
  const auto cap = [&](double sign) {
    return [=](double x, double y) { return sign * std::sqrt(radius * radius - x * x - y * y); };
  };
  const auto at_pole = [&](const Surface &s, const Vec3 &q) {
    return geometry::convexity(geometry::SampleBins(geometry::area_samples(s, 0.25), 1), q, r);
  };
  CHECK(std::abs(at_pole(graph(6, 9, [](double, double) { return 1.0; }), {0.3, 0.4, 1})) < 1e-3);
  CHECK(at_pole(graph(6, 120, cap(1)), {0, 0, radius}) == doctest::Approx(r / (4 * radius)).epsilon(0.05));
  CHECK(at_pole(graph(6, 120, cap(-1)), {0, 0, -radius}) == doctest::Approx(-r / (4 * radius)).epsilon(0.05));
}

TEST_CASE("convexity of a cone's tip") {
  // The centroid of a cone of slope 1 within r of its tip lies 2/3 r / sqrt 2 below it.
  const Surface s = graph(4, 160, [](double x, double y) { return -std::hypot(x, y); });
  const geometry::SampleBins bins(geometry::area_samples(s, 0.15), 1);
  CHECK(geometry::convexity(bins, Vec3(0, 0, 0), 2) == doctest::Approx(2.0 / 3 / std::numbers::sqrt2).epsilon(0.05));
}

TEST_CASE("convexity does not depend on resolution, pose or threads") {
  const auto wave = [](double x, double y) { return 0.6 * std::cos(x) * std::cos(y); };
  const Executor one(1), two(2);
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized();
  const Vec<Vec3> query{{0, 0, 0.6}, {1.5707963, 0, 0}, {3.14159265, 0, -0.6}};
  Vec<Vec3> turned;
  for (const Vec3 &q : query) turned.push_back(turn * q + Vec3(5, 6, 7));
  Surface coarse = graph(6, 60, wave), fine = graph(6, 200, wave), moved = fine;
  for (Vec3 &p : moved.position) p = turn * p + Vec3(5, 6, 7);
  moved = mesh::make_surface(moved.position, moved.triangle);
  const auto measure = [](const Surface &s, const Vec<Vec3> &q, const Executor &e) {
    return geometry::convexity(geometry::SampleBins(geometry::area_samples(s, 0.3), 1), q, {}, 1.5, e);
  };
  const Vec<double> a = measure(fine, query, one);
  CHECK(a[0] > 0.1);
  CHECK(a[2] < -0.1);
  CHECK(a == measure(fine, query, two));
  const Vec<double> b = measure(coarse, query, one), c = measure(moved, turned, one);
  for (std::size_t i = 0; i < query.size(); ++i) {
    CHECK(std::abs(a[i] - b[i]) < 0.02);
    CHECK(std::abs(a[i] - c[i]) < 0.02);
  }
}

TEST_CASE("the samples of a turned, moved or mirrored surface are the turned, moved or mirrored samples") {
  const auto bumps = [](double x, double y) { return 0.7 * std::sin(x) * std::cos(0.6 * y + 0.3) + 0.004 * x * x * y; };
  const Surface s = graph(9, 60, bumps);
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()) * Eigen::AngleAxisd(-2.0, Vec3::UnitZ())).toRotationMatrix();
  Eigen::Matrix3d mirror = turn;
  mirror.col(0) *= -1;
  const Vec3 shift(31, -7, 110);
  const Vec<Sample> before = geometry::area_samples(s, 0.5);
  for (const Eigen::Matrix3d &m : {turn, mirror}) {
    Vec<Vec3> p;
    for (const Vec3 &q : s.position) p.push_back(m * q + shift);
    Vec<mesh::Triangle> t = s.triangle;
    if (m.determinant() < 0)
      for (auto &corners : t) std::swap(corners[1], corners[2]);
    const Surface moved = mesh::make_surface(p, t);
    const geometry::Frame frame = geometry::principal_frame(s), other = geometry::principal_frame(moved);
    CHECK((m * frame.origin + shift - other.origin).norm() < 1e-9);
    for (int k = 0; k < 3; ++k) CHECK((m * frame.axis[k] - other.axis[k]).norm() < 1e-9);
    const Vec<Sample> after = geometry::area_samples(moved, 0.5);
    REQUIRE(after.size() == before.size());
    for (std::size_t i = 0; i < after.size(); ++i) {
      REQUIRE((m * before[i].position + shift - after[i].position).norm() < 1e-9);
      REQUIRE((m * before[i].normal - after[i].normal).norm() < 1e-9);
      REQUIRE(after[i].area == doctest::Approx(before[i].area));
    }
  }
}
