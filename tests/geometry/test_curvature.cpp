#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "forms.h"
#include "geometry/concavity.h"

using namespace ts;
using namespace ts::geometry;
using std::numbers::pi;

namespace {

Principal curvatures(const Surface &s, double radius) {
  const Executor one(1);
  const Graph g = make_graph(s, cotangent_weights(s, 0.01, one));
  return principal_curvatures(s, s.position,
                              smoothed_normals(s, vertex_normals(s, NormalWeight::angle, one), g, radius, one), one);
}

double gauge_of(const Surface &s) {
  return noise_gauge(s, vertex_normals(s, NormalWeight::angle, Executor(1)), Executor(1));
}

}  // namespace

TEST_CASE("a sphere curves by 1/R both ways and is nowhere concave") {
  const Surface s = forms::sphere(4, 4);
  const Principal k = curvatures(s, 0);
  for (Index v = 0; v < s.vertices(); ++v) {
    CHECK(k.least[v] == doctest::Approx(0.25).epsilon(0.03));
    CHECK(k.greatest[v] == doctest::Approx(0.25).epsilon(0.03));
  }
  for (const double c : concavity(s, 0.15, false, Executor(1)).vertex) CHECK(c == 0);
}

TEST_CASE("the same sphere looking inwards is concave by 1/R, and says so only when not told") {
  Surface s = forms::sphere(4, 4);
  Vec<mesh::Triangle> turned = s.triangle;
  for (auto &t : turned) std::swap(t[1], t[2]);
  s = mesh::make_surface(s.position, turned);
  for (const double c : concavity(s, 0.15, false, Executor(1)).vertex) CHECK(c == doctest::Approx(0.25).epsilon(0.03));
  for (const double c : concavity(s, 0.15, true, Executor(1)).vertex) CHECK(c == 0);
}

TEST_CASE("a torus: 1/r across, cos / rho around") {
  const double major = 6, minor = 2;
  const Surface s = forms::torus(major, minor, 160, 64);
  const Principal k = curvatures(s, 0);
  for (Index v = 0; v < s.vertices(); ++v) {
    const double rho = std::hypot(s.position[v].x(), s.position[v].y()), cosine = (rho - major) / minor;
    CHECK(k.greatest[v] == doctest::Approx(1 / minor).epsilon(0.02));
    CHECK(std::abs(k.least[v] - cosine / rho) < 0.01);
  }
}

TEST_CASE("a valley between two planes is concave along its bottom and nowhere else") {
  const double slope = 1;  // a dihedral of 90 degrees
  const Surface s = forms::terrain(10, 10, 40, 40, [&](double x, double) { return slope * std::abs(x - 5); });
  const Vec<double> c = concavity(s, 0.15, false, Executor(1)).vertex;
  for (Index v = 0; v < s.vertices(); ++v) {
    const double away = std::abs(s.position[v].x() - 5);
    if (away < 1e-9 && !s.on_boundary[v])
      CHECK(c[v] > 0.8);  // a right angle, spread over an edge and the radius to either side
    if (away > 1.5) CHECK(c[v] < 0.01);
  }
  // A ridge is not concave.
  const Surface ridge = forms::terrain(10, 10, 40, 40, [&](double x, double) { return -slope * std::abs(x - 5); });
  const Vec<double> none = concavity(ridge, 0.15, false, Executor(1)).vertex;
  for (Index v = 0; v < ridge.vertices(); ++v)
    if (!ridge.on_boundary[v]) CHECK(none[v] < 0.05);
}

TEST_CASE("angle defects add up to 2 pi (V - E + F), borders or not") {
  const auto total = [](const Surface &s) {
    const Vec<double> g = gaussian_curvature(s, Executor(1));
    double sum = 0;
    for (Index v = 0; v < s.vertices(); ++v) sum += g[v] * s.vertex_area[v];
    return sum;
  };
  CHECK(total(forms::sphere(3, 3)) == doctest::Approx(4 * pi));
  CHECK(std::abs(total(forms::torus(6, 2, 40, 20))) < 1e-9);
  CHECK(total(forms::terrain(5, 5, 20, 20, [](double x, double y) { return std::sin(x) * y; })) ==
        doctest::Approx(2 * pi));
  CHECK(std::abs(total(forms::tube(3, 8, 24, 10))) < 1e-9);
  const Surface ball = forms::sphere(5, 4);
  const Vec<double> g = gaussian_curvature(ball, Executor(1));
  const double mean = std::accumulate(g.begin(), g.end(), 0.0) / double(g.size());
  CHECK(mean == doctest::Approx(1.0 / 25).epsilon(0.02));
}

