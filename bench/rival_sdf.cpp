#include "bench/rival_sdf.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#ifdef TOOTHSEG_BENCH_CGAL
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/mesh_segmentation.h>
#endif
#include "bench/bench_figures.h"

namespace ts::bench {

#ifndef TOOTHSEG_BENCH_CGAL

Outcome sdf_teeth(const Surface &, unsigned) {
  throw std::runtime_error("method sdf: this program was built without CGAL (Debian: libcgal-dev)");
}

#else

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using SdfMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = SdfMesh::Face_index;

// An open scan stays open. A plaster base under it (the border drawn down to a fan) was tried on three scans: up to two
// teeth of 14 more at IoU .5, none on the finest, for nine times the time there.
//
// Rays a facet: CGAL's default is 25. On large scans 12, for the values take most of the time and grow with both
// numbers; CGAL smooths them over neighbouring facets. What that costs in accuracy was not measured.
constexpr std::size_t kManyFaces = 150000, kRays = 25, kFewRays = 12;
constexpr double kCone = 2.0 / 3.0 * 3.14159265358979323846;  // CGAL's default, radians

// The grid. CGAL's defaults are 5 clusters and a lambda of 0.26.
constexpr std::size_t kClusters[] = {2, 3, 4, 5, 6};
constexpr double kLambdas[] = {0.1, 0.26, 0.5, 0.8};
constexpr double kLeastTooth = 15;  // mm^2; smaller segments are no teeth

SdfMesh mesh_of(const Surface &surface) {
  SdfMesh mesh;
  mesh.reserve(static_cast<Index>(surface.vertices()), static_cast<Index>(surface.edge.size()),
               static_cast<Index>(surface.faces()));
  for (const mesh::Vec3 &p : surface.position) mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
  for (const auto &[a, b, c] : surface.triangle)
    if (mesh.add_face(SdfMesh::Vertex_index(a), SdfMesh::Vertex_index(b), SdfMesh::Vertex_index(c)) ==
        SdfMesh::null_face())
      throw std::runtime_error("method sdf: CGAL refuses a face of the scan");
  return mesh;
}

// The largest segment is gingiva, those too small for a tooth nothing.
template <class Ids>
Teeth teeth_of(const Surface &surface, const Ids &ids, std::size_t segments) {
  Vec<double> area(segments, 0);
  for (Index f = 0; f < surface.faces(); ++f) area[ids[Face(f)]] += surface.face_area[f];
  Teeth teeth;
  teeth.regions = static_cast<unsigned>(segments);
  const auto largest = static_cast<std::size_t>(std::max_element(area.begin(), area.end()) - area.begin());
  Vec<Index> number(segments, 0);
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < segments; ++i) {
    if (i == largest || area[i] < kLeastTooth) continue;
    number[i] = ++teeth.count;
    sum += std::log(area[i]), squares += std::log(area[i]) * std::log(area[i]);
  }
  if (teeth.count > 0)
    teeth.spread = std::sqrt(std::max(0.0, squares / teeth.count - sum / teeth.count * sum / teeth.count));
  teeth.of_face.resize(surface.faces());
  for (Index f = 0; f < surface.faces(); ++f) teeth.of_face[f] = number[ids[Face(f)]];
  return teeth;
}

}  // namespace

Outcome sdf_teeth(const Surface &surface, unsigned wanted) {
  Outcome out;
  const Timer values;
  SdfMesh mesh = mesh_of(surface);
  const auto value = mesh.add_property_map<Face, double>("f:value", 0).first;
  const auto id = mesh.add_property_map<Face, std::size_t>("f:id", 0).first;
  const std::size_t rays = surface.faces() > kManyFaces ? kFewRays : kRays;
  CGAL::sdf_values(mesh, value, kCone, rays);
  const double values_ms = values.ms();
  double clusters = 0, lambda = 0;
  for (const std::size_t k : kClusters)
    for (const double l : kLambdas) {
      const Timer one;
      const std::size_t segments = CGAL::segmentation_from_sdf_values(mesh, value, id, k, l);
      Teeth teeth = teeth_of(surface, id, segments);
      const double ms = one.ms();
      out.search_ms += ms;
      if (out.tried++ > 0 && !fits_better(teeth, out.teeth, wanted)) continue;
      out.teeth = std::move(teeth);
      out.run_ms = values_ms + ms;
      clusters = static_cast<double>(k), lambda = l;
    }
  out.settings = {{"clusters", clusters}, {"lambda", lambda}, {"rays", static_cast<double>(rays)}};
  return out;
}

#endif

}  // namespace ts::bench
