#include <doctest/doctest.h>

#include "forms.h"
#include "geometry/gradient.h"
#include "geometry/paths.h"

using namespace ts;
using namespace ts::geometry;

TEST_CASE("paths along the lines of a grid are exact, others a little long") {
  const Surface s = forms::plane(10, 10, 40, 40);
  const PathStart corner{0};
  const Vec<double> d = edge_distances(s, {&corner, 1});
  for (Index v = 0; v < s.vertices(); ++v) {
    const double x = s.position[v].x(), y = s.position[v].y(), straight = std::hypot(x, y);
    CHECK(d[v] >= straight - 1e-9);
    CHECK(d[v] <= x + y + 1e-9);
    if (x == 0 || y == 0) CHECK(d[v] == doctest::Approx(straight));
  }
}

TEST_CASE("a search stops at its limit, and a used finder finds the same again") {
  const Surface s = forms::plane(10, 10, 40, 40);
  PathFinder finder(s);
  const auto reached = [&](double limit) {
    Vec<std::pair<Index, double>> all;
    const PathStart start{820};
    finder.search(
        {&start, 1}, [&](Index e) { return s.edge_length(e); },
        [&](Index v, double d, Index) {
          if (d > limit) return false;
          all.push_back({v, d});
          return true;
        });
    return all;
  };
  const auto near = reached(1), far = reached(3);
  CHECK(near.size() > 20);
  CHECK(near.size() < 70);
  CHECK(std::equal(near.begin(), near.end(), far.begin()));  // in order of distance
  CHECK(reached(1) == near);
}

TEST_CASE("several starts: each vertex goes to the nearest; equal distances to the smaller tag") {
  const Surface s = forms::plane(10, 2, 20, 4);
  const Vec<PathStart> starts = {{0, 0, 7}, {20, 0, 3}};
  Vec<Index> tag(s.vertices(), mesh::none);
  PathFinder(s).search(
      starts, [&](Index e) { return s.edge_length(e); },
      [&](Index v, double, Index t) {
        tag[v] = t;
        return true;
      });
  for (Index i = 0; i <= 20; ++i) CHECK(tag[i] == (i < 10 ? 7 : 3));
}

TEST_CASE("a wall of costly edges is gone around") {
  const Surface s = forms::plane(10, 10, 20, 20);
  const auto cost = [&](Index e) {
    const double x = (s.position[s.edge[e][0]].x() + s.position[s.edge[e][1]].x()) / 2;
    const double y = (s.position[s.edge[e][0]].y() + s.position[s.edge[e][1]].y()) / 2;
    return s.edge_length(e) * (std::abs(x - 5.25) < 0.3 && y < 8 ? 100 : 1);
  };
  const PathStart start{0};
  double across = 0;
  PathFinder(s).search({&start, 1}, cost, [&](Index v, double d, Index) {
    if (v == 20) across = d;
    return true;
  });
  CHECK(across > 18);
  CHECK(across < 30);
}

TEST_CASE("the gradient of a linear function is exact on every face") {
  const Surface s = forms::sphere(3, 2);
  const mesh::Vec3 g(0.3, -2, 1.1);
  for (Index f = 0; f < s.faces(); ++f) {
    const auto &t = s.triangle[f];
    const mesh::Vec3 found =
        face_gradient(s, f, g.dot(s.position[t[0]]), g.dot(s.position[t[1]]), g.dot(s.position[t[2]]));
    const mesh::Vec3 in_plane = g - s.face_normal[f] * s.face_normal[f].dot(g);
    CHECK((found - in_plane).norm() < 1e-9);
  }
}

TEST_CASE("what is within a distance is what a search finds, and at the same distances, however uneven the costs") {
  const mesh::Surface s = forms::plane(10, 10, 40, 40);
  PathFinder finder(s);
  std::uint32_t state = 9;
  for (const double spread : {0.0, 2.0, 8.0}) {
    Vec<double> cost(s.edge.size());
    for (double &c : cost) {
      state = state * 1664525u + 1013904223u;
      c = std::pow(10.0, spread * (double(state >> 8) / 16777216.0 - 0.5));
    }
    const PathStart starts[] = {{5, 0}, {900, 0.25}};
    const auto of = [&](Index e) { return cost[e]; };
    for (const double limit : {0.5, 3.0, 1e9}) {
      Vec<double> expected(s.vertices(), -1), found(s.vertices(), -1);
      finder.search(starts, of, [&](Index v, double d, Index) {
        if (d > limit) return false;
        expected[v] = d;
        return true;
      });
      for (const Index v : finder.within(starts, of, limit)) found[v] = finder.distance(v);
      CHECK(found == expected);
    }
  }
}
