#include <cmath>

#include "api/guard.h"
#include "api/mesh_handle.h"
#include "mesh/write.h"
#include "tooth/frame.h"

using namespace ts::api;
using ts::AllocatorScope;
using ts::Error;
using ts::Fault;
using ts::mesh::Index;
using ts::mesh::Vec3;

namespace ts::api {
namespace {

static_assert(static_cast<int>(tooth::on_cut) == TS_VERTEX_ON_CUT);
static_assert(static_cast<int>(tooth::on_rim) == TS_VERTEX_ON_RIM);
static_assert(static_cast<int>(tooth::of_fill) == TS_VERTEX_OF_FILL);
static_assert(static_cast<int>(mesh::OutputFormat::stl) == TS_OUTPUT_STL);
static_assert(static_cast<int>(mesh::OutputFormat::glb) == TS_OUTPUT_GLB);

// The one place where parts are named.
std::string name_of(uint32_t label) {
  return label ? "tooth_" + std::to_string(label) : "gingiva";
}

// Steps of the golden ratio keep the hues of neighbours far apart.
mesh::OutputGroup group_for(uint32_t label) {
  mesh::OutputGroup group{name_of(label), label, {214, 160, 152}};
  const double hue = 6 * std::fmod(label * 0.6180339887498949, 1.0);
  for (std::size_t i = 0; label && i < 3; ++i) {
    const double towards = std::abs(std::fmod(hue + 6 - 2 * static_cast<double>(i), 6.0) - 3) - 1;
    group.colour[i] = static_cast<std::uint8_t>(80.5 + 160 * std::clamp(towards, 0.0, 1.0));
  }
  return group;
}

// All teeth, along the arch.
Vec<const tooth::Tooth *> teeth_of(const ts_segmentation &s) {
  Vec<const tooth::Tooth *> teeth;
  for (const Index group : s.session.teeth()) teeth.push_back(s.session.tooth(group));
  return teeth;
}

uint32_t label_of(const tooth::Tooth &tooth) {
  return tooth.group + 1;
}

ts_tooth_mesh_options default_mesh_options() {
  ts_tooth_mesh_options o{};
  o.struct_size = sizeof o;
  return o;
}

ts_save_options default_save_options() {
  ts_save_options o{};
  o.struct_size = sizeof o;
  return o;
}

void need_switch(uint32_t value, const char *name) {
  if (value > 1)
    throw Error(Fault::invalid_argument, std::string(name) + " is " + std::to_string(value) + ", must be 0 or 1");
}

mesh::OutputFormat inner_format(ts_output_format format) {
  need_value(format, TS_OUTPUT_GLB, "format");
  return static_cast<mesh::OutputFormat>(format);
}

// The mesh of `tooth`, or of the gingiva where that is null.
ts_mesh *make_part(const ts_segmentation &s, const tooth::Tooth *tooth, const ts_tooth_mesh_options *options,
                   ts_job *job) {
  const ts_tooth_mesh_options o = read_options(options, default_mesh_options(), "ts_tooth_mesh_options");
  need_switch(o.closed, "closed");
  const Prepared &p = *s.prepared;
  const Executor &executor = *p.context().executor;
  const AllocatorScope scope(p.context().allocator);
  const Progress progress = progress_of(job);
  const StopScope stop(progress);
  const Vec<const tooth::Tooth *> teeth = teeth_of(s);
  const tooth::Partition partition = tooth::partition(p.surface(), teeth);
  progress(0.2);
  auto state = std::make_shared<MeshState>();
  state->context = p.features->model->context;
  Index owner = mesh::none;
  if (tooth) {
    owner = static_cast<Index>(std::ranges::find(teeth, tooth) - teeth.begin());
    state->label = label_of(*tooth);
    state->lost = partition.lost[owner];
  }
  state->part = tooth::part_of(partition, owner, p.features->set.inside_out(), executor);
  if (o.closed) tooth::close(state->part, executor, progress.part(0.3, 1, "closing"));
  progress(1);
  return new ts_mesh{std::move(state)};
}

void copy_points(const Vec<Vec3> &points, double *xyz, uint32_t capacity, uint32_t *count) {
  copy_out(points, 3, xyz, capacity, count, [](const Vec3 &p, double *to) { std::copy_n(p.data(), 3, to); });
}

const tooth::PartMesh &part_in(const ts_mesh *mesh) {
  need(mesh, "mesh");
  return mesh->state->part;
}

}  // namespace
}  // namespace ts::api

