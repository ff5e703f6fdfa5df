#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "../geometry/forms.h"
#include "base/error.h"
#include "cut/contour.h"
#include "tooth/partition.h"

using namespace ts;
using namespace ts::tooth;
using std::numbers::pi;

namespace {

// Faces are needed only where there is no cut: then all are its own.
Tooth tooth_of(const mesh::Surface &s, Index group, const std::function<double(const Vec3 &)> &u, double iso) {
  Tooth t;
  t.group = group;
  for (auto &line : cut::contour(
           s, [&](Index v) { return u(s.position[v]); }, iso, forms::every_face(s)))
    t.loops.push_back({std::move(line), iso, 0, 0});
  Index lowest = 0;
  for (Index v = 0; v < s.vertices(); ++v)
    if (u(s.position[v]) < u(s.position[lowest])) lowest = v;
  t.seeds = {lowest};
  return t;
}

Tooth disc(const mesh::Surface &s, Index group, double x, double y, double radius) {
  return tooth_of(
      s, group, [=](const Vec3 &p) { return std::hypot(p.x() - x, p.y() - y); }, radius);
}

Partition cut_up(const mesh::Surface &s, std::initializer_list<Tooth> teeth) {
  Vec<const Tooth *> all;
  for (const Tooth &t : teeth) all.push_back(&t);
  Partition p = partition(s, all);
  // What holds of every partition: it is the surface, cut up.
  double area = 0;
  std::map<std::pair<Index, Index>, int> sides;
  for (std::size_t i = 0; i < p.triangle.size(); ++i) {
    const auto &[a, b, c] = p.triangle[i];
    const Vec3 n = (p.position[b] - p.position[a]).cross(p.position[c] - p.position[a]) / 2;
    area += n.norm();
    CHECK(n.dot(s.face_normal[p.face[i]]) >= 0);  // 0 where three lines all but meet in a point
    for (const auto &[v, w] : {std::pair{a, b}, {b, c}, {c, a}}) ++sides[{v, w}];
  }
  CHECK(area == doctest::Approx(s.area).epsilon(1e-12));
  double rim = 0, wanted = 0;
  for (const auto &[side, count] : sides) {
    CHECK(count == 1);
    if (!sides.contains({side.second, side.first})) rim += (p.position[side.first] - p.position[side.second]).norm();
  }
  for (const double length : s.boundary_length) wanted += length;
  CHECK(rim == doctest::Approx(wanted).epsilon(1e-12));  // no gap anywhere
  return p;
}

double area_of(const Partition &p, Index owner) {
  double area = 0;
  for (std::size_t i = 0; i < p.triangle.size(); ++i)
    if (const auto &[a, b, c] = p.triangle[i]; p.owner[i] == owner)
      area += (p.position[b] - p.position[a]).cross(p.position[c] - p.position[a]).norm() / 2;
  return area;
}

double area_in(const cut::Polyline &line) {
  double twice = 0;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const Vec3 &p = line.points[i].position, &q = line.points[(i + 1) % line.points.size()].position;
    twice += p.x() * q.y() - p.y() * q.x();
  }
  return twice / 2;
}

}  // namespace

TEST_CASE("a tooth has exactly what its cut encloses") {
  const mesh::Surface s = forms::plane(20, 20, 57, 43);
  const Tooth t = disc(s, 3, 9.3, 8.7, 4.1);
  REQUIRE(t.loops.size() == 1);
  const Partition p = cut_up(s, {t});
  CHECK(area_of(p, 0) ==
        doctest::Approx(area_in(t.loops[0].line)).epsilon(1e-6));  // points near vertices are put there
  CHECK(area_of(p, 0) == doctest::Approx(pi * 4.1 * 4.1).epsilon(0.01));
  CHECK(p.lost == Vec<double>{0});
  // The points of the cut are there, with their coordinates.
  std::size_t found = 0;
  for (const cut::EdgePoint &e : t.loops[0].line.points)
    found += std::find(p.position.begin(), p.position.end(), e.position) != p.position.end();
  CHECK(found > 0.9 * static_cast<double>(t.loops[0].line.points.size()));
}

TEST_CASE("a tooth with an island of gingiva, and one that is a piece of the scan") {
  mesh::Surface plane = forms::plane(20, 20, 50, 50);
  const Tooth ring = tooth_of(
      plane, 0, [](const Vec3 &p) { return std::abs(std::hypot(p.x() - 10, p.y() - 10) - 5); }, 2);
  REQUIRE(ring.loops.size() == 2);
  CHECK(area_of(cut_up(plane, {ring}), 0) == doctest::Approx(pi * (49 - 9)).epsilon(0.01));

  Vec<Vec3> position = plane.position;
  Vec<Triangle> triangle = plane.triangle;
  const Index n = static_cast<Index>(position.size());
  for (const Vec3 &p : {Vec3(0, 0, 5), Vec3(3, 0, 5), Vec3(0, 3, 5)}) position.push_back(p);
  triangle.push_back({n, n + 1, n + 2});
  const mesh::Surface two = mesh::make_surface(position, triangle);
  Tooth whole;
  whole.group = 1;
  whole.faces = {static_cast<Index>(triangle.size() - 1)};
  whole.seeds = {n};
  const Partition p = cut_up(two, {disc(two, 0, 10, 10, 4), whole});
  CHECK(area_of(p, 1) == doctest::Approx(4.5));
}

