#include <doctest/doctest.h>

#include <numbers>

#include "../geometry/forms.h"
#include "base/error.h"
#include "cut/contour.h"
#include "cut/reroute.h"
#include "cut/sides.h"

using namespace ts;
using namespace ts::cut;

namespace {

// A circle of radius 3 around (5, 5) on a plane, the inside on its left.
struct Circle {
  Surface s = forms::plane(10, 10, 50, 50);
  double radius(Index v) const { return (s.position[v] - Vec3(5, 5, 0)).norm(); }
  Vec<Polyline> lines = contour(
      s, [this](Index v) { return radius(v); }, 3, forms::every_face(s));
  const Polyline *line[1] = {&lines[0]};
  Space space{s};
  Vec<double> length = [this] {
    Vec<double> l;
    for (Index e = 0; e < s.edge.size(); ++e) l.push_back(s.edge_length(e));
    return l;
  }();

  const EdgePoint &nearest(double x, double y) const {
    return *std::ranges::min_element(lines[0].points, {},
                                     [&](const EdgePoint &p) { return (p.position - Vec3(x, y, 0)).norm(); });
  }
  Index vertex(double x, double y) const {
    Index best = 0;
    for (Index v = 0; v < s.vertices(); ++v)
      if ((s.position[v] - Vec3(x, y, 0)).norm() < (s.position[best] - Vec3(x, y, 0)).norm()) best = v;
    return best;
  }
};

}  // namespace

TEST_CASE("a line gives back the sides that it was made of") {
  Circle c;
  REQUIRE(c.lines.size() == 1);
  mark_sides(c.s, c.line, c.space);
  std::size_t wrong = 0, beside = 0;
  for (Index v = 0; v < c.s.vertices(); ++v) {
    wrong += ((c.space.marks[v] & kWithin) != 0) != (c.radius(v) < 3);
    beside += (c.space.marks[v] & kBeside) != 0;
  }
  CHECK(wrong == 0);
  CHECK(beside > 20);
  const CrossedEdges crossed(c.s, c.line);
  CHECK(crossed.all().size() == c.lines[0].points.size());
  CHECK(crossed.find(0) == nullptr);
  double area = 0;
  for (Index f = 0; f < c.s.faces(); ++f)
    area += c.s.face_area[f] * share_within(
                                   c.s, f, [&](Index v) { return c.radius(v) < 3; }, crossed);
  CHECK(area == doctest::Approx(9 * std::numbers::pi).epsilon(0.003));
  take_within(c.s, crossed, c.space);
  CHECK(area_of(c.s, faces_of(c.space.inside)) == doctest::Approx(area).epsilon(0.02));
}

TEST_CASE("a border led another way takes in what lies between, and nothing across the rest of it") {
  for (const double to : {4.2, 1.5}) {
    Circle c;
    mark_sides(c.s, c.line, c.space);
    take_within(c.s, CrossedEdges(c.s, c.line), c.space);
    const double before = area_of(c.s, faces_of(c.space.inside));
    Reroute border(c.s, c.space);
    // From (5 + 3, 5 - 1) to (5 + 3, 5 + 1), the inside on the left.
    const Index from = border.nearest(c.nearest(7.8, 4), c.length, 1),
                end = border.nearest(c.nearest(7.8, 6), c.length, 1);
    REQUIRE(border.on_border(from));
    border.free_stretch(from, end, c.length, 5);
    CHECK(border.freed().size() > 5);
    CHECK(!border.barred(border.freed()[3]));
    const Index by = c.vertex(5 + to, 5);
    border.bolt(from), border.bolt(end);
    const auto price = [&](Index e) { return c.length[e]; };
    Vec<Index> way = border.cheapest(from, by, price), rest = border.cheapest(by, end, price);
    REQUIRE(!way.empty());
    REQUIRE(!rest.empty());
    way.insert(way.end(), rest.begin() + 1, rest.end());
    const Index seed[] = {c.vertex(4, 5)};
    border.take(way, seed);
    const double after = area_of(c.s, faces_of(c.space.faces));
    // A triangle of height 1.2 or 1.5 over some 2.
    CHECK((to > 3 ? after - before : before - after) > 0.7);
    CHECK(std::abs(after - before) < 2.5);
  }
  Circle c;
  mark_sides(c.s, c.line, c.space);
  take_within(c.s, CrossedEdges(c.s, c.line), c.space);
  Reroute border(c.s, c.space);
  const Index from = border.nearest(c.nearest(7.8, 4), c.length, 1),
              end = border.nearest(c.nearest(7.8, 6), c.length, 1);
  const auto price = [&](Index e) { return c.length[e]; };
  // The other way round is longer than is allowed.
  CHECK_THROWS_AS(border.free_stretch(end, from, c.length, 5), Error);
  border.free_stretch(from, end, c.length, 5);
  CHECK(border.cheapest(c.vertex(1, 5), c.vertex(4, 5), price).empty() == false);  // through what was freed
  for (const Index v : border.freed()) border.bolt(v);
  CHECK(border.cheapest(c.vertex(1, 5), c.vertex(4, 5), price).empty());
  for (const Index v : border.freed()) border.unbolt(v);
  // A seed that the new border leaves out.
  const Vec<Index> straight = border.cheapest(from, end, price);
  const Index seeds[] = {c.vertex(4, 5), c.vertex(8.8, 5)};
  CHECK_THROWS_AS(border.take(straight, seeds), Error);
}
