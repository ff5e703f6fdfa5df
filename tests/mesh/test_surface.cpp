#include "shapes.h"

using namespace shapes;

namespace {

Surface surface_of(const RawMesh &raw) {
  Vec<Triangle> t;
  for (std::size_t f = 0; f < raw.faces(); ++f)
    t.push_back({raw.corner[3 * f], raw.corner[3 * f + 1], raw.corner[3 * f + 2]});
  return make_surface(raw.position, std::move(t));
}

}  // namespace

TEST_CASE("edges, twins and rows agree with the triangles") {
  const Surface s = surface_of(hills(6));
  CHECK(s.edge.size() == 3 * 36 + 2 * 6);  // Euler: V - E + F = 1
  CHECK(std::is_sorted(s.edge.begin(), s.edge.end()));
  for (Index h = 0; h < 3 * s.faces(); ++h) {
    const Edge &e = s.edge[s.edge_of[h]];
    CHECK(e == Edge{std::min(s.from(h), s.to(h)), std::max(s.from(h), s.to(h))});
    if (s.twin[h] == none) continue;
    CHECK(s.twin[s.twin[h]] == h);
    CHECK(s.from(s.twin[h]) == s.to(h));
    CHECK(s.edge_of[s.twin[h]] == s.edge_of[h]);
  }
  for (Index v = 0; v < s.vertices(); ++v) {
    CHECK(std::is_sorted(s.vertex_faces[v].begin(), s.vertex_faces[v].end()));
    CHECK(std::is_sorted(s.vertex_edges[v].begin(), s.vertex_edges[v].end()));
    for (const Index f : s.vertex_faces[v]) CHECK(std::count(s.triangle[f].begin(), s.triangle[f].end(), v) == 1);
    for (const Index e : s.vertex_edges[v]) CHECK((s.edge[e][0] == v || s.edge[e][1] == v));
  }
}

TEST_CASE("pieces are numbered by falling area") {
  const Surface s = surface_of(both(cube({0, 0, 0}, 1), both(cube({5, 0, 0}, 3), cube({10, 0, 0}, 2))));
  CHECK(s.components == 3);
  CHECK(s.component[0] == 2);
  CHECK(s.component[12] == 0);
  CHECK(s.component[24] == 1);
  CHECK(s.vertex_component[23] == 1);
  CHECK(s.boundary.size() == 0);
}

TEST_CASE("rims go with their half-edges, the longest first") {
  RawMesh raw = plane(6);
  raw.corner.erase(raw.corner.begin() + 3 * 28, raw.corner.begin() + 3 * 30);  // a hole of one square
  const Surface s = surface_of(raw);
  REQUIRE(s.boundary.size() == 2);
  CHECK(s.boundary[0].size() == 24);
  CHECK(s.boundary[1].size() == 4);
  CHECK(s.boundary_length[0] == doctest::Approx(24));
  CHECK(s.boundary_length[1] == doctest::Approx(4));
  const auto rim = s.boundary[0];
  CHECK(std::count(s.on_boundary.begin(), s.on_boundary.end(), 1) == 28);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    bool found = false;
    for (Index h = 0; h < 3 * s.faces(); ++h)
      found |= s.twin[h] == none && s.from(h) == rim[i] && s.to(h) == rim[(i + 1) % rim.size()];
    CHECK(found);
  }
}

TEST_CASE("an edge of three faces and one of two in the same direction are left without twins") {
  RawMesh raw = triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  for (const Index t : surface_of(raw).twin) CHECK(t == none);
  raw.corner = {0, 1, 2, 0, 1, 3};
  for (const Index t : surface_of(raw).twin) CHECK(t == none);
}
