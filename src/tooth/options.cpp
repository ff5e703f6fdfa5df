#include "tooth/options.h"

#include <cmath>

#include "base/error.h"

namespace ts::tooth {

Options default_options() {
  return {};
}

Options paper_options() {
  Options o;
  o.preset = Preset::paper;
  o.weights = field::Scheme::paper;
  o.background = Background::neighbour;
  o.cut_rule = CutRule::gradient;
  o.beta = 0.01;
  o.theta = 0.001;
  o.seed_radius = 0;
  o.hole_area = 0;
  o.refine_band = 0;
  o.smooth_radius = 0;
  o.click_concavity = 0;
  o.reject_outliers = false;
  return o;
}

void check(const Options &o) {
  const auto need = [](bool right, const char *what) {
    if (!right) throw Error(Fault::invalid_argument, std::string("segmentation options: ") + what);
  };
  const auto within = [](double x, double low, double high) { return std::isfinite(x) && x >= low && x <= high; };
  need(o.weights >= field::Scheme::concavity && o.weights <= field::Scheme::feature, "weights is not a ts_weights");
  need(o.background >= Background::neighbour && o.background <= Background::all, "background is not a ts_background");
  need(o.cut_rule >= CutRule::gradient && o.cut_rule <= CutRule::half, "cut_rule is not a ts_cut_rule");
  need(o.contours >= 2 && o.contours <= 100000, "contours outside [2, 100000]");
  need(o.histogram_bins >= 2 && o.histogram_bins <= 100000, "histogram_bins outside [2, 100000]");
  need(within(o.alpha, 0, 1e16), "alpha outside [0, 1e16]");
  need(within(o.beta, 1e-12, 1), "beta outside [1e-12, 1]");
  need(within(o.gamma, 1e-12, 1e6), "gamma outside [1e-12, 1e6]");
  need(within(o.theta, -2, 2), "theta outside [-2, 2]");
  need(within(o.c0, 1e-6, 1e6), "c0 outside [1e-6, 1e6]");
  need(within(o.normal_radius, 0, 10), "normal_radius outside [0, 10]");
  need(within(o.seed_radius, 0, 10), "seed_radius outside [0, 10]");
  need(within(o.gingiva_distance, 0, 1e6), "gingiva_distance outside [0, 1e6]");
  need(within(o.area_min, 0, 1e6) && within(o.area_max, o.area_min, 1e6),
       "area_min, area_max not in order or outside [0, 1e6]");
  need(within(o.hole_area, 0, 1e6), "hole_area outside [0, 1e6]");
  need(within(o.refine_band, 0, 20), "refine_band outside [0, 20]");
  need(within(o.smooth_radius, 0, 10), "smooth_radius outside [0, 10]");
  need(within(o.click_reach, 0, 1e6), "click_reach outside [0, 1e6]");
  need(within(o.click_concavity, 0, 1e9), "click_concavity outside [0, 1e9]");
}

}  // namespace ts::tooth