TEST_CASE("cuts through vertices and along edges") {
  const mesh::Surface s = forms::plane(20, 20, 20, 20);
  // A square whose sides lie on edges of the grid, as the zero contour passes it: u = iso at its vertices. Its corners
  // are cut off along the diagonals of their cells.
  const Tooth square = tooth_of(
      s, 0, [](const Vec3 &p) { return std::max(std::abs(p.x() - 10), std::abs(p.y() - 10)); }, 4);
  CHECK(area_of(cut_up(s, {square}), 0) == doctest::Approx(62).epsilon(1e-12));
  // By hand, with points at the ends of edges, counter-clockwise.
  Tooth by_hand;
  by_hand.group = 1;
  by_hand.seeds = {10 * 21 + 10};
  Cut cut;
  cut.line.closed = true;
  const auto add = [&](Index i, Index j) {
    const Index v = j * 21 + i;
    const Index other = s.other_end(s.vertex_edges[v].front(), v);
    cut.line.points.push_back({v, other, 0, s.position[v]});
  };
  for (Index i = 8; i < 12; ++i) add(i, 9);
  for (Index j = 9; j < 12; ++j) add(12, j);
  for (Index i = 12; i > 8; --i) add(i, 12);
  for (Index j = 12; j > 9; --j) add(8, j);
  by_hand.loops.push_back(cut);
  const Partition p = cut_up(s, {by_hand});
  CHECK(area_of(p, 0) == doctest::Approx(12).epsilon(1e-12));
  CHECK(p.triangle.size() == s.faces());
}

TEST_CASE("a cut that ends at the rim of the scan") {
  const mesh::Surface s = forms::plane(20, 20, 57, 43);
  const Tooth t = disc(s, 0, 0, 9.7, 4);
  REQUIRE(t.loops.size() == 1);
  REQUIRE(!t.loops[0].line.closed);
  CHECK(area_of(cut_up(s, {t}), 0) == doctest::Approx(pi * 8).epsilon(0.01));
}

TEST_CASE("what two cuts enclose is parted where the seeds are equally near, whichever tooth comes first") {
  const mesh::Surface s = forms::plane(20, 20, 57, 43);
  const Tooth a = disc(s, 0, 7, 10, 4), b = disc(s, 1, 12, 10, 4);
  const double alone = area_in(a.loops[0].line);
  const Partition p = cut_up(s, {a, b}), q = cut_up(s, {b, a});
  const double lens = 2 * 16 * std::acos(2.5 / 4) - 5 * std::sqrt(16 - 2.5 * 2.5);
  for (const Index k : {0u, 1u}) {
    CHECK(p.lost[k] == doctest::Approx(lens / 2).epsilon(0.05));
    CHECK(area_of(p, k) == doctest::Approx(alone - lens / 2).epsilon(0.01));
    CHECK(area_of(p, k) == doctest::Approx(area_of(q, 1 - k)).epsilon(1e-12));
  }
  // Where they meet is a straight line: no triangle of one lies across it.
  const double middle = (s.position[a.seeds[0]].x() + s.position[b.seeds[0]].x()) / 2;
  for (std::size_t i = 0; i < p.triangle.size(); ++i)
    for (const Index v : p.triangle[i]) {
      if (p.owner[i] == 0) CHECK(p.position[v].x() < middle + 0.05);
      if (p.owner[i] == 1) CHECK(p.position[v].x() > middle - 0.05);
    }
  // Three of them.
  const Partition three = cut_up(s, {a, b, disc(s, 2, 9.5, 13, 4)});
  for (const Index k : {0u, 1u, 2u}) CHECK(area_of(three, k) > 20);
}

TEST_CASE("two teeth with the same cut") {
  const mesh::Surface s = forms::plane(20, 20, 57, 43);
  const Tooth a = disc(s, 0, 10, 10, 4);
  Tooth b = a;
  b.group = 1;
  b.seeds = disc(s, 1, 12, 10, 1).seeds;
  const Partition p = cut_up(s, {a, b});
  CHECK(area_of(p, 0) + area_of(p, 1) == doctest::Approx(area_in(a.loops[0].line)).epsilon(1e-6));
  CHECK(area_of(p, 0) > 25);
  CHECK(area_of(p, 1) > 10);
}

TEST_CASE("what is cut off from a tooth's seeds goes to what it borders on") {
  const mesh::Surface s = forms::plane(20, 20, 57, 43);
  // A strip across a disc; its seeds are the nearer ones on all of it.
  const Tooth a = disc(s, 0, 10, 10, 5);
  Tooth strip = tooth_of(
      s, 1, [](const Vec3 &p) { return std::abs(p.x() - 13); }, 0.8);
  strip.seeds.clear();
  for (Index v = 0; v < s.vertices(); ++v)
    if (std::abs(s.position[v].x() - 13) < 0.4) strip.seeds.push_back(v);
  const Partition p = cut_up(s, {a, strip});
  for (std::size_t i = 0; i < p.triangle.size(); ++i)
    if (p.owner[i] == 0)
      for (const Index v : p.triangle[i]) CHECK(p.position[v].x() < 13);
  CHECK(p.lost[0] > 10);
}

TEST_CASE("a cut that does not part inside from outside is refused") {
  const mesh::Surface s = forms::plane(20, 20, 57, 43);
  // Between the two circles is the inside of one and the outside of the other.
  Tooth t = disc(s, 0, 10, 10, 4);
  t.loops.push_back(disc(s, 0, 10, 10, 2.5).loops[0]);
  CHECK_THROWS_WITH_AS(cut_up(s, {t}), "the cut of group 0 does not part it from the rest", Error);
  Tooth off = disc(s, 0, 10, 10, 4);
  auto &points = off.loops[0].line.points;
  points.erase(points.begin() + 5, points.begin() + 9);
  CHECK_THROWS_WITH_AS(cut_up(s, {off}), "two points of a cut that follow each other share no face", Error);
}
