#include "api/guard.h"
#include "api/segmentation_handle.h"

using namespace ts::api;
using ts::AllocatorScope;
using ts::Error;
using ts::Fault;
using ts::mesh::Vec3;

namespace ts::api {
namespace {

// The enums of options.h have the values of toothseg.h.
static_assert(static_cast<int>(tooth::Background::all) == TS_BACKGROUND_ALL);
static_assert(static_cast<int>(tooth::Background::gingiva) == TS_BACKGROUND_GINGIVA);
static_assert(static_cast<int>(tooth::CutRule::gradient) == TS_CUT_GRADIENT);
static_assert(static_cast<int>(tooth::CutRule::component) == TS_CUT_COMPONENT);
static_assert(static_cast<int>(tooth::CutRule::half) == TS_CUT_HALF);
static_assert(static_cast<int>(tooth::Preset::standard) == TS_PRESET_DEFAULT);
static_assert(static_cast<int>(tooth::Preset::paper) == TS_PRESET_PAPER);
static_assert(static_cast<int>(field::Scheme::concavity) == TS_WEIGHTS_CONCAVITY);
static_assert(static_cast<int>(field::Scheme::paper) == TS_WEIGHTS_PAPER);
static_assert(static_cast<int>(field::Scheme::cotangent) == TS_WEIGHTS_COTANGENT);
static_assert(static_cast<int>(field::Scheme::uniform) == TS_WEIGHTS_UNIFORM);
static_assert(static_cast<int>(field::Scheme::feature) == TS_WEIGHTS_FEATURE);

ts_segment_options public_options(ts_preset preset) {
  const tooth::Options d = preset == TS_PRESET_PAPER ? tooth::paper_options() : tooth::default_options();
  ts_segment_options o{};
  o.struct_size = sizeof o;
  o.preset = preset;
  o.weights = static_cast<ts_weights>(d.weights);
  o.background = static_cast<ts_background>(d.background);
  o.cut_rule = static_cast<ts_cut_rule>(d.cut_rule);
  o.contours = d.contours;
  o.histogram_bins = d.histogram_bins;
  o.points_per_group = d.points_per_group;
  o.alpha = d.alpha;
  o.beta = d.beta;
  o.gamma = d.gamma;
  o.theta = d.theta;
  o.c0 = d.c0;
  o.normal_radius = d.normal_radius;
  o.seed_radius = d.seed_radius;
  o.gingiva_distance = d.gingiva_distance;
  o.area_min = d.area_min;
  o.area_max = d.area_max;
  o.hole_area = d.hole_area;
  o.refine_band = d.refine_band;
  o.smooth_radius = d.smooth_radius;
  o.click_reach = d.click_reach;
  o.click_concavity = d.click_concavity;
  o.reject_outliers = d.reject_outliers;
  o.memory_limit = d.memory_limit;
  return o;
}

tooth::Options inner_options(const ts_segment_options &o) {
  need_value(o.preset, TS_PRESET_PAPER, "preset");
  need_value(o.weights, TS_WEIGHTS_FEATURE, "weights");
  need_value(o.background, TS_BACKGROUND_ALL, "background");
  need_value(o.cut_rule, TS_CUT_HALF, "cut_rule");
  need_value(o.reject_outliers, 1U, "reject_outliers");
  tooth::Options d = o.preset == TS_PRESET_PAPER ? tooth::paper_options() : tooth::default_options();
  d.weights = static_cast<field::Scheme>(o.weights);
  d.background = static_cast<tooth::Background>(o.background);
  d.cut_rule = static_cast<tooth::CutRule>(o.cut_rule);
  d.contours = o.contours;
  d.histogram_bins = o.histogram_bins;
  d.points_per_group = o.points_per_group;
  d.alpha = o.alpha;
  d.beta = o.beta;
  d.gamma = o.gamma;
  d.theta = o.theta;
  d.c0 = o.c0;
  d.normal_radius = o.normal_radius;
  d.seed_radius = o.seed_radius;
  d.gingiva_distance = o.gingiva_distance;
  d.area_min = o.area_min;
  d.area_max = o.area_max;
  d.hole_area = o.hole_area;
  d.refine_band = o.refine_band;
  d.smooth_radius = o.smooth_radius;
  d.click_reach = o.click_reach;
  d.click_concavity = o.click_concavity;
  d.reject_outliers = o.reject_outliers != 0;
  d.memory_limit = static_cast<std::size_t>(std::min<std::uint64_t>(o.memory_limit, SIZE_MAX));
  tooth::check(d);
  return d;
}

}  // namespace
}  // namespace ts::api

