#include "bench/rival_skeleton.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "bench/rival_regions.h"
#include "bench/rival_timer.h"
#include "geometry/concavity.h"

namespace ts::bench {
namespace {

double env(const char *n, double d) { const char *s = std::getenv(n); return s ? std::atof(s) : d; }

Vec<double> valleys(const Surface &surface, bool inside_out, const Executor &executor) {
  const double r = env("R_NORMAL", 0.4);
  if (env("R_MEAN", 0) == 0) return geometry::concavity(surface, r, inside_out, executor).vertex;
  const auto cot = geometry::cotangent_weights(surface, 0.01, executor);
  const auto graph = geometry::make_graph(surface, cot, executor, 5);
  auto normal = geometry::vertex_normals(surface, geometry::NormalWeight::angle, executor);
  normal = geometry::smoothed_normals(surface, normal, graph, r, executor);
  const auto k = geometry::principal_curvatures(surface, surface.position, normal, executor);
  Vec<double> out(surface.vertices());
  for (std::size_t v = 0; v < out.size(); ++v)
    out[v] = std::max(0.0, (inside_out ? 1 : -1) * (k.least[v] + k.greatest[v]) / 2);
  return out;
}

Teeth run(const Surface &surface, const Vec<double> &concavity, const Heights &h, double threshold) {
  Mask feature(surface.vertices());
  for (Index v = 0; v < feature.size(); ++v) feature[v] = concavity[v] > threshold;
  drop_small_pieces(surface, feature, 1, env("R_DROP", 2));
  feature = closed(surface, feature, std::max(env("R_CLOSE", 0.4), env("R_CLOSE_E", 0) * surface.mean_edge));
  drop_small_pieces(surface, feature, 0, env("R_FILL", 2));
  if (env("R_PRIO", 1) != 0) {
    thin(surface, feature, concavity);
  } else {
    Mask outside = feature;
    for (auto &x : outside) x = !x;
    thin(surface, feature, distance_to(surface, outside));
  }
  RegionOptions o;
  o.least_tooth = env("R_LEAST", o.least_tooth);
  o.stands = env("R_STANDS", o.stands);
  o.border_share = env("R_BORDER", o.border_share);
  return teeth_between(surface, feature, concavity, h, o);
}

}  // namespace

Outcome skeleton_teeth(const Surface &surface, unsigned wanted, double threshold, const Executor &executor) {
  Outcome out;
  Timer field;
  const Heights h = heights(surface, executor);
  const Vec<double> concavity = valleys(surface, h.orientation.inside_out, executor);
  const double field_ms = field.ms();
  Timer search;
  const int steps = 20;
  const double lo = env("R_LO", 0.03), hi = env("R_HI", 1.0);
  double best = threshold;
  if (!(threshold > 0)) {
    Teeth least;
    for (int k = 0; k < steps; ++k) {
      const double t = lo * std::pow(hi / lo, k / (steps - 1.0));
      Teeth teeth = run(surface, concavity, h, t);
      if (std::getenv("R_VERBOSE")) std::printf("%.3f: %u of %u, spread %.3f\n", t, teeth.count, teeth.regions, teeth.spread);
      if (k == 0 || fits_better(teeth, least, wanted)) least = std::move(teeth), best = t;
      ++out.tried;
    }
  }
  out.search_ms = search.ms();
  Timer single;
  out.teeth = run(surface, concavity, h, best);
  out.run_ms = field_ms + single.ms();
  out.settings = {{"threshold", best}};
  return out;
}

}  // namespace ts::bench
