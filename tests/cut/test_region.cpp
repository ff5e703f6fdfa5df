#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "../geometry/forms.h"
#include "cut/line.h"
#include "cut/max_flow.h"
#include "cut/refine.h"
#include "geometry/laplacian.h"

using namespace ts;
using namespace ts::cut;

namespace {

double pseudo_random(std::uint32_t &state) {
  state = state * 1664525u + 1013904223u;
  return double(state >> 8) / 16777216.0;
}

Vec3 centre(const mesh::Surface &s, Index f) {
  const auto &t = s.triangle[f];
  return (s.position[t[0]] + s.position[t[1]] + s.position[t[2]]) / 3;
}

// Faces that fulfil `wanted`, as the region of a space.
void fill(const mesh::Surface &s, Space &space, const auto &wanted) {
  space.clear();
  for (Index f = 0; f < s.faces(); ++f)
    if (wanted(f)) space.inside.set(f, 1);
}

auto in_disc(const mesh::Surface &s, double x, double y, double r) {
  return [&s, x, y, r](Index f) { return std::hypot(centre(s, f).x() - x, centre(s, f).y() - y) < r; };
}

Vec<Index> disc(const mesh::Surface &s, double x, double y, double r) {
  Vec<Index> faces;
  for (Index f = 0; f < s.faces(); ++f)
    if (in_disc(s, x, y, r)(f)) faces.push_back(f);
  return faces;
}

Vec<double> lengths(const mesh::Surface &s) {
  Vec<double> length(s.edge.size());
  for (Index e = 0; e < length.size(); ++e) length[e] = s.edge_length(e);
  return length;
}

bool is_clean(const Space &s) {
  const auto all = [](const auto &a, auto clean) {
    for (std::size_t i = 0; i < a.size(); ++i)
      if (a[i] != clean) return false;
    return true;
  };
  return all(s.faces, 0) && all(s.marks, 0) && all(s.place, mesh::none) && all(s.level, 1.0);
}

Index vertex_at(const mesh::Surface &s, double x, double y) {
  Index best = 0;
  for (Index v = 0; v < s.vertices(); ++v)
    if ((s.position[v] - Vec3(x, y, 0)).norm() < (s.position[best] - Vec3(x, y, 0)).norm()) best = v;
  return best;
}

}  // namespace

TEST_CASE("minimum cuts are those of trying all cuts") {
  std::uint32_t state = 3;
  for (int round = 0; round < 300; ++round) {
    const Index n = 2 + Index(pseudo_random(state) * 9);
    Vec<std::array<double, 2>> terminal(n);
    for (auto &t : terminal)
      for (double &x : t) x = pseudo_random(state) < 0.5 ? std::floor(pseudo_random(state) * 9) : 0;
    struct Arc {
      Index a, b;
      double there, back;
    };
    Vec<Arc> arcs;
    for (Index a = 0; a < n; ++a)
      for (Index b = a + 1; b < n; ++b)
        if (pseudo_random(state) < 0.5)
          arcs.push_back({a, b, std::floor(pseudo_random(state) * 6), std::floor(pseudo_random(state) * 6)});
    const auto cost = [&](unsigned with_source) {
      double sum = 0;
      for (Index i = 0; i < n; ++i) sum += terminal[i][with_source >> i & 1u];  // the terminal it is cut from
      for (const Arc &e : arcs) {
        const bool a = with_source >> e.a & 1u, b = with_source >> e.b & 1u;
        sum += a && !b ? e.there : !a && b ? e.back : 0;
      }
      return sum;
    };
    double least = 1e9;
    for (unsigned m = 0; m < 1u << n; ++m) least = std::min(least, cost(m));
    MaxFlow flow(n);
    for (Index i = 0; i < n; ++i) flow.add_terminals(i, terminal[i][0], terminal[i][1]);
    for (const Arc &e : arcs) flow.add_edge(e.a, e.b, e.there, e.back);
    CHECK(flow.solve() == doctest::Approx(least));
    unsigned found = 0;
    for (Index i = 0; i < n; ++i) found |= unsigned(flow.with_source(i)) << i;
    CHECK(cost(found) == doctest::Approx(least));
  }
}

