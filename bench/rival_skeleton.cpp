#include "bench/rival_skeleton.h"

#include <cmath>
#include <utility>

#include "bench/bench_figures.h"
#include "bench/rival_regions.h"
#include "geometry/concavity.h"

namespace ts::bench {
namespace {

// Tried on real and synthetic arches: the mean curvature, which finds saddles (contacts) no valleys, larger radii of
// the normals and of the closing, and thinning by distance instead of by depth do worse.
constexpr double kNormalRadius = 0.3;  // mm over which normals are smoothed before curvature is taken
constexpr double kClosing = 0.2;       // mm; more closes narrow teeth as well
constexpr double kLeastFeature = 2;    // mm^2: smaller pieces of the feature region are noise
constexpr double kLeastHole = 2;       // mm^2: so are smaller holes
// The search: thresholds of the least curvature from the noise of a flat surface to a sharp contact, 1/mm.
constexpr double kLeastThreshold = 0.03, kMostThreshold = 0.6;
constexpr unsigned kThresholds = 20;

Teeth run(const Surface &surface, const Vec<double> &valley, const Heights &h, double threshold, unsigned wanted) {
  Mask feature(surface.vertices());
  for (Index v = 0; v < feature.size(); ++v) feature[v] = valley[v] > threshold;
  drop_small_pieces(surface, feature, 1, kLeastFeature);
  feature = closed(surface, feature, kClosing);
  drop_small_pieces(surface, feature, 0, kLeastHole);
  thin(surface, feature, valley);
  RegionOptions options;
  options.wanted = wanted;
  return teeth_between(surface, feature, valley, h, options);
}

}  // namespace

Outcome skeleton_teeth(const Surface &surface, unsigned wanted, double threshold, const Executor &executor) {
  Outcome out;
  const Timer field;
  const Heights h = heights(surface, executor);
  const Vec<double> valley = geometry::concavity(surface, kNormalRadius, h.orientation.inside_out, executor).vertex;
  const double field_ms = field.ms();
  const Timer search;
  double best = threshold;
  if (!(threshold > 0)) {
    Teeth fitting;
    for (unsigned k = 0; k < kThresholds; ++k) {
      const double t = kLeastThreshold * std::pow(kMostThreshold / kLeastThreshold, k / (kThresholds - 1.0));
      Teeth teeth = run(surface, valley, h, t, wanted);
      if (k > 0 && !fits_better(teeth, fitting, wanted)) continue;
      fitting = std::move(teeth);
      best = t;
    }
    out.tried = kThresholds;
  }
  out.search_ms = search.ms();
  const Timer single;  // once more, so that its time is that of a run, warm as a user's who moves a slider
  out.teeth = run(surface, valley, h, best, wanted);
  out.run_ms = field_ms + single.ms();
  out.settings = {{"threshold", best}};
  return out;
}

}  // namespace ts::bench
