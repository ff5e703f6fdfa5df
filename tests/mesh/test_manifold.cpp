// Winding, edges of more than two faces, vertices of several fans; and OpenMesh as an independent judge of the results.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "shapes.h"

using namespace shapes;

namespace {

struct OpenMeshTraits : OpenMesh::DefaultTraits {
  typedef OpenMesh::Vec3d Point;
};

// OpenMesh refuses a face at a complex edge or vertex.
void check_with_openmesh(const Model &m) {
  OpenMesh::TriMesh_ArrayKernelT<OpenMeshTraits> mesh;
  const Surface &s = m.surface;
  std::vector<OpenMesh::VertexHandle> vertex;
  for (const Vec3 &p : s.position) vertex.push_back(mesh.add_vertex({p.x(), p.y(), p.z()}));
  for (const Triangle &t : s.triangle) REQUIRE(mesh.add_face(vertex[t[0]], vertex[t[1]], vertex[t[2]]).is_valid());
  CHECK(mesh.n_faces() == s.faces());
  CHECK(mesh.n_edges() == s.edge.size());
  for (const auto v : mesh.vertices()) CHECK(mesh.is_manifold(v));
  std::size_t rims = 0;
  std::set<int> seen;
  for (const auto h : mesh.halfedges()) {
    if (!mesh.is_boundary(h) || !seen.insert(h.idx()).second) continue;
    ++rims;
    for (auto g = mesh.next_halfedge_handle(h); g != h; g = mesh.next_halfedge_handle(g)) seen.insert(g.idx());
  }
  CHECK(rims == m.report.boundary_loops);
}

Model checked(const RawMesh &raw) {
  Model m = model_of(raw);
  check_promises(m);
  check_with_openmesh(m);
  return m;
}

// A closed band of n squares round the z axis with half a turn (Moebius) or none.
RawMesh band(Index n, bool twisted) {
  RawMesh raw;
  for (Index i = 0; i < n; ++i) {
    const double a = 2 * M_PI * i / n, half = twisted ? a / 2 : 0;
    const Vec3 out(std::cos(a), std::sin(a), 0), across = 2 * (std::cos(half) * Vec3::UnitZ() + std::sin(half) * out);
    raw.position.push_back(10 * out - across);
    raw.position.push_back(10 * out + across);
    const bool last = i == n - 1;
    Index a0 = 2 * i, a1 = 2 * i + 1, b0 = last ? 0 : 2 * i + 2, b1 = last ? 1 : 2 * i + 3;
    if (last && twisted) std::swap(b0, b1);
    for (const Index v : {a0, b0, b1, a0, b1, a1}) raw.corner.push_back(v);
  }
  return raw;
}

}  // namespace

TEST_CASE("a clean open mesh and a closed one pass OpenMesh too") {
  checked(hills(8));
  checked(cube({0, 0, 0}, 5));
}

TEST_CASE("faces wound against the rest are turned round") {
  RawMesh raw = hills(10);
  for (const std::size_t f : {0, 17, 18, 133}) turn_round(raw, f);
  const Model m = checked(raw);
  CHECK(m.report.flipped_faces == 4);
  CHECK(geometry(m.surface) == geometry(model_of(hills(10)).surface));
}

TEST_CASE("each piece keeps the winding of most of its area, not of most of its faces") {
  RawMesh few_large = triangles({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {10.1, 5, 0}, {10.2, 5, 1}},
                                {{0, 1, 2}, {0, 2, 3}, {1, 2, 4}, {4, 2, 5}});
  // The two large ones look up; of the two small ones the first follows the edge 1-2 the same way as its neighbour.
  const Model m = checked(few_large);
  CHECK(m.report.flipped_faces == 2);
  CHECK(m.surface.face_normal[0].z() == doctest::Approx(1));
  RawMesh all = cube({0, 0, 0}, 10);
  for (std::size_t f = 0; f < 12; ++f) turn_round(all, f);
  CHECK(checked(all).report.flipped_faces == 0);  // inside out is not decided here
}

TEST_CASE("a fin on a sheet comes off, the sheet stays whole") {
  RawMesh raw = plane(6);
  raw.position.push_back({3, 3.5, 4});
  for (const Index v : {24u, 31u, 49u}) raw.corner.push_back(v);  // on the edge from (3, 3) to (3, 4)
  const Model m = checked(raw);
  CHECK(m.report.non_manifold_edges == 1);
  CHECK(m.report.components == 2);
  CHECK(m.report.vertices == 49 + 1 + 2);
  CHECK(m.report.boundary_loops == 2);
  CHECK(m.vertex_map[24] == 24);
}

