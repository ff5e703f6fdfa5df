#include "bench/bench_pipeline.h"

#include <stdexcept>
#include <string>

#include "api/segmentation_handle.h"
#include "bench/bench_figures.h"

namespace ts::bench {
namespace {

Pipeline with_context(unsigned threads, const ts_context_options *hooks) {
  Pipeline p;
  ts_context_options options;
  need_ok(ts_context_options_init(&options, sizeof options), "ts_context_options_init");
  options.threads = threads;
  if (hooks) options.alloc = hooks->alloc, options.free = hooks->free, options.alloc_user = hooks->alloc_user;
  ts_context *context = nullptr;
  need_ok(ts_context_create(&options, &context), "ts_context_create");
  p.context.reset(context);
  return p;
}

void make_ready(Pipeline &p) {
  ts_features *features = nullptr;
  p.features_ms =
      ms_of([&] { need_ok(ts_detect_features(p.model.get(), nullptr, nullptr, &features), "ts_detect_features"); });
  p.features.reset(features);
  ts_segmentation *segmentation = nullptr;
  p.segmentation_ms = ms_of(
      [&] { need_ok(ts_segmentation_create(features, nullptr, nullptr, &segmentation), "ts_segmentation_create"); });
  p.segmentation.reset(segmentation);
}

}  // namespace

void need_ok(ts_status status, const char *what) {
  if (status != TS_OK)
    throw std::runtime_error(std::string(what) + ": " + ts_status_name(status) + ", " + ts_last_error_message());
}

Pipeline take_in(const Mesh &mesh, unsigned threads, const ts_context_options *hooks) {
  Pipeline p = with_context(threads, hooks);
  ts_mesh_input input;
  need_ok(ts_mesh_input_init(&input, sizeof input), "ts_mesh_input_init");
  input.scalar = TS_FLOAT32;
  input.positions = mesh.xyz.data();
  input.vertex_count = mesh.vertices();
  input.triangles = mesh.triangles.data();
  input.triangle_count = mesh.faces();
  ts_model *model = nullptr;
  p.intake_ms =
      ms_of([&] { need_ok(ts_model_create(p.context.get(), &input, nullptr, nullptr, &model), "ts_model_create"); });
  p.model.reset(model);
  return p;
}

Pipeline prepare(const Mesh &mesh, unsigned threads, const ts_context_options *hooks) {
  Pipeline p = take_in(mesh, threads, hooks);
  make_ready(p);
  return p;
}

Pipeline prepare(Mesh &&mesh, unsigned threads, const ts_context_options *hooks) {
  Pipeline p = take_in(mesh, threads, hooks);
  mesh = Mesh();
  make_ready(p);
  return p;
}

ts_prepare_times prepare_times(const Pipeline &pipeline) {
  ts_prepare_times times{};
  times.struct_size = sizeof times;
  need_ok(ts_get_prepare_times(pipeline.segmentation.get(), &times), "ts_get_prepare_times");
  return times;
}

void forget_clicks(Pipeline &pipeline) {
  ts_segmentation &handle = *pipeline.segmentation;
  handle.session = tooth::Session(handle.prepared->surface());
}

std::vector<Point> proposed_clicks(const Pipeline &pipeline) {
  uint32_t count = 0;
  need_ok(ts_propose_clicks(pipeline.segmentation.get(), nullptr, 0, &count), "ts_propose_clicks");
  std::vector<Point> points(count);
  if (count > 0)
    need_ok(ts_propose_clicks(pipeline.segmentation.get(), points.data()->data(), count, &count), "ts_propose_clicks");
  return points;
}

std::vector<Point> points_on_teeth(const Pipeline &pipeline, std::uint64_t seed) {
  const ts_segmentation *s = pipeline.segmentation.get();
  const mesh::Surface &surface = surface_of(pipeline);
  uint32_t count = 0;
  need_ok(ts_get_teeth(s, nullptr, 0, &count), "ts_get_teeth");
  std::vector<uint32_t> teeth(count), faces;
  if (count > 0) need_ok(ts_get_teeth(s, teeth.data(), count, &count), "ts_get_teeth");
  std::vector<Point> points;
  for (const uint32_t tooth : teeth) {
    need_ok(ts_get_tooth_faces(s, tooth, nullptr, 0, &count), "ts_get_tooth_faces");
    if (count == 0) continue;
    faces.resize(count);
    need_ok(ts_get_tooth_faces(s, tooth, faces.data(), count, &count), "ts_get_tooth_faces");
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    const mesh::Triangle &t = surface.triangle[faces[(seed >> 33) % count]];
    const mesh::Vec3 middle = (surface.position[t[0]] + surface.position[t[1]] + surface.position[t[2]]) / 3;
    points.push_back({middle.x(), middle.y(), middle.z()});
  }
  return points;
}

unsigned click_all(Pipeline &pipeline, const std::vector<Point> &points) {
  std::vector<ts_status> status(points.size(), TS_OK);
  if (points.empty()) return 0;
  need_ok(ts_segment_clicks(pipeline.segmentation.get(), points.data()->data(), static_cast<uint32_t>(points.size()),
                            nullptr, status.data()),
          "ts_segment_clicks");
  unsigned failed = 0;
  for (const ts_status s : status) failed += s != TS_OK;
  return failed;
}

const mesh::Surface &surface_of(const Pipeline &pipeline) {
  return pipeline.model->state->model.surface;
}

features::Features features_of(const Pipeline &pipeline) {
  return pipeline.features->state->set.features();
}

}  // namespace ts::bench
