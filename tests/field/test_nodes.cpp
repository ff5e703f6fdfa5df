#include <doctest/doctest.h>

#include "../geometry/forms.h"
#include "field/nodes.h"

using namespace ts;
using namespace ts::field;

TEST_CASE("a point is a disc of its radius, or its vertex alone") {
  const mesh::Surface s = forms::plane(10, 10, 50, 50);
  const Sites sites{{25 * 51 + 25}, {0}, 1};
  const Nodes disc = make_nodes(s, sites, {0.7, false, 13});
  REQUIRE(disc.size() == 1);
  for (const Index v : disc.vertices[0]) CHECK((s.position[v] - s.position[sites.point[0]]).norm() <= 0.7);
  CHECK(disc.vertices[0].size() >= 25);  // all within 0.7 along edges: a diamond at least
  const Nodes single = make_nodes(s, sites, {0, false, 13});
  REQUIRE(single.vertices[0].size() == 1);
  CHECK(single.vertices[0][0] == sites.point[0]);
}

TEST_CASE("discs share the ground between them; a point on another's vertex has no node") {
  const mesh::Surface s = forms::plane(10, 10, 50, 50);
  const Index a = 25 * 51 + 25, b = a + 4;
  const Nodes n = make_nodes(s, {{a, b, a}, {0, 1, 1}, 2}, {0.7, false, 13});
  REQUIRE(n.size() == 2);
  CHECK(n.group[0] == 0);
  CHECK(n.group[1] == 1);
  CHECK(n.of_vertex[a + 1] == 0);
  CHECK(n.of_vertex[b - 1] == 1);
  for (Index v = 0; v < s.vertices(); ++v)
    if (n.of_vertex[v] != mesh::none) {
      const double da = (s.position[v] - s.position[a]).norm(), db = (s.position[v] - s.position[b]).norm();
      CHECK((n.of_vertex[v] == 0 ? da <= db + 1e-9 : db <= da + 1e-9));
    }
}

TEST_CASE("gingiva is what is far from all points, and the rim where it is not near one") {
  const mesh::Surface s = forms::plane(40, 40, 80, 80);
  const Index point = 40 * 81 + 10;  // at (5, 20)
  const Nodes n = make_nodes(s, {{point}, {0}, 1}, {0.7, true, 13});
  REQUIRE(n.gingiva != mesh::none);
  for (Index v = 0; v < s.vertices(); ++v) {
    const double d = (s.position[v] - s.position[point]).norm();
    if (d > 13) CHECK(n.of_vertex[v] == n.gingiva);
    if (d < 13 / std::sqrt(2.0) && !s.on_boundary[v]) CHECK(n.of_vertex[v] != n.gingiva);
    if (d < 6 / std::sqrt(2.0)) CHECK(n.of_vertex[v] != n.gingiva);  // also on the rim
    if (s.on_boundary[v] && d > 6) CHECK(n.of_vertex[v] == n.gingiva);
  }
}

TEST_CASE("a piece of the surface without a point gets no gingiva") {
  mesh::Surface s = forms::plane(40, 40, 40, 40);
  Vec<mesh::Vec3> p = s.position;
  Vec<mesh::Triangle> t = s.triangle;
  const Index shift = static_cast<Index>(p.size());
  for (Index v = 0; v < shift; ++v) p.push_back(p[v] + mesh::Vec3(0, 0, 30));
  for (Index f = 0; f < s.faces(); ++f)
    t.push_back({s.triangle[f][0] + shift, s.triangle[f][1] + shift, s.triangle[f][2] + shift});
  s = mesh::make_surface(p, t);
  const Nodes n = make_nodes(s, {{20 * 41 + 20}, {0}, 1}, {0.7, true, 13});
  REQUIRE(n.gingiva != mesh::none);
  for (Index v = shift; v < 2 * shift; ++v) CHECK(n.of_vertex[v] == mesh::none);
}