TEST_CASE("two sheets that cross in an edge come apart as two smooth sheets") {
  RawMesh raw = triangles({{0, 0, 0}, {0, 10, 0}, {-9, 5, 0.3}, {9, 5, 0.1}, {0.5, 5, -9}, {-0.4, 5, 9}},
                          {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 5}});
  const Model m = checked(raw);
  CHECK(m.report.non_manifold_edges == 1);
  CHECK(m.report.non_manifold_vertices == 2);
  CHECK(m.report.components == 2);
  CHECK(m.surface.component[0] == m.surface.component[1]);
  CHECK(m.surface.component[2] == m.surface.component[3]);
  CHECK(m.surface.component[0] != m.surface.component[2]);
}

TEST_CASE("two bodies that touch along an edge come apart") {
  const Model m = checked(soup(both(cube({0, 0, 0}, 10), cube({10, 10, 0}, 10))));
  CHECK(m.report.non_manifold_edges == 1);
  CHECK(m.report.components == 2);
  CHECK(m.report.vertices == 16);
  CHECK(m.report.boundary_loops == 0);
}

TEST_CASE("two bodies that touch in a vertex come apart") {
  const Model m = checked(soup(both(cube({0, 0, 0}, 10), cube({10, 10, 10}, 10))));
  CHECK(m.report.non_manifold_edges == 0);
  CHECK(m.report.non_manifold_vertices == 1);
  CHECK(m.report.components == 2);
  CHECK(m.report.vertices == 16);
}

TEST_CASE("an edge where more faces meet than any surface has comes apart altogether") {
  RawMesh raw;
  raw.position = {{0, 0, 0}, {0, 0, 10}};
  for (Index i = 0; i < 40; ++i) {
    raw.position.push_back({10 * std::cos(0.15 * i), 10 * std::sin(0.15 * i), 5});
    raw.corner.insert(raw.corner.end(), {0, 1, i + 2});
  }
  const Model m = checked(raw);
  CHECK(m.report.non_manifold_edges == 1);
  CHECK(m.report.components == 40);
}

TEST_CASE("a band is orientable, a Moebius band is cut open across") {
  const Model plain = checked(band(24, false));
  CHECK(plain.report.unorientable_edges == 0);
  CHECK(plain.report.boundary_loops == 2);
  const Model moebius = checked(band(24, true));
  CHECK(moebius.report.unorientable_edges == 1);
  CHECK(moebius.report.boundary_loops == 1);
  CHECK(moebius.report.components == 1);
  CHECK(moebius.report.vertices == 48 + 2);
}

TEST_CASE("a handle pinched to an edge is cut off at the pinch") {
  // Two sheets joined by a tube of triangles whose waist is squeezed to the edge from 8 to 9.
  RawMesh raw;
  raw.position = {{-5, -5, -6}, {5, -5, -6}, {5, 5, -6}, {-5, 5, -6}, {-5, -5, 6},
                  {5, -5, 6},   {5, 5, 6},   {-5, 5, 6}, {-3, 0, 0},  {3, 0, 0}};
  raw.corner = {0, 1, 9, 0, 9, 8, 1, 2, 9, 2, 3, 8, 2, 8, 9, 3, 0, 8,  //
                5, 4, 8, 5, 8, 9, 6, 5, 9, 7, 6, 9, 7, 9, 8, 4, 7, 8};
  const Model m = checked(raw);
  CHECK(m.report.non_manifold_edges == 1);
  CHECK(m.report.faces == 12);
}

TEST_CASE("the order of vertices and faces does not matter") {
  RawMesh raw = both(hills(9), cube({30, 0, 0}, 4));
  raw.position.push_back({3, 3.5, 9});
  for (const Index v : {33u, 43u, 108u}) raw.corner.push_back(v);
  for (const std::size_t f : {5, 60, 61, 100}) turn_round(raw, f);
  for (const Index v : {raw.corner[30], raw.corner[31], raw.corner[32], 4u, 4u, 5u}) raw.corner.push_back(v);
  const Model m = checked(raw);
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Model n = checked(shuffled(raw, seed));
    CHECK(geometry(n.surface) == geometry(m.surface));
    CHECK(n.report.flipped_faces == m.report.flipped_faces);
    CHECK(n.report.duplicate_faces == 1);
    CHECK(n.report.degenerate_faces == 1);
    CHECK(n.report.non_manifold_edges == m.report.non_manifold_edges);
    CHECK(n.report.non_manifold_vertices == m.report.non_manifold_vertices);
    CHECK(n.report.components == m.report.components);
    CHECK(n.report.boundary_loops == m.report.boundary_loops);
  }
}

TEST_CASE("random triangles over few vertices, the worst of meshes, become manifolds") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(0, 20);
    RawMesh raw;
    for (int i = 0; i < 9 + int(seed % 7); ++i) raw.position.push_back({place(random), place(random), place(random)});
    for (unsigned i = 0; i < 3 * (10 + seed); ++i)
      raw.corner.push_back(static_cast<Index>(random() % raw.position.size()));
    checked(raw);
  }
}
