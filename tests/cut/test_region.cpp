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

Mask disc(const mesh::Surface &s, double x, double y, double r) {
  Mask m(s.faces(), 0);
  for (Index f = 0; f < s.faces(); ++f) m[f] = std::hypot(centre(s, f).x() - x, centre(s, f).y() - y) < r;
  return m;
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
  Mask m = grow(s, phi, {&seed, 1});
  const double ring = area_of(s, faces_of(m));
  CHECK(ring == doctest::Approx(forms::pi * (36 - 2.25)).epsilon(0.03));
  Vec<std::uint8_t> foreign(s.vertices(), 0);
  Mask small = m, kept = m, filled = m;
  fill_holes(s, 5, foreign, small);
  CHECK(small == m);  // the hole is larger than that
  foreign[vertex_at(s, 10, 10)] = 1;
  fill_holes(s, 40, foreign, kept);
  CHECK(kept == m);
  foreign.assign(s.vertices(), 0);
  fill_holes(s, 40, foreign, filled);
  CHECK(area_of(s, faces_of(filled)) == doctest::Approx(forms::pi * 36).epsilon(0.03));

  Mask corner(s.faces(), 1);  // all but a corner at the border: no hole
  for (Index f = 0; f < s.faces(); ++f) corner[f] = centre(s, f).head<2>().norm() > 2;
  Mask same = corner;
  fill_holes(s, 40, foreign, same);
  CHECK(same == corner);
  CHECK(touches_border(s, faces_of(corner)));
  CHECK(!touches_border(s, faces_of(m)));
  Mask two = disc(s, 10, 10, 4), other = disc(s, 25, 10, 3);
  for (Index f = 0; f < s.faces(); ++f) two[f] |= other[f];
  keep_seeded(s, {&seed, 1}, two);
  CHECK(two == disc(s, 10, 10, 4));
}

TEST_CASE("refinement moves the border into a seam nearby, not past seeds, and leaves what is beyond the band") {
  const mesh::Surface s = forms::plane(16, 16, 80, 80);
  Vec<double> c(s.vertices()), phi(s.vertices()), level(s.edge.size(), 0);
  for (Index v = 0; v < s.vertices(); ++v) {
    const double r = (s.position[v] - Vec3(8, 8, 0)).norm();
    c[v] = 4 * std::exp(-std::pow((r - 5) / 0.15, 2));  // a round seam at 5
    phi[v] = std::clamp((r - 4.3) / 3, -1.0, 1.0);
  }
  const Vec<double> seam = seams(s, c, level);
  Vec<std::uint8_t> fixed(s.vertices(), 0);
  const Mask start = disc(s, 8, 8, 4.3);
  Mask m = start;
  refine(s, phi, seam, fixed, {1.5}, m);
  for (Index f = 0; f < s.faces(); ++f) {
    const double r = (centre(s, f) - Vec3(8, 8, 0)).norm();
    if (r < 4.6) CHECK(m[f]);
    if (r > 5.4) CHECK(!m[f]);
  }
  // Another tooth's seed between the border and the seam stays outside.
  const Index seed = vertex_at(s, 12.6, 8);
  fixed[seed] = 2;
  m = start;
  refine(s, phi, seam, fixed, {1.5}, m);
  for (const Index f : s.vertex_faces[seed]) CHECK(!m[f]);
  // A band too narrow to reach the seam leaves the border where it is cheap.
  m = start;
  refine(s, phi, seam, Vec<std::uint8_t>(s.vertices(), 0), {0.2}, m);
  for (Index f = 0; f < s.faces(); ++f)
    if ((centre(s, f) - Vec3(8, 8, 0)).norm() > 4.8) CHECK(!m[f]);
}

TEST_CASE(
    "the smoothed line of a disc of faces is one closed line, shorter than the jagged border, tooth on its left") {
  const mesh::Surface s = forms::plane(16, 16, 64, 64);
  const Vec<double> cot = geometry::cotangent_weights(s, 0.01, Executor(1));
  const Mask m = disc(s, 8, 8, 4);
  const Index seed = vertex_at(s, 8, 8);
  const Vec<Polyline> lines = smooth_line(s, cot, m, 0.3, {&seed, 1});
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
  CHECK(smooth_line(s, cot, m, 0, {&seed, 1}).size() == 1);
}

TEST_CASE("islands without a seed have no line; a region at the border has an open one") {
  const mesh::Surface s = forms::plane(16, 16, 64, 64);
  const Vec<double> cot = geometry::cotangent_weights(s, 0.01, Executor(1));
  Mask m = disc(s, 5, 8, 3), island = disc(s, 13, 8, 1);
  for (Index f = 0; f < s.faces(); ++f) m[f] |= island[f];
  Index seed = vertex_at(s, 5, 8);
  const Vec<Polyline> one = smooth_line(s, cot, m, 0.2, {&seed, 1});
  REQUIRE(one.size() == 1);
  for (const EdgePoint &p : one[0].points) CHECK(p.position.x() < 9);
  seed = vertex_at(s, 0, 8);
  const Vec<Polyline> open = smooth_line(s, cot, disc(s, 0, 8, 3), 0.2, {&seed, 1});
  REQUIRE(open.size() == 1);
  CHECK(!open[0].closed);
  CHECK(std::abs(open[0].points.front().position.x()) < 1e-9);
  CHECK(std::abs(open[0].points.back().position.x()) < 1e-9);
}