TEST_CASE("Eq. 9: the vertices of a valley pass, those of a ridge or a plane do not") {
  const Executor one(1);
  const auto concave = [&](double sign, double theta) {
    const Surface s = forms::terrain(10, 10, 20, 20, [&](double x, double) { return sign * std::abs(x - 5); });
    const Vec<std::uint8_t> c = concave_by_edges(s, vertex_normals(s, NormalWeight::angle, one), theta, one);
    Vec<int> columns(21, 0);
    for (Index v = 0; v < s.vertices(); ++v) columns[v % 21] += c[v];
    return columns;
  };
  const Vec<int> valley = concave(1, 0.001);
  CHECK(valley[10] == 21);
  CHECK(valley[9] == 21);  // "if one or more of its adjacent vertexes": the neighbours count as well
  CHECK(valley[7] == 0);
  for (const int n : concave(-1, 0.001)) CHECK(n == 0);
  for (const int n : concave(1, 1.9)) CHECK(n == 0);
}

TEST_CASE("the noise gauge tells rough from smooth; only rough is smoothed") {
  Surface s = forms::sphere(8, 4);
  CHECK(presmoothing(gauge_of(s), 0.85) == 0);
  std::uint32_t state = 1;
  Vec<mesh::Vec3> shaken = s.position;
  for (auto &p : shaken) {
    double r = -6;
    for (int k = 0; k < 12; ++k) r += double((state = state * 1664525u + 1013904223u) >> 8) / 16777216.0;
    p += p.normalized() * r * 0.2 * s.mean_edge;
  }
  const Surface rough = mesh::make_surface(shaken, s.triangle);
  const double gauge = gauge_of(rough);
  CHECK(gauge > 0.15);
  CHECK(gauge < 0.35);
  CHECK(presmoothing(gauge, 0.85) > 0.2);
  CHECK(presmoothing(10, 0.85) == 1);
  CHECK(presmoothing(10, 0.85 / 8) == doctest::Approx(0.25));  // a fine mesh shakes less, in mm
  CHECK(presmoothing(10, 10) == 1.5);
  // What noise adds to lengths and areas is told, and nothing is told of a smooth surface.
  const Concavity smooth_c = concavity(s, 0.15, false, Executor(1)),
                  rough_c = concavity(rough, 0.15, false, Executor(1));
  CHECK(smooth_c.lengthened == 1);
  CHECK(smooth_c.widened == 1);
  CHECK(rough_c.widened == doctest::Approx(rough.area / s.area).epsilon(0.1));
  CHECK(rough_c.lengthened == doctest::Approx(rough.mean_edge / s.mean_edge).epsilon(0.1));
}

TEST_CASE("smoothing: constants stay, waves shrink by 1 / (1 + r^2 k^2), any number of threads gives the same bytes") {
  const Surface s = forms::tube(10 / (2 * pi), 10, 100, 100);  // 0.1 mm squares
  const Graph g = make_graph(s, cotangent_weights(s, 0, Executor(1)));
  const double k = 2 * pi / 2.5, r = 0.4;
  Vec<mesh::Vec3> x(s.vertices());
  for (Index v = 0; v < s.vertices(); ++v)
    x[v] = {1, std::cos(std::atan2(s.position[v].y(), s.position[v].x()) * 4), std::cos(k * s.position[v].z())};
  const Vec<mesh::Vec3> y = smooth(s, g, r, x, Executor(1));
  for (Index v = 0; v < s.vertices(); ++v) {
    CHECK(y[v][0] == doctest::Approx(1).epsilon(1e-5));
    CHECK(std::abs(y[v][1] - x[v][1] / (1 + r * r * k * k)) < 0.01);  // 4 waves around 10 mm: the same k
    CHECK(std::abs(y[v][2] - x[v][2] / (1 + r * r * k * k)) < 0.01);
  }
  const Vec<mesh::Vec3> again = smooth(s, g, r, x, Executor(3));
  CHECK(std::equal(y.begin(), y.end(), again.begin()));
}

TEST_CASE("vertex normals point along the radius of a sphere, whichever the weight") {
  const Surface s = forms::sphere(2, 3);
  for (const auto weight : {NormalWeight::angle, NormalWeight::area}) {
    const Vec<mesh::Vec3> n = vertex_normals(s, weight, Executor(1));
    for (Index v = 0; v < s.vertices(); ++v) CHECK(n[v].dot(s.position[v].normalized()) > 0.9995);
  }
}
