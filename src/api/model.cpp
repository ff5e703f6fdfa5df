#include "api/guard.h"
#include "api/model_handle.h"
#include "base/shown.h"
#include "mesh/read.h"

using namespace ts::api;
using ts::AllocatorScope;
using ts::Error;
using ts::Fault;
using ts::mesh::SurfacePoint;
using ts::mesh::Vec3;

namespace ts::api {
namespace {

static_assert(static_cast<int>(mesh::Unit::checked_mm) == TS_UNIT_CHECKED_MM);
static_assert(static_cast<int>(mesh::Unit::inch) == TS_UNIT_INCH);
static_assert(static_cast<int>(mesh::Format::automatic) == TS_FORMAT_AUTO);
static_assert(static_cast<int>(mesh::Format::off) == TS_FORMAT_OFF);

ts_intake_options default_intake_options() {
  ts_intake_options o{};
  o.struct_size = sizeof o;
  o.unit = TS_UNIT_CHECKED_MM;
  return o;
}

mesh::IntakeOptions intake_options(const ts_intake_options *options) {
  const ts_intake_options o = read_options(options, default_intake_options(), "ts_intake_options");
  need_value(o.unit, TS_UNIT_INCH, "unit");
  if (!(o.weld_tolerance >= 0 && o.weld_tolerance <= 1))
    throw Error(Fault::invalid_argument, "weld_tolerance is " + shown(o.weld_tolerance) + ", must be 0 to 1 mm");
  return {static_cast<mesh::Unit>(o.unit), o.weld_tolerance};
}

mesh::RawMesh raw_from(const ts_mesh_input &in) {
  need_value(in.scalar, TS_FLOAT64, "scalar");
  if (in.vertex_count == 0 || (in.triangles && in.triangle_count == 0))
    throw Error(Fault::mesh_empty, "the mesh has no " + std::string(in.vertex_count ? "faces" : "vertices"));
  need(in.positions, "positions");
  return mesh::from_arrays(in.positions, static_cast<mesh::Scalar>(in.scalar), in.vertex_count, in.stride, in.triangles,
                           in.triangle_count);
}

// Reading (`read` yields a RawMesh) and intake, in the context's memory.
template <class Read>
void make(ts_context *context, const ts_intake_options *options, ts_job *job, ts_model **out, Read &&read) {
  need(context, "context");
  need(out, "out");
  const mesh::IntakeOptions o = intake_options(options);
  const AllocatorScope scope(context->state->allocator);
  const Stopwatch watch;
  const Progress progress = progress_of(job);
  const StopScope stop(progress);
  auto state = std::make_shared<ModelState>();
  state->context = context->state;
  mesh::RawMesh raw = read(progress.part(0, 0.3, "reading"));
  state->model = mesh::make_model(std::move(raw), o, *context->state->executor, progress.part(0.3, 1, "intake"));
  progress(1);
  state->ms = watch.ms();
  const mesh::IntakeReport &r = state->model.report;
  context->state->write_log(TS_LOG_INFO, "intake: " + std::to_string(r.vertices) + " vertices, " +
                                             std::to_string(r.faces) + " faces, " + std::to_string(r.components) +
                                             " components, " + std::to_string(r.boundary_loops) + " rims");
  *out = new ts_model{std::move(state)};
}

void write_surface_point(const mesh::Surface &surface, const SurfacePoint &p, ts_surface_point *out) {
  *out = {p.face,
          p.nearest_vertex(surface),
          {p.barycentric[0], p.barycentric[1], p.barycentric[2]},
          {p.position[0], p.position[1], p.position[2]},
          p.distance};
}

}  // namespace
}  // namespace ts::api

ts_status ts_mesh_input_init(ts_mesh_input *input, uint32_t struct_size) {
  return guarded(__func__, [&] {
    need(input, "input");
    ts_mesh_input o{};
    o.scalar = TS_FLOAT64;
    write_struct(input, o, struct_size, "ts_mesh_input");
  });
}

ts_status ts_intake_options_init(ts_intake_options *options, uint32_t struct_size) {
  return guarded(__func__, [&] {
    need(options, "options");
    write_struct(options, default_intake_options(), struct_size, "ts_intake_options");
  });
}

ts_status ts_model_create(ts_context *context, const ts_mesh_input *input, const ts_intake_options *options,
                          ts_job *job, ts_model **out) {
  return guarded(__func__, [&] {
    need(input, "input");
    const ts_mesh_input in = read_options(input, ts_mesh_input{}, "ts_mesh_input");
    make(context, options, job, out, [&](const ts::Progress &) { return raw_from(in); });
  });
}

