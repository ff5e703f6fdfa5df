#include "api/features_handle.h"
#include "api/guard.h"
#include "api/model_handle.h"
#include "base/shown.h"
#include "features/detect.h"
#include "features/doubts.h"

using namespace ts::api;
using ts::AllocatorScope;
using ts::Error;
using ts::Fault;
using ts::features::FeatureSet;

namespace ts::api {
namespace {

constexpr uint32_t default_max_points = 8;  // findings: 3.7 in the mean, at most 8
constexpr double default_radius = 2.0;      // mm, about half the width of a cusp

ts_feature_options default_feature_options() {
  ts_feature_options o{};
  o.struct_size = sizeof o;
  o.max_points = default_max_points;
  o.radius = default_radius;
  return o;
}

features::DetectOptions detect_options(const ts_feature_options &o) {
  if (o.max_points < 1 || o.max_points > 64)
    throw Error(Fault::invalid_argument, "max_points is " + std::to_string(o.max_points) + ", must be 1 to 64");
  if (!(o.radius >= 0.5 && o.radius <= 5))
    throw Error(Fault::invalid_argument, "radius is " + shown(o.radius) + ", must be 0.5 to 5 mm");
  features::DetectOptions d;
  d.max_points = o.max_points;
  d.radius = o.radius;
  d.occlusal = point_of(o.occlusal, "occlusal");
  return d;
}

static_assert(static_cast<uint32_t>(features::Doubt::inside_out) == TS_WARN_FEATURES_INSIDE_OUT);
static_assert(static_cast<uint32_t>(features::Doubt::opposed) == TS_WARN_FEATURES_OPPOSED);
static_assert(static_cast<uint32_t>(features::Doubt::several_arches) == TS_WARN_FEATURES_SEVERAL_ARCHES);

void write_doubts(const Context &context, const features::Looks &looks) {
  const auto say = [&](const std::string &text) { context.write_log(TS_LOG_WARNING, "features: " + text); };
  if (looks.warnings & features::Doubt::inside_out) say("the faces of the mesh look inwards");
  if (looks.warnings & features::Doubt::opposed)
    say("teeth look both ways along the occlusal direction (" + shown(looks.opposed) +
        " of the roughness that looks with it looks against it): two jaws in occlusion?");
  if (looks.warnings & features::Doubt::several_arches)
    say("only " + shown(looks.coverage) + " of the roughness lies near the arch curve of " + shown(looks.length) +
        " mm: more than one arch?");
}

// Edits a copy and puts it in place at the end, so that a failure leaves the set as it was.
template <class Edit>
void edit(ts_features &handle, Edit &&change) {
  const AllocatorScope scope(handle.state->model->context->allocator);
  auto next = std::make_shared<FeaturesState>(*handle.state);
  change(next->set, *next->model);
  handle.state = std::move(next);
}

mesh::SurfacePoint nearest(const ModelState &model, const double position[3]) {
  return model.nearest(point_of(position, "position"));
}

}  // namespace
}  // namespace ts::api

ts_status ts_feature_options_init(ts_feature_options *options, uint32_t struct_size) {
  return guarded(__func__, [&] {
    need(options, "options");
    write_struct(options, default_feature_options(), struct_size, "ts_feature_options");
  });
}

ts_status ts_detect_features(const ts_model *model, const ts_feature_options *options, ts_job *job, ts_features **out) {
  return guarded(__func__, [&] {
    need(model, "model");
    need(out, "out");
    const auto o = detect_options(read_options(options, default_feature_options(), "ts_feature_options"));
    const Context &context = *model->state->context;
    const AllocatorScope scope(context.allocator);
    const Stopwatch watch;
    const ts::Progress progress = progress_of(job);
    const ts::StopScope stop(progress);
    auto state = std::make_shared<FeaturesState>();
    state->model = model->state;
    state->set = FeatureSet(ts::features::detect(model->state->model.surface, o, *context.executor, progress));
    progress(1);
    state->ms = watch.ms();
    context.write_log(TS_LOG_INFO, "features: " + std::to_string(state->set.groups().size()) + " groups, " +
                                       std::to_string(state->set.points().size()) + " points");
    write_doubts(context, state->set.looks());
    *out = new ts_features{std::move(state)};
  });
}

ts_status ts_features_create(const ts_model *model, ts_features **out) {
  return guarded(__func__, [&] {
    need(model, "model");
    need(out, "out");
    auto state = std::make_shared<FeaturesState>();
    state->model = model->state;
    *out = new ts_features{std::move(state)};
  });
}

ts_status ts_features_clone(const ts_features *features, ts_features **out) {
  return guarded(__func__, [&] {
    need(features, "features");
    need(out, "out");
    *out = new ts_features{features->state};  // states are never changed in place
  });
}

void ts_features_destroy(ts_features *features) {
  delete features;
}

