#include "mesh/intake.h"

#include <cmath>

#include "mesh/check.h"
#include "mesh/clean.h"
#include "mesh/manifold.h"
#include "mesh/weld.h"

namespace ts::mesh {
namespace {

constexpr std::size_t kIntakeGrain = 1 << 14;

// Numbers the vertices that have a triangle, in the caller's order, renames the triangles' corners accordingly, leaves
// out the rows of the others, and gives the positions of those that stay.
Vec<Vec3> keep_used(const Vec<Vec3> &from, CleanFaces &clean, Vec<Index> &number, const Executor &executor) {
  Vec<Index> &start = clean.around.start;
  number.assign(from.size(), none);
  Index size = 0;
  for (std::size_t v = 0; v < number.size(); ++v)
    if (start[v] < start[v + 1]) {
      start[size] = start[v];
      number[v] = size++;
    }
  start[size] = start.back();
  start.resize(size + std::size_t{1});
  Vec<Vec3> position(size);
  executor.ranges(number.size(), kIntakeGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      if (number[v] != none) position[number[v]] = from[v];
  });
  if (size < number.size())
    executor.ranges(clean.triangle.size(), kIntakeGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t)
        for (Index &v : clean.triangle[t]) v = number[v];
    });
  return position;
}

void count_vertices(std::span<const Index> kept, std::span<const Index> number, IntakeReport &report) {
  for (std::size_t v = 0; v < kept.size(); ++v) {
    report.welded_vertices += kept[v] != v;
    report.unreferenced_vertices += kept[v] == v && number[v] == none;
  }
}

// The caller's faces of which a triangle was turned round; `source`: a triangle's face, ascending.
Index flipped_faces(std::span<const std::uint8_t> flipped, std::span<const Index> source) {
  Index count = 0, last = none;
  for (std::size_t t = 0; t < flipped.size(); ++t)
    if (flipped[t] && source[t] != last) last = source[t], ++count;
  return count;
}

void describe(const Surface &s, IntakeReport &report) {
  report.vertices = static_cast<Index>(s.vertices());
  report.faces = static_cast<Index>(s.faces());
  report.components = s.components;
  report.boundary_loops = static_cast<Index>(s.boundary.size());
  report.diagonal = s.diagonal;
  report.area = s.area;
  report.mean_edge = s.mean_edge;
}

}  // namespace

std::size_t Model::bytes() const {
  return surface.bytes() + bvh.bytes() + sizeof(Index) * (face_source.size() + vertex_map.size() + label_source.size());
}

Model make_model(RawMesh raw, const IntakeOptions &options, const Executor &executor, Progress progress) {
  if (!std::isfinite(options.weld_tolerance) || options.weld_tolerance < 0)
    throw Error(Fault::invalid_argument, "weld_tolerance is not a length");
  const Progress step = progress.part(0, 1, "intake");
  step(0);
  check_elements(raw, executor);
  to_millimetres(raw, options.unit, executor);
  step(0.1);
  const Vec<Index> kept = weld(raw.position, options.weld_tolerance, executor);
  step(0.25);
  CleanFaces clean = clean_faces(raw, kept, executor, progress.part(0.25, 0.4, "intake"));
  if (clean.triangle.empty()) throw Error(Fault::mesh_empty, "all faces of the mesh are degenerate");
  if (clean.triangle.size() > std::size_t{1} << 30) throw Error(Fault::mesh_too_large, "more than 2^30 triangles");

  Model model;
  IntakeReport &report = model.report;
  report.input_vertices = static_cast<Index>(raw.position.size());
  report.input_faces = static_cast<Index>(raw.faces());
  report.polygons = clean.polygons;
  report.degenerate_faces = clean.degenerate;
  report.duplicate_faces = clean.duplicate;
  Vec<Index> number;
  Vec<Vec3> position = keep_used(raw.position, clean, number, executor);
  count_vertices(kept, number, report);
  model.vertex_map.resize(kept.size());
  for (std::size_t v = 0; v < kept.size(); ++v) model.vertex_map[v] = number[kept[v]];
  model.face_source = std::move(clean.source);
  model.label_source = std::move(clean.label);
  raw = {};
  step(0.4);

  Manifold manifold = make_manifold(position, std::move(clean.triangle), std::move(clean.around), executor);
  for (const Index v : manifold.copy_of) position.push_back(Vec3(position[v]));
  report.flipped_faces = flipped_faces(manifold.flipped, model.face_source);
  report.non_manifold_edges = manifold.non_manifold_edges;
  report.non_manifold_vertices = manifold.non_manifold_vertices;
  report.unorientable_edges = manifold.unorientable_edges;
  step(0.6);
  model.surface = make_surface(std::move(position), std::move(manifold.triangle), executor, std::move(manifold.links));
  describe(model.surface, report);
  step(0.8);
  model.bvh = Bvh(model.surface, executor);
  step(1);
  return model;
}

}  // namespace ts::mesh
