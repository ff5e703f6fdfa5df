#include <doctest/doctest.h>

#include "../geometry/forms.h"
#include "cut/select.h"

using namespace ts;
using namespace ts::cut;

namespace {

Vec<double> field(const mesh::Surface &s, const auto &value) {
  Vec<double> u(s.vertices());
  for (Index v = 0; v < s.vertices(); ++v) u[v] = value(s.position[v]);
  return u;
}

auto of(const Vec<double> &u) {
  return [&u](Index v) { return u[v]; };
}

}  // namespace

TEST_CASE("the contour of a linear field on a plane is a straight line from border to border") {
  const mesh::Surface s = forms::plane(10, 4, 30, 12);
  const Vec<double> u = field(s, [](const Vec3 &p) { return 0.08 * p.x() + 0.02 * p.y(); });
  const Vec<Polyline> lines = contour(s, of(u), 0.431, forms::every_face(s));
  REQUIRE(lines.size() == 1);
  const Polyline &line = lines[0];
  CHECK(!line.closed);
  CHECK(line.faces.size() + 1 == line.points.size());
  for (const EdgePoint &p : line.points) {
    CHECK(0.08 * p.position.x() + 0.02 * p.position.y() == doctest::Approx(0.431));
    CHECK((p.position - ((1 - p.t) * s.position[p.a] + p.t * s.position[p.b])).norm() < 1e-12);
  }
  CHECK(line.length == doctest::Approx(std::hypot(4, 1)).epsilon(1e-4));
  CHECK(std::abs(line.points.front().position.y() - line.points.back().position.y()) == doctest::Approx(4));
  // u < iso is on the left: with it at smaller x, the line runs away from the viewer.
  CHECK(line.points.front().position.y() == doctest::Approx(0));
  const Score sc = score(s, of(u), Vec<double>(s.vertices(), 0.5), lines);
  CHECK(sc.gradient == doctest::Approx(std::hypot(0.08, 0.02)));
  CHECK(sc.harmonic == doctest::Approx(std::hypot(0.08, 0.02)));
  CHECK(sc.concavity == doctest::Approx(0.5));
}

TEST_CASE("the contours of height on a sphere are closed circles, low side on the left") {
  const mesh::Surface s = forms::sphere(5, 4);
  const Vec<double> u = field(s, [](const Vec3 &p) { return p.z(); });
  for (const double z : {-3.0, 0.0, 2.5}) {
    const Vec<Polyline> lines = contour(s, of(u), z, forms::every_face(s));
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].closed);
    CHECK(lines[0].points.size() == lines[0].faces.size());
    CHECK(lines[0].length == doctest::Approx(2 * forms::pi * std::sqrt(25 - z * z)).epsilon(0.01));
    double turn = 0;
    for (std::size_t i = 0; i < lines[0].points.size(); ++i) {
      const Vec3 &p = lines[0].points[i].position, &q = lines[0].points[(i + 1) % lines[0].points.size()].position;
      turn += std::atan2(p.x() * q.y() - p.y() * q.x(), p.x() * q.x() + p.y() * q.y());
    }
    CHECK(turn == doctest::Approx(-2 * forms::pi));  // the south on the left: clockwise seen from the north
  }
}

TEST_CASE("iso-values that vertices have exactly still give one closed line of distinct points") {
  const mesh::Surface s = forms::tube(2, 6, 24, 12);
  const Vec<double> u = field(s, [](const Vec3 &p) { return p.z(); });
  const Vec<Polyline> lines = contour(s, of(u), 3.0, forms::every_face(s));
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].closed);
  for (std::size_t i = 0; i < lines[0].points.size(); ++i) {
    const EdgePoint &p = lines[0].points[i], &q = lines[0].points[(i + 1) % lines[0].points.size()];
    CHECK((p.a != q.a || p.b != q.b));
    CHECK(p.t > 0);
    CHECK(p.t < 1);
  }
}

TEST_CASE("two bumps: two lines; faces with a NaN are not crossed; a part of the faces gives a part of the lines") {
  const mesh::Surface s = forms::plane(20, 10, 60, 30);
  Vec<double> u = field(
      s, [](const Vec3 &p) { return std::min(std::hypot(p.x() - 5, p.y() - 5), std::hypot(p.x() - 15, p.y() - 5)); });
  const Vec<Polyline> both = contour(s, of(u), 3, forms::every_face(s));
  REQUIRE(both.size() == 2);
  CHECK((both[0].closed && both[1].closed));
  Vec<Index> left;
  for (Index f = 0; f < s.faces(); ++f)
    if (s.position[s.triangle[f][0]].x() < 10) left.push_back(f);
  CHECK(contour(s, of(u), 3, left).size() == 1);
  for (Index v = 0; v < s.vertices(); ++v)
    if (s.position[v].x() > 15) u[v] = std::nan("");
  const Vec<Polyline> cut = contour(s, of(u), 3, forms::every_face(s));
  REQUIRE(cut.size() == 2);
  CHECK(cut[0].closed != cut[1].closed);
}

TEST_CASE("scores of all contours in one pass are those of the contours") {
  const mesh::Surface s = forms::torus(6, 2, 60, 24);
  const Vec<double> u = field(s, [](const Vec3 &p) { return (p.x() + 0.3 * p.z() + 8.7) / 17.4; });
  const Vec<double> c = field(s, [](const Vec3 &p) { return std::abs(p.y()) / 4; });
  const Vec<Score> all = score_all(s, u, c, 33);
  const Vec<Vec<Index>> crossed = crossed_faces(s, u, 33);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Vec<Polyline> lines = contour(s, of(u), iso_value(k, all.size()), forms::every_face(s));
    const Score one = score(s, of(u), c, lines);
    std::size_t faces = 0;
    for (const Polyline &line : lines) faces += line.faces.size();
    CHECK(crossed[k].size() == faces);
    CHECK(contour(s, of(u), iso_value(k, all.size()), crossed[k]).size() == lines.size());
    CHECK(all[k].length == doctest::Approx(one.length).epsilon(1e-4));
    CHECK(all[k].gradient == doctest::Approx(one.gradient).epsilon(1e-4));
    CHECK(all[k].concavity == doctest::Approx(one.concavity).epsilon(1e-4));
  }
}

TEST_CASE("histogram, Bin_max and the paper's pick on both sides of V_med") {
  Vec<double> u = {0, 0.05, 0.5, 0.51, 0.52, 0.58, 0.97, 1, std::nan(""), 1 + 1e-12, -1e-12};
  const Histogram h = histogram(u, 10);
  CHECK(h.bins == Vec<Index>{3, 0, 0, 0, 0, 4, 0, 0, 0, 3});
  CHECK(h.v_med == doctest::Approx(0.55));
  Vec<Score> scores(9);  // iso-values 0.1 to 0.9
  for (std::size_t k = 0; k < 9; ++k) scores[k] = {1, k == 2 ? 5.0 : k == 7 ? 4.0 : 1.0, 0, 1};
  scores[3] = {0, 100, 0, 100};  // no contour there
  const Chosen chosen = largest_gradient(scores, h.v_med);
  CHECK(chosen.target == 2);
  CHECK(chosen.neighbour == 7);
}
