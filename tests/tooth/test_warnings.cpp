#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "made_up.h"
#include "tooth/segmenter.h"
#include "tooth/warnings.h"

using namespace ts;
using namespace ts::tooth;
using namespace made_up;

namespace {

// A row with an arch curve through its middles, and where each tooth stands on it.
Row on_an_arch(Index teeth) {
  Row r = row(teeth);
  for (double x = 0; x <= 2 * kMargin + kPitch * teeth; x += 1) r.features.arch.push_back({x, centre_y, kHeight});
  for (Index k = 0; k < teeth; ++k) {
    r.features.groups[k].from = centre_x(k) - kHalfWidth;
    r.features.groups[k].to = centre_x(k) + kHalfWidth;
  }
  return r;
}

Vec<Index> corners(const Row &r, double from, double to) {
  Vec<Index> vertices;
  for (Index v = 0; v < r.surface.vertices(); ++v)
    if (const double x = r.surface.position[v].x(); x >= from && x <= to) vertices.push_back(v);
  return vertices;
}

}  // namespace

TEST_CASE("the direction of the arch where a group stands") {
  Row r = on_an_arch(3);
  r.features.groups[1].from = r.features.groups[1].to = 0;  // by hand
  r.features.arch.back() = {r.features.arch.back().x(), centre_y + 30, 0};
  const Vec<Vec3> along = along_the_arch(r.features);
  REQUIRE(along.size() == 3);
  CHECK((along[0] - Vec3::UnitX()).norm() < 1e-12);
  CHECK(along[1].isZero());
  CHECK(std::abs(along[2].norm() - 1) < 1e-12);
  r.features.arch.clear();
  for (const Vec3 &a : along_the_arch(r.features)) CHECK(a.isZero());
}

TEST_CASE("a crown that is no tooth's width is said to be") {
  const Row r = on_an_arch(3);
  const Prepared p = prepare(r.surface, r.features, default_options(), one, {});
  const auto warned = [&](double from, double to) {
    return (warnings_of_place(p, 1, corners(r, from, to)) & Warning::width) != 0;
  };
  const double x = centre_x(1);
  CHECK(!warned(x - 3.4, x + 3.4));
  CHECK(!warned(x - 5, x + 6));
  CHECK(warned(x - 7.5, x + 7.5));  // 2.2 times its stretch of the arch, though not wider than any tooth
  CHECK(!warned(x - 2.5, x + 2.5));
  CHECK(warned(x - 2, x + 2));  // .6 of it
  CHECK((warnings_of_place(p, 1, {}) & Warning::width) == 0);

  // Where the place on the arch is not known, nothing is said.
  Row by_hand = row(3);
  const Prepared q = prepare(by_hand.surface, by_hand.features, default_options(), one, {});
  CHECK((warnings_of_place(q, 1, corners(by_hand, 0, 30)) & Warning::width) == 0);
}

TEST_CASE("no warning on good teeth; a stretch of the arch that does not fit one") {
  Row r = on_an_arch(3);
  r.features.groups[2].to = r.features.groups[2].from + 2.5;
  const Segmenter segmenter(r.surface, r.features, default_options(), one);
  for (const Tooth &t : segmenter.click(r.at(centre_x(0), centre_y)).teeth) CHECK(t.warnings == 0);
  const Click c = segmenter.click(r.at(centre_x(2), centre_y));
  REQUIRE(c.teeth[0].group == 2);
  CHECK(c.teeth[0].warnings == Warning::width);
}

TEST_CASE("a tooth with another group's point on it, used or freed") {
  Row r = on_an_arch(3);
  const Index v = r.vertex_at(centre_x(1), centre_y);
  r.features.groups[0].points.push_back({v, r.surface.position[v], 0.3});
  const Segmenter segmenter(r.surface, r.features, default_options(), one);
  REQUIRE(segmenter.rejected_points(0) == Vec<Index>{4});
  const Click c = segmenter.click(r.at(centre_x(1), centre_y));
  for (const Tooth &t : c.teeth) CHECK((t.warnings & Warning::two_groups) == (t.group == 1 ? Warning::two_groups : 0u));

  const Prepared p = prepare(r.surface, r.features, paper_options(), one, {});  // frees none
  CHECK((warnings_of_place(p, 2, corners(r, centre_x(1) - 3, centre_x(1) + 3)) & Warning::two_groups) != 0);
  CHECK((warnings_of_place(p, 2, corners(r, centre_x(2) - 3, centre_x(2) + 3)) & Warning::two_groups) == 0);
}

TEST_CASE("a post with a flat top is no crown, whichever way its faces look") {
  // A post of radius 2.5 and height 8, from its foot up; `bulge`: how much of a dome its top is, mm.
  const auto post = [](double bulge, bool inwards) {
    const Index around = 40, rings = 30, walls = 16;
    Vec<Vec3> p;
    Vec<mesh::Triangle> t;
    for (Index i = 0; i <= rings; ++i)
      for (Index k = 0; k < around; ++k) {
        const double a = 2 * std::numbers::pi * k / around,
                     in = i <= walls ? 1 : 1 - (i - walls) / (rings - walls + 0.5);
        const double h = i <= walls ? 8.0 * i / walls : 8 + bulge * (1 - in * in);
        p.push_back({2.5 * in * std::cos(a), 2.5 * in * std::sin(a), h});
      }
    for (Index i = 0; i < rings; ++i)
      for (Index k = 0; k < around; ++k) {
        const Index a = i * around + k, b = i * around + (k + 1) % around, c = a + around, d = b + around;
        t.push_back({a, b, d});
        t.push_back({a, d, c});
      }
    if (inwards)
      for (mesh::Triangle &x : t) std::swap(x[1], x[2]);
    return mesh::make_surface(std::move(p), std::move(t));
  };
  const auto warned = [](const mesh::Surface &s, bool inwards, const Vec3 &occlusal) {
    Vec<Index> all;
    for (Index f = 0; f < s.faces(); ++f) all.push_back(f);
    return warnings_of_shape(s, all, occlusal, inwards);
  };
  const Vec3 up = Vec3::UnitZ(), tilted = Vec3(0.3, 0, 1).normalized();
  for (const bool inwards : {false, true}) {
    CHECK(warned(post(0, inwards), inwards, up) == Warning::flat_top);
    CHECK(warned(post(0, inwards), inwards, tilted) == Warning::flat_top);
    CHECK(warned(post(0.1, inwards), inwards, up) == Warning::flat_top);
    CHECK(warned(post(1.5, inwards), inwards, up) == 0);
    CHECK(warned(post(0, inwards), inwards, Vec3::Zero()) == 0);  // by hand: no direction, nothing is said
  }
  CHECK(warnings_of_shape(post(0, false), {}, up, false) == 0);
}