ts_status ts_features_get_info(const ts_features *features, ts_features_info *info) {
  return guarded(__func__, [&] {
    need(features, "features");
    need(info, "info");
    const FeatureSet &set = features->state->set;
    write_struct(info,
                 ts_features_info{0, static_cast<uint32_t>(set.groups().size()),
                                  static_cast<uint32_t>(set.points().size()), set.inside_out(), set.looks().warnings, 0,
                                  set.looks().opposed, set.looks().coverage, set.looks().length},
                 info->struct_size, "ts_features_info");
  });
}

ts_status ts_features_get_occlusal(const ts_features *features, double direction[3]) {
  return guarded(__func__, [&] {
    need(features, "features");
    need(direction, "direction");
    for (int k = 0; k < 3; ++k) direction[k] = features->state->set.occlusal()[k];
  });
}

ts_status ts_features_set_occlusal(ts_features *features, const double direction[3]) {
  return guarded(__func__, [&] {
    need(features, "features");
    const ts::mesh::Vec3 d = point_of(direction, "direction");
    if (!(d.norm() > 1e-12)) throw Error(Fault::invalid_argument, "direction has no length");
    edit(*features, [&](FeatureSet &set, const ModelState &) { set.set_occlusal(d.normalized()); });
  });
}

ts_status ts_features_get_arch(const ts_features *features, double *xyz, uint32_t capacity, uint32_t *count) {
  return guarded(__func__, [&] {
    need(features, "features");
    copy_out(features->state->set.arch(), 3, xyz, capacity, count,
             [](const ts::mesh::Vec3 &p, double *to) { std::copy_n(p.data(), 3, to); });
  });
}

ts_status ts_features_get_points(const ts_features *features, ts_feature_point *points, uint32_t capacity,
                                 uint32_t *count) {
  return guarded(__func__, [&] {
    need(features, "features");
    copy_out(features->state->set.points(), 1, points, capacity, count,
             [](const FeatureSet::Point &p, ts_feature_point *to) {
               *to = {p.id, p.group, p.vertex, p.by_hand, {p.position[0], p.position[1], p.position[2]}, p.convexity};
             });
  });
}

ts_status ts_features_get_groups(const ts_features *features, ts_feature_group *groups, uint32_t capacity,
                                 uint32_t *count) {
  return guarded(__func__, [&] {
    need(features, "features");
    const auto &all = features->state->set.groups();
    copy_out(all, 1, groups, capacity, count, [&](const FeatureSet::Group &g, ts_feature_group *to) {
      const std::size_t i = static_cast<std::size_t>(&g - all.data());
      *to = {g.id,
             g.points,
             i > 0 ? all[i - 1].id : TS_NONE,
             i + 1 < all.size() ? all[i + 1].id : TS_NONE,
             {g.centre[0], g.centre[1], g.centre[2]},
             g.from,
             g.to,
             g.confidence};
    });
  });
}

ts_status ts_features_add_point(ts_features *features, const double position[3], uint32_t group, uint32_t *point,
                                uint32_t *group_out) {
  return guarded(__func__, [&] {
    need(features, "features");
    uint32_t id = TS_NONE, in = TS_NONE;
    edit(*features, [&](FeatureSet &set, const ModelState &model) {
      const ts::mesh::SurfacePoint at = nearest(model, position);
      const FeatureSet::Point &p = set.add_point(at.nearest_vertex(model.model.surface), at.position, group);
      id = p.id;
      in = p.group;
    });
    if (point) *point = id;
    if (group_out) *group_out = in;
  });
}

ts_status ts_features_move_point(ts_features *features, uint32_t point, const double position[3]) {
  return guarded(__func__, [&] {
    need(features, "features");
    edit(*features, [&](FeatureSet &set, const ModelState &model) {
      const ts::mesh::SurfacePoint at = nearest(model, position);
      set.move_point(point, at.nearest_vertex(model.model.surface), at.position);
    });
  });
}

ts_status ts_features_set_group(ts_features *features, uint32_t point, uint32_t group, uint32_t *group_out) {
  return guarded(__func__, [&] {
    need(features, "features");
    uint32_t in = TS_NONE;
    edit(*features, [&](FeatureSet &set, const ModelState &) { in = set.set_group(point, group); });
    if (group_out) *group_out = in;
  });
}

ts_status ts_features_remove_point(ts_features *features, uint32_t point) {
  return guarded(__func__, [&] {
    need(features, "features");
    edit(*features, [&](FeatureSet &set, const ModelState &) { set.remove_point(point); });
  });
}

ts_status ts_features_remove_group(ts_features *features, uint32_t group) {
  return guarded(__func__, [&] {
    need(features, "features");
    edit(*features, [&](FeatureSet &set, const ModelState &) { set.remove_group(group); });
  });
}