ts_status ts_tooth_mesh_options_init(ts_tooth_mesh_options *options, uint32_t struct_size) {
  return guarded(__func__, [&] {
    need(options, "options");
    write_struct(options, default_mesh_options(), struct_size, "ts_tooth_mesh_options");
  });
}

ts_status ts_tooth_mesh_create(const ts_segmentation *segmentation, uint32_t tooth,
                               const ts_tooth_mesh_options *options, ts_job *job, ts_mesh **out) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    need(out, "out");
    *out = make_part(*segmentation, &find_tooth(segmentation, tooth), options, job);
  });
}

ts_status ts_gingiva_mesh_create(const ts_segmentation *segmentation, const ts_tooth_mesh_options *options, ts_job *job,
                                 ts_mesh **out) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    need(out, "out");
    *out = make_part(*segmentation, nullptr, options, job);
  });
}

void ts_mesh_destroy(ts_mesh *mesh) {
  delete mesh;
}

ts_status ts_mesh_get_info(const ts_mesh *mesh, ts_mesh_info *info) {
  return guarded(__func__, [&] {
    const ts::tooth::PartMesh &part = part_in(mesh);
    need(info, "info");
    ts_mesh_info i{};
    i.label = mesh->state->label;
    i.vertices = static_cast<uint32_t>(part.position.size());
    i.triangles = static_cast<uint32_t>(part.triangle.size());
    i.fill_triangles = static_cast<uint32_t>(std::ranges::count(part.source, ts::mesh::none));
    for (const auto f : part.flag) i.cut_vertices += (f & ts::tooth::on_cut) != 0;
    i.open_rims = part.loops;
    i.closed_rims = part.filled;
    i.components = part.components;
    i.trimmed = part.trimmed;
    i.area = part.area;
    i.fill_area = part.fill_area;
    i.volume = part.volume;
    i.lost = mesh->state->lost;
    write_struct(info, i, info->struct_size, "ts_mesh_info");
  });
}

ts_status ts_mesh_get_positions(const ts_mesh *mesh, double *xyz, uint32_t capacity, uint32_t *count) {
  return guarded(__func__, [&] { copy_points(part_in(mesh).position, xyz, capacity, count); });
}

ts_status ts_mesh_get_normals(const ts_mesh *mesh, double *xyz, uint32_t capacity, uint32_t *count) {
  return guarded(__func__, [&] { copy_points(part_in(mesh).normal, xyz, capacity, count); });
}

ts_status ts_mesh_get_triangles(const ts_mesh *mesh, uint32_t *triangles, uint32_t capacity, uint32_t *count) {
  return guarded(__func__, [&] {
    copy_out(part_in(mesh).triangle, 3, triangles, capacity, count,
             [](const ts::mesh::Triangle &t, uint32_t *to) { std::copy_n(t.data(), 3, to); });
  });
}

ts_status ts_mesh_get_faces(const ts_mesh *mesh, uint32_t *faces, uint32_t capacity, uint32_t *count) {
  return guarded(__func__, [&] { copy_out(part_in(mesh).source, faces, capacity, count); });
}

ts_status ts_mesh_get_vertex_flags(const ts_mesh *mesh, uint8_t *flags, uint32_t capacity, uint32_t *count) {
  return guarded(__func__, [&] { copy_out(part_in(mesh).flag, flags, capacity, count); });
}

