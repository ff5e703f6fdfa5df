// From a small mesh to teeth: any shape of the surface, any features, any options, any clicks.
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "check.h"
#include "input.h"
#include "scene.h"

namespace {

ts_segment_options options_of(Input &in) {
  ts_segment_options o;
  HOLDS(ts_segment_options_init(&o, sizeof o, in.byte() % 4 == 0 ? TS_PRESET_PAPER : TS_PRESET_DEFAULT) == TS_OK);
  if (in.byte() % 2) return o;
  o.weights = static_cast<ts_weights>(in.byte() % 5);
  o.background = static_cast<ts_background>(in.byte() % 3);
  o.cut_rule = static_cast<ts_cut_rule>(in.byte() % 3);
  o.contours = 1 + in.below(60);
  o.histogram_bins = 1 + in.below(60);
  o.points_per_group = in.below(4);
  // Weights over twelve orders of magnitude, and penalties from none to beyond what doubles resolve.
  o.alpha = in.byte() % 3 == 0 ? 0 : std::pow(10, in.share() * 16 - 4);
  o.beta = std::pow(10, -12 * in.share());
  o.seed_radius = in.share() * 3;
  o.gingiva_distance = in.share() * 20;
  o.refine_band = in.share() * 4;
  o.smooth_radius = in.share();
  o.hole_area = in.share() * 60;
  o.normal_radius = in.share();
  o.click_concavity = in.share() * 100;
  o.reject_outliers = in.byte() % 2;
  switch (in.byte() % 8) {
    case 0: o.gamma = in.any(); break;
    case 1: o.theta = in.any(); break;
    case 2: o.c0 = in.any(); break;
    case 3: o.area_min = in.any(), o.area_max = in.any(); break;
    default: break;
  }
  return o;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  static const Handle<ts_context> context = one_thread();
  Input in(data, size);
  Bumps bumps = make_bumps(1 + in.below(4), 3 + in.below(5), 6 * in.share());
  // Dents, folds, slivers: any vertex elsewhere, any face away.
  for (std::uint32_t k = in.below(12); k > 0; --k) {
    const std::size_t at = 3 * in.below(static_cast<std::uint32_t>(bumps.xyz.size() / 3));
    for (int c = 0; c < 3; ++c) bumps.xyz[at + c] += in.byte() % 4 == 0 ? in.share() * 8 - 4 : in.share() * 1e-3;
  }
  for (std::uint32_t k = in.below(6); k > 0; --k) {
    const std::size_t at = 3 * in.below(static_cast<std::uint32_t>(bumps.triangles.size() / 3));
    bumps.triangles.erase(bumps.triangles.begin() + static_cast<std::ptrdiff_t>(at),
                          bumps.triangles.begin() + static_cast<std::ptrdiff_t>(at) + 3);
  }
  const ts_mesh_input input = input_of(bumps);
  ts_intake_options intake;
  HOLDS(ts_intake_options_init(&intake, sizeof intake) == TS_OK);
  intake.unit = TS_UNIT_MM;
  ts_status got;
  const auto model = made<ts_model>(
      [&](ts_model **out) { return ts_model_create(context.get(), &input, &intake, nullptr, out); }, &got);
  check::status(got, {4});
  if (!model) return 0;
  check::model(model.get());

  Handle<ts_features> features;
  if (in.byte() % 4 == 0) {
    features = made<ts_features>(
        [&](ts_features **out) { return ts_detect_features(model.get(), nullptr, nullptr, out); }, &got);
    check::status(got, {5});
    if (!features) return 0;
  } else {
    features = features_of(model.get(), bumps);
    for (std::uint32_t k = in.below(5); k > 0; --k) {
      const double at[3] = {in.share() * 24, in.share() * 12 - 6, in.share() * 6};
      check::status(ts_features_add_point(features.get(), at, in.byte() % 2 ? TS_NONE : in.below(6), nullptr, nullptr),
                    {1});
    }
  }
  check::features(model.get(), features.get());

  const ts_segment_options options = options_of(in);
  const auto segmentation = made<ts_segmentation>(
      [&](ts_segmentation **out) { return ts_segmentation_create(features.get(), &options, nullptr, out); }, &got);
  check::status(got, {1, 5, 6});
  if (!segmentation) return 0;
  for (std::uint32_t k = 1 + in.below(4); k > 0; --k) {
    const double at[3] = {in.share() * 26 - 1, in.share() * 14 - 7, in.share() * 7};
    check::status(ts_segment_click(segmentation.get(), at, nullptr, nullptr), {6});
  }
  if (in.byte() % 2) check::status(ts_segment_all(segmentation.get(), nullptr), {6});
  check::segmentation(model.get(), segmentation.get(), true);
  return 0;
}