TEST_CASE("a region is the part of phi < 0 with the seeds; holes close, but not around others' seeds or at borders") {
  const mesh::Surface s = forms::plane(30, 20, 60, 40);
  Vec<double> phi(s.vertices());
  for (Index v = 0; v < s.vertices(); ++v) {
    const Vec3 &p = s.position[v];
    const double one = std::hypot(p.x() - 10, p.y() - 10) - 6, two = std::hypot(p.x() - 25, p.y() - 10) - 3;
    const double hole = 1.5 - std::hypot(p.x() - 10, p.y() - 10);
    phi[v] = std::max(std::min(one, two), hole);
  }
  const Index seed = vertex_at(s, 13, 10);
  Space space(s);
  const auto value = [&](Index v) { return phi[v]; };
  const auto grown = [&] {
    space.clear();
    Growth growth(s, value, {&seed, 1}, space.inside);
    growth.rise(0);
    CHECK(growth.area() == doctest::Approx(area_of(s, faces_of(space.inside))));
    return growth.beside();
  };
  const Vec<Index> outside = grown(), ring = faces_of(space.inside);
  CHECK(area_of(s, ring) == doctest::Approx(forms::pi * (36 - 2.25)).epsilon(0.03));
  const auto filled = [&](double area, Index foreign) {
    grown();
    fill_holes(
        s, area, [&](Index v) { return std::uint8_t(v == foreign); }, outside, space.inside);
    return faces_of(space.inside);
  };
  CHECK(filled(5, mesh::none) == ring);  // the hole is larger than that
  CHECK(filled(40, vertex_at(s, 10, 10)) == ring);
  CHECK(area_of(s, filled(40, mesh::none)) == doctest::Approx(forms::pi * 36).epsilon(0.03));

  fill(s, space, [&](Index f) { return centre(s, f).head<2>().norm() > 2; });
  const Vec<Index> corner = faces_of(space.inside);  // all but a corner at the border: no hole
  CHECK(fill_holes(
            s, 40, [](Index) { return std::uint8_t{0}; }, beside(s, space.inside), space.inside)
            .empty());
  CHECK(faces_of(space.inside) == corner);
  fill(s, space, [&](Index f) { return in_disc(s, 10, 10, 4)(f) || in_disc(s, 25, 10, 3)(f); });
  keep_seeded(s, {&seed, 1}, space.inside);
  CHECK(faces_of(space.inside) == disc(s, 10, 10, 4));
  CHECK(is_clean(space));
}

TEST_CASE("a region that has risen from level to level is that of the last level at once, and so is its border") {
  const mesh::Surface s = forms::plane(30, 20, 90, 60);
  std::uint32_t state = 11;
  Vec<double> u(s.vertices());
  for (Index v = 0; v < s.vertices(); ++v)
    u[v] = std::hypot(s.position[v].x() - 12, s.position[v].y() - 9) / 12 + 0.1 * pseudo_random(state);
  const Index seed = vertex_at(s, 12, 9);
  const auto at = [&](Index v) { return u[v]; };
  Space slow(s), fast(s);
  Growth growth(s, at, {&seed, 1}, slow.inside);
  for (const double level : {0.2, 0.35, 0.5, 0.8}) {
    growth.rise(level);
    fast.clear();
    Growth once(s, at, {&seed, 1}, fast.inside);
    once.rise(level);
    CHECK(faces_of(slow.inside) == faces_of(fast.inside));
    const auto sorted = [](Vec<Index> faces) {
      std::sort(faces.begin(), faces.end());
      faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
      return faces;
    };
    CHECK(sorted(growth.mixed()) == sorted(once.mixed()));
    CHECK(sorted(growth.beside()) == sorted(once.beside()));
    CHECK(sorted(growth.beside()) == sorted(beside(s, fast.inside)));
  }
}