ts_status ts_segment_options_init(ts_segment_options *options, uint32_t struct_size, ts_preset preset) {
  return guarded(__func__, [&] {
    need(options, "options");
    need_value(preset, TS_PRESET_PAPER, "preset");
    write_struct(options, public_options(preset), struct_size, "ts_segment_options");
  });
}

ts_status ts_segmentation_create(const ts_features *features, const ts_segment_options *options, ts_job *job,
                                 ts_segmentation **out) {
  return guarded(__func__, [&] {
    need(features, "features");
    need(out, "out");
    const ts::tooth::Options o =
        inner_options(read_options(options, public_options(TS_PRESET_DEFAULT), "ts_segment_options"));
    const Context &context = *features->state->model->context;
    const AllocatorScope scope(context.allocator);
    const ts::Progress progress = progress_of(job);
    const ts::StopScope stop(progress);
    auto prepared = std::make_unique<Prepared>();
    prepared->features = features->state;
    prepared->segmenter = std::make_unique<const ts::tooth::Segmenter>(
        prepared->surface(), features->state->set.features(), o, *context.executor, progress);
    progress(1);
    ts::tooth::Session session(prepared->surface());
    *out = new ts_segmentation{std::move(prepared), std::move(session)};
  });
}

void ts_segmentation_destroy(ts_segmentation *segmentation) {
  delete segmentation;
}

ts_status ts_segment_click(ts_segmentation *segmentation, const double position[3], ts_job *job, uint32_t *click) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    const Vec3 at = point_of(position, "position");
    change(*segmentation, {Command::Act::click, ts::mesh::none, ts::mesh::none, {at}}, progress_of(job));
    if (click) *click = segmentation->session.clicks() - 1;
  });
}

ts_status ts_segment_clicks(ts_segmentation *segmentation, const double *positions, uint32_t count, ts_job *job,
                            ts_status *statuses) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    if (count) need(positions, "positions");
    need_quiet(*segmentation);
    Command command;
    command.act = Command::Act::clicks;
    for (uint32_t i = 0; i < count; ++i) command.at.push_back(point_of(positions + 3 * std::size_t{i}, "position"));
    const Prepared &p = *segmentation->prepared;
    const AllocatorScope scope(p.context().allocator);
    ts::Vec<ts::tooth::Segmenter::Outcome> outcomes;
    ts::tooth::Session next = execute(p, segmentation->session, command, progress_of(job), &outcomes);
    ts::Vec<ts_status> status;
    for (const auto &outcome : outcomes) {
      status.push_back(outcome.click ? TS_OK : status_of(outcome.fault));
      if (outcome.click) continue;
      const std::string what = "click " + std::to_string(status.size() - 1) + ": " + outcome.message;
      keep_message("ts_segment_clicks", what.c_str());
      p.context().write_log(TS_LOG_WARNING, what);
    }
    if (!command.at.empty()) commit(*segmentation, std::move(next), std::move(command));
    if (statuses) std::copy(status.begin(), status.end(), statuses);
  });
}

ts_status ts_propose_clicks(const ts_segmentation *segmentation, double *positions, uint32_t capacity,
                            uint32_t *count) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    const AllocatorScope scope(segmentation->prepared->context().allocator);
    const ts::tooth::Session &session = segmentation->session;
    copy_out(segmentation->prepared->segmenter->propose_clicks(session.teeth(), session.among()), 3, positions,
             capacity, count, [](const Vec3 &p, double *to) { std::copy_n(p.data(), 3, to); });
  });
}

ts_status ts_get_memory(const ts_segmentation *segmentation, ts_memory_info *info) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    need(info, "info");
    const Prepared &p = *segmentation->prepared;
    const ts::tooth::Memory m = p.segmenter->memory();
    write_struct(info,
                 ts_memory_info{0, 0, p.features->model->model.bytes(), m.kept, m.factor, m.factor_whole, m.click},
                 info->struct_size, "ts_memory_info");
  });
}

ts_status ts_get_prepare_times(const ts_segmentation *segmentation, ts_prepare_times *times) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    need(times, "times");
    const Prepared &p = *segmentation->prepared;
    const ts::tooth::PrepareTimes &t = p.segmenter->times();
    write_struct(times, ts_prepare_times{0, 0, p.features->model->ms, p.features->ms, t.weights, t.factorise},
                 times->struct_size, "ts_prepare_times");
  });
}
