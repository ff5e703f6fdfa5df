#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "tooth/split_face.h"

using namespace ts;
using namespace ts::tooth;

namespace {

// A right-angled triangle with sides of 1 and points on its sides; ids are places in the ring.
struct Face {
  Vec<RingPoint> ring;
  Vec<Vec3> position;
  Vec<Vec<Index>> pieces;
  Vec<Mark> marks;

  explicit Face(std::initializer_list<double> around) {  // 0 to 3: where along the border, the corners at 0, 1, 2
    for (const double at : around) {
      const auto k = static_cast<Eigen::Index>(at);
      const double t = at - static_cast<double>(k);
      const Vec3 weight = (1 - t) * Vec3::Unit(k) + t * Vec3::Unit((k + 1) % 3);
      ring.push_back({static_cast<Index>(ring.size()), weight});
      position.push_back({weight[1], weight[2], 0});
    }
  }
  void split(std::initializer_list<Chord> chords) {
    const Vec<Chord> all(chords);
    split_face(
        ring, all,
        [&](const Vec3 &w) {
          position.push_back({w[1], w[2], 0});
          return static_cast<Index>(position.size() - 1);
        },
        pieces, marks);
  }
  double area(std::span<const Index> ids) const {
    double twice = 0;
    for (std::size_t k = 1; k + 1 < ids.size(); ++k)
      twice += (position[ids[k]] - position[ids[0]]).cross(position[ids[k + 1]] - position[ids[0]]).z();
    return twice / 2;
  }
  double area() const {
    double sum = 0;
    for (const auto &p : pieces) {
      CHECK(area(p) > -1e-15);
      sum += area(p);
    }
    return sum;
  }
};

}  // namespace

TEST_CASE("one chord: two pieces, the tooth on its left") {
  Face f({0, 0.5, 1, 2, 2.5});
  f.split({{1, 4, 7}});
  REQUIRE(f.pieces.size() == 2);
  CHECK(f.area() == doctest::Approx(0.5));
  REQUIRE(f.marks.size() == 2);  // one of each piece's side, both the same
  CHECK(f.marks[0] == Mark{1, 4, 7});
  CHECK(f.marks[1] == f.marks[0]);
  // From (.5, 0) to (0, .5) the corner at the origin is on the left.
  for (const auto &p : f.pieces)
    for (std::size_t k = 0; k < p.size(); ++k)
      if (p[k] == 1 && p[(k + 1) % p.size()] == 4) CHECK(std::ranges::find(p, Index{0}) != p.end());
}

TEST_CASE("from a corner to the opposite side") {
  Face f({0, 1, 1.25, 2});
  f.split({{0, 2, 1}});
  REQUIRE(f.pieces.size() == 2);
  CHECK(f.area() == doctest::Approx(0.5));
  CHECK(std::min(f.area(f.pieces[0]), f.area(f.pieces[1])) == doctest::Approx(0.125));
}

TEST_CASE("two chords that meet inside the face share the point") {
  Face f({0, 0.3, 1, 1.5, 2, 2.2, 2.7});
  f.split({{1, 5, 1}, {6, 3, 2}});
  CHECK(f.pieces.size() == 4);
  CHECK(f.position.size() == 8);  // one more
  CHECK(f.area() == doctest::Approx(0.5));
  for (const auto &p : f.pieces) CHECK(std::ranges::find(p, Index{7}) != p.end());
  // Each half of each chord is a side of two pieces, in the chord's direction.
  CHECK(f.marks.size() == 8);
  std::sort(f.marks.begin(), f.marks.end());
  f.marks.erase(std::unique(f.marks.begin(), f.marks.end()), f.marks.end());
  CHECK(f.marks == Vec<Mark>{{1, 7, 1}, {6, 7, 2}, {7, 3, 2}, {7, 5, 1}});
}

TEST_CASE("any number of chords: the pieces are convex and add up") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> t(0.05, 0.95);
  for (int round = 0; round < 200; ++round) {
    Vec<double> at;
    for (int k = 0; k < 3; ++k) {
      at.push_back(k);
      Vec<double> on = {t(random), t(random), t(random)};
      std::sort(on.begin(), on.end());
      for (const double x : on) at.push_back(k + x);
    }
    Face f({});
    for (const double x : at) f.ring.push_back(Face({x}).ring[0]), f.position.push_back(Face({x}).position[0]);
    for (Index i = 0; i < f.ring.size(); ++i) f.ring[i].id = i;
    f.split({{1, 5, 0}, {6, 2, 1}, {9, 3, 2}, {10, 7, 3}, {0, 6, 4}, {11, 4, 5}});
    CHECK(f.area() == doctest::Approx(0.5).epsilon(1e-12));
    CHECK(f.pieces.size() >= 7);
    Vec<Triangle> triangles;
    for (const auto &p : f.pieces) triangulate_convex(f.position, p, triangles);
    double sum = 0;
    for (const Triangle &c : triangles) sum += f.area(c);
    CHECK(sum == doctest::Approx(0.5).epsilon(1e-12));
  }
}

TEST_CASE("three chords through one point: nothing is lost, whatever rounding makes of it") {
  for (const double e : {0.0, 1e-16, 1e-13, -1e-15}) {
    // Medians of the triangle.
    Face g({0, 0.5 + e, 1, 1.5, 2, 2.5});
    g.split({{0, 3, 1}, {2, 5, 2}, {4, 1, 3}});
    CHECK(g.area() == doctest::Approx(0.5).epsilon(1e-12));
    CHECK(g.pieces.size() >= 6);
  }
}

TEST_CASE("a polygon with corners in the middle of its sides gets no triangle without area") {
  Face f({0, 0.25, 0.5, 0.75, 1, 1.5, 2});
  Vec<Index> ids;
  for (const RingPoint &p : f.ring) ids.push_back(p.id);
  Vec<Triangle> triangles;
  triangulate_convex(f.position, ids, triangles);
  CHECK(triangles.size() == ids.size() - 2);
  for (const Triangle &c : triangles) CHECK(f.area(c) > 0.01);
}
