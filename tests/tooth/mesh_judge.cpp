#include "mesh_judge.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#ifdef TOOTHSEG_TESTS_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#endif

namespace judge {
namespace {

struct Traits : OpenMesh::DefaultTraits {
  typedef OpenMesh::Vec3d Point;
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

bool build(const std::vector<Point> &points, const std::vector<Face> &faces, Mesh &mesh) {
  std::vector<OpenMesh::VertexHandle> vertex;
  for (const Point &p : points) vertex.push_back(mesh.add_vertex({p[0], p[1], p[2]}));
  for (const Face &f : faces)
    if (!mesh.add_face(vertex[f[0]], vertex[f[1]], vertex[f[2]]).is_valid()) return false;
  for (const auto v : mesh.vertices())
    if (!mesh.is_manifold(v)) return false;
  return true;
}

}  // namespace

bool manifold_and_oriented(const std::vector<Point> &points, const std::vector<Face> &faces) {
  Mesh mesh;
  return build(points, faces, mesh);
}

bool watertight(const std::vector<Point> &points, const std::vector<Face> &faces) {
  Mesh mesh;
  if (!build(points, faces, mesh)) return false;
  for (const auto e : mesh.edges())
    if (mesh.is_boundary(e)) return false;
  return true;
}

#ifdef TOOTHSEG_TESTS_CGAL

bool has_cgal() {
  return true;
}

std::vector<std::array<std::size_t, 2>> crossings_near(const std::vector<Point> &points, const std::vector<Face> &faces,
                                                       const std::vector<std::uint8_t> &vertex_is_near) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  using Vertex = CGAL::Surface_mesh<Kernel::Point_3>::Vertex_index;
  for (const Point &p : points) mesh.add_vertex({p[0], p[1], p[2]});
  for (const Face &f : faces) mesh.add_face(Vertex(f[0]), Vertex(f[1]), Vertex(f[2]));
  using FaceIndex = CGAL::Surface_mesh<Kernel::Point_3>::Face_index;
  std::vector<std::pair<FaceIndex, FaceIndex>> all;
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(all));
  std::vector<std::array<std::size_t, 2>> near;
  const auto is_near = [&](std::size_t f) {
    for (const std::uint32_t v : faces[f])
      if (vertex_is_near[v]) return true;
    return false;
  };
  for (const auto &[a, b] : all)
    if (is_near(a) || is_near(b)) near.push_back({std::size_t(a), std::size_t(b)});
  return near;
}

#else

bool has_cgal() {
  return false;
}

std::vector<std::array<std::size_t, 2>> crossings_near(const std::vector<Point> &, const std::vector<Face> &,
                                                       const std::vector<std::uint8_t> &) {
  return {};
}

#endif

}  // namespace judge