ts_status ts_model_load(ts_context *context, const char *path, const ts_intake_options *options, ts_job *job,
                        ts_model **out) {
  return guarded(__func__, [&] {
    need(path, "path");
    make(context, options, job, out, [&](const ts::Progress &progress) { return ts::mesh::load_mesh(path, progress); });
  });
}

ts_status ts_model_read(ts_context *context, const void *bytes, size_t size, ts_file_format format,
                        const ts_intake_options *options, ts_job *job, ts_model **out) {
  return guarded(__func__, [&] {
    if (size) need(bytes, "bytes");
    need_value(format, TS_FORMAT_OFF, "format");
    make(context, options, job, out, [&](const ts::Progress &progress) {
      return ts::mesh::read_mesh({static_cast<const std::byte *>(bytes), size}, static_cast<ts::mesh::Format>(format),
                                 progress);
    });
  });
}

void ts_model_destroy(ts_model *model) {
  delete model;
}

ts_status ts_model_get_report(const ts_model *model, ts_intake_report *report) {
  return guarded(__func__, [&] {
    need(model, "model");
    need(report, "report");
    const ts::mesh::IntakeReport &r = model->state->model.report;
    ts_intake_report o{};
    o.input_vertices = r.input_vertices;
    o.input_faces = r.input_faces;
    o.polygons = r.polygons;
    o.welded_vertices = r.welded_vertices;
    o.unreferenced_vertices = r.unreferenced_vertices;
    o.degenerate_faces = r.degenerate_faces;
    o.duplicate_faces = r.duplicate_faces;
    o.flipped_faces = r.flipped_faces;
    o.non_manifold_edges = r.non_manifold_edges;
    o.non_manifold_vertices = r.non_manifold_vertices;
    o.unorientable_edges = r.unorientable_edges;
    o.vertices = r.vertices;
    o.faces = r.faces;
    o.components = r.components;
    o.boundary_loops = r.boundary_loops;
    o.diagonal = r.diagonal;
    o.area = r.area;
    o.mean_edge = r.mean_edge;
    write_struct(report, o, report->struct_size, "ts_intake_report");
  });
}

ts_status ts_model_get_positions(const ts_model *model, double *xyz, uint32_t capacity, uint32_t *count) {
  return guarded(__func__, [&] {
    need(model, "model");
    copy_out(model->state->model.surface.position, 3, xyz, capacity, count,
             [](const Vec3 &p, double *to) { std::copy_n(p.data(), 3, to); });
  });
}

ts_status ts_model_get_triangles(const ts_model *model, uint32_t *triangles, uint32_t capacity, uint32_t *count) {
  return guarded(__func__, [&] {
    need(model, "model");
    copy_out(model->state->model.surface.triangle, 3, triangles, capacity, count,
             [](const ts::mesh::Triangle &t, uint32_t *to) { std::copy_n(t.data(), 3, to); });
  });
}

ts_status ts_model_get_face_sources(const ts_model *model, uint32_t *input_face, uint32_t capacity, uint32_t *count) {
  return guarded(__func__, [&] {
    need(model, "model");
    copy_out(model->state->model.face_source, input_face, capacity, count);
  });
}

ts_status ts_model_get_vertex_map(const ts_model *model, uint32_t *model_vertex, uint32_t capacity, uint32_t *count) {
  return guarded(__func__, [&] {
    need(model, "model");
    copy_out(model->state->model.vertex_map, model_vertex, capacity, count);
  });
}

ts_status ts_model_nearest(const ts_model *model, const double position[3], ts_surface_point *out) {
  return guarded(__func__, [&] {
    need(model, "model");
    need(position, "position");
    need(out, "out");
    write_surface_point(model->state->model.surface, model->state->nearest(point_of(position, "position")), out);
  });
}

ts_status ts_model_raycast(const ts_model *model, const double origin[3], const double direction[3],
                           ts_surface_point *out) {
  return guarded(__func__, [&] {
    need(model, "model");
    need(origin, "origin");
    need(direction, "direction");
    need(out, "out");
    const Vec3 from = point_of(origin, "origin"), d = point_of(direction, "direction");
    if (!(d.norm() > 0)) throw Error(Fault::invalid_argument, "direction has no length");
    const auto hit = model->state->model.raycast(from, d);
    if (!hit) throw Error(Fault::not_found, "the ray misses the mesh");
    write_surface_point(model->state->model.surface, *hit, out);
  });
}