TEST_CASE("refinement moves the border into a seam nearby, not past seeds, and leaves what is beyond the band") {
  const mesh::Surface s = forms::plane(16, 16, 80, 80);
  Vec<double> c(s.vertices()), phi(s.vertices()), level(s.edge.size(), 0);
  for (Index v = 0; v < s.vertices(); ++v) {
    const double r = (s.position[v] - Vec3(8, 8, 0)).norm();
    c[v] = 4 * std::exp(-std::pow((r - 5) / 0.15, 2));  // a round seam at 5
    phi[v] = std::clamp((r - 4.3) / 3, -1.0, 1.0);
  }
  const Vec<double> length = lengths(s), price = prices(length, seams(s, c, level));
  Space space(s);
  const auto refined = [&](double band, Index seed) {
    fill(s, space, in_disc(s, 8, 8, 4.3));
    refine(
        s, [&](Index v) { return phi[v]; }, length, price, [&](Index v) { return std::uint8_t(v == seed ? 2 : 0); },
        {band}, space);
    CHECK(is_clean(space));
  };
  refined(1.5, mesh::none);
  for (Index f = 0; f < s.faces(); ++f) {
    const double r = (centre(s, f) - Vec3(8, 8, 0)).norm();
    if (r < 4.6) CHECK(space.inside[f]);
    if (r > 5.4) CHECK(!space.inside[f]);
  }
  // Another tooth's seed between the border and the seam stays outside.
  const Index seed = vertex_at(s, 12.6, 8);
  refined(1.5, seed);
  for (const Index f : s.vertex_faces[seed]) CHECK(!space.inside[f]);
  // A band too narrow to reach the seam leaves the border where it is cheap.
  refined(0.2, mesh::none);
  for (Index f = 0; f < s.faces(); ++f)
    if ((centre(s, f) - Vec3(8, 8, 0)).norm() > 4.8) CHECK(!space.inside[f]);
}

TEST_CASE(
    "the smoothed line of a disc of faces is one closed line, shorter than the jagged border, tooth on its left") {
  const mesh::Surface s = forms::plane(16, 16, 64, 64);
  const Vec<double> cot = geometry::cotangent_weights(s, 0.01, Executor(1));
  const Index seed = vertex_at(s, 8, 8);
  Space space(s);
  fill(s, space, in_disc(s, 8, 8, 4));
  const Vec<Polyline> lines = smooth_line(s, lengths(s), cot, 0.3, {&seed, 1}, space);
  CHECK(is_clean(space));
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].closed);
  CHECK(lines[0].length == doctest::Approx(2 * forms::pi * 4).epsilon(0.04));
  double area = 0;
  std::set<std::pair<Index, Index>> edges;
  for (std::size_t i = 0; i < lines[0].points.size(); ++i) {
    const EdgePoint &p = lines[0].points[i], &q = lines[0].points[(i + 1) % lines[0].points.size()];
    area += (p.position.x() * q.position.y() - p.position.y() * q.position.x()) / 2;
    CHECK(std::abs((p.position - Vec3(8, 8, 0)).norm() - 4) < 0.25);
    CHECK(edges.insert({p.a, p.b}).second);  // simple: no edge is crossed twice
  }
  CHECK(area == doctest::Approx(forms::pi * 16).epsilon(0.03));  // positive: counter-clockwise around the disc
  CHECK(smooth_line(s, lengths(s), cot, 0, {&seed, 1}, space).size() == 1);
}

TEST_CASE("islands without a seed have no line; a region at the border has an open one") {
  const mesh::Surface s = forms::plane(16, 16, 64, 64);
  const Vec<double> cot = geometry::cotangent_weights(s, 0.01, Executor(1));
  Space space(s);
  fill(s, space, [&](Index f) { return in_disc(s, 5, 8, 3)(f) || in_disc(s, 13, 8, 1)(f); });
  Index seed = vertex_at(s, 5, 8);
  keep_seeded(s, {&seed, 1}, space.inside);
  const Vec<Polyline> one = smooth_line(s, lengths(s), cot, 0.2, {&seed, 1}, space);
  REQUIRE(one.size() == 1);
  for (const EdgePoint &p : one[0].points) CHECK(p.position.x() < 9);
  seed = vertex_at(s, 0, 8);
  fill(s, space, in_disc(s, 0, 8, 3));
  const Vec<Polyline> open = smooth_line(s, lengths(s), cot, 0.2, {&seed, 1}, space);
  REQUIRE(open.size() == 1);
  CHECK(!open[0].closed);
  CHECK(std::abs(open[0].points.front().position.x()) < 1e-9);
  CHECK(std::abs(open[0].points.back().position.x()) < 1e-9);
}