ts_status ts_mesh_save(const ts_mesh *mesh, const char *path, ts_output_format format, ts_job *job) {
  return guarded(__func__, [&] {
    const ts::tooth::PartMesh &part = part_in(mesh);
    need(path, "path");
    const ts::mesh::OutputFormat inner = inner_format(format);
    const AllocatorScope scope(mesh->state->context->allocator);
    ts::mesh::OutputMesh out{part.position, part.triangle, {}, {}};
    out.group.push_back(group_for(mesh->state->label));
    const ts::Progress progress = progress_of(job);
    const ts::StopScope stop(progress);
    ts::mesh::save_mesh(path, inner, out, progress);
  });
}

ts_status ts_save_options_init(ts_save_options *options, uint32_t struct_size) {
  return guarded(__func__, [&] {
    need(options, "options");
    write_struct(options, default_save_options(), struct_size, "ts_save_options");
  });
}

ts_status ts_segmentation_save(const ts_segmentation *segmentation, const char *path, ts_output_format format,
                               const ts_save_options *options, ts_job *job) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    need(path, "path");
    const ts_save_options o = read_options(options, default_save_options(), "ts_save_options");
    need_switch(o.whole_faces, "whole_faces");
    const ts::mesh::OutputFormat inner = inner_format(format);
    const Prepared &p = *segmentation->prepared;
    const AllocatorScope scope(p.context().allocator);
    const ts::Progress progress = progress_of(job);
    const ts::StopScope stop(progress);
    const ts::Vec<const ts::tooth::Tooth *> teeth = teeth_of(*segmentation);
    ts::mesh::OutputMesh out;
    out.group.push_back(group_for(0));
    for (const ts::tooth::Tooth *t : teeth) out.group.push_back(group_for(label_of(*t)));
    ts::tooth::Partition partition;
    ts::Vec<Index> group_of;
    if (o.whole_faces) {
      const ts::Vec<std::uint32_t> labels = segmentation->session.labels();
      for (const std::uint32_t label : labels)
        group_of.push_back(
            static_cast<Index>(std::ranges::find(out.group, label, &ts::mesh::OutputGroup::label) - out.group.begin()));
      out.position = p.surface().position;
      out.triangle = p.surface().triangle;
    } else {
      partition = ts::tooth::partition(p.surface(), teeth);
      for (const Index owner : partition.owner) group_of.push_back(owner == ts::mesh::none ? 0 : owner + 1);
      out.position = partition.position;
      out.triangle = partition.triangle;
    }
    out.group_of = group_of;
    ts::mesh::save_mesh(path, inner, out, progress.part(0.3, 1, "writing"));
  });
}

ts_status ts_get_tooth_frame(const ts_segmentation *segmentation, uint32_t tooth, ts_tooth_frame *frame) {
  return guarded(__func__, [&] {
    const ts::tooth::Tooth &t = find_tooth(segmentation, tooth);
    need(frame, "frame");
    const Prepared &p = *segmentation->prepared;
    const ts::features::FeatureSet &set = p.features->set;
    if (!(set.occlusal().norm() > 0)) throw Error(Fault::invalid_argument, "the features have no occlusal direction");
    const ts::tooth::ToothFrame f = ts::tooth::frame_of(p.surface(), t, set.occlusal().normalized(), set.arch());
    ts_tooth_frame o{};
    o.from_arch = f.from_arch;
    std::copy_n(f.centre.data(), 3, o.centre);
    std::copy_n(f.occlusal.data(), 3, o.occlusal);
    std::copy_n(f.mesial.data(), 3, o.mesial);
    std::copy_n(f.buccal.data(), 3, o.buccal);
    o.width = f.width;
    o.depth = f.depth;
    o.height = f.height;
    write_struct(frame, o, frame->struct_size, "ts_tooth_frame");
  });
}
