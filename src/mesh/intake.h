// Intake: from a raw mesh to the model that all later rooms work on.
#pragma once

#include "base/executor.h"
#include "base/progress.h"
#include "mesh/bvh.h"
#include "mesh/raw_mesh.h"

namespace ts::mesh {

enum class Unit { checked_mm, mm, cm, m, inch };

struct IntakeOptions {
  Unit unit = Unit::checked_mm;
  double weld_tolerance = 0;  // mm; 0 = only exactly equal vertices
};

// The fields of ts_intake_report. What holds of the counts:
//   vertices = input_vertices - welded_vertices - unreferenced_vertices + copies made by splitting.
// A vertex that only dropped faces use counts as unreferenced.
struct IntakeReport {
  Index input_vertices = 0, input_faces = 0, polygons = 0, welded_vertices = 0, unreferenced_vertices = 0;
  Index degenerate_faces = 0, duplicate_faces = 0, flipped_faces = 0;
  Index non_manifold_edges = 0, non_manifold_vertices = 0, unorientable_edges = 0;
  Index vertices = 0, faces = 0, components = 0, boundary_loops = 0;
  double diagonal = 0, area = 0, mean_edge = 0;
};

struct Model {
  Surface surface;
  Bvh bvh;
  IntakeReport report;
  Vec<Index> face_source;   // a model face: the caller's face
  Vec<Index> vertex_map;    // a caller's vertex: the model's (the first of several), none if dropped
  Vec<Index> label_source;  // a caller's face: the model face whose label it takes; none if nothing touches it

  std::size_t bytes() const;

  SurfacePoint nearest(const Vec3 &p) const { return bvh.nearest(surface, p); }
  std::optional<SurfacePoint> raycast(const Vec3 &origin, const Vec3 &direction) const {
    return bvh.raycast(surface, origin, direction);
  }
};

// Throws mesh_empty, mesh_non_finite, mesh_index_range, mesh_units, mesh_too_large, invalid_argument, cancelled.
Model make_model(RawMesh raw, const IntakeOptions &options, const Executor &executor, Progress progress);

}  // namespace ts::mesh
