#include "tooth/level.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cut/contour.h"
#include "cut/region.h"

namespace ts::tooth {
namespace {

// A crown's area over the width of its stretch of the arch, mm, and how much it scatters (log-normal, wide, since half
// erupted and worn crowns are crowns too): labelled scans; .4 to .7 do as well.
constexpr double kAreaPerWidth = 17, kAreaScatter = 0.55;

double plausible(const Prepared &p, Index group, double area) {
  area /= p.widened;
  if (area < p.options.area_min || area > p.options.area_max) return 1e-3;
  if (!(p.width[group] > 0)) return 1;
  const double z = std::log(area / (kAreaPerWidth * p.width[group])) / kAreaScatter;
  return std::exp(-z * z / 2);
}

// The contour of `rising` at `level` around the region alone, as if all vertices off its faces were above: only faces
// at its border are crossed, those inside with a corner above and those outside with a corner of the region below.
cut::Score border(const Prepared &p, const cut::Growth &growth, std::span<const Index> filled, cut::Values rising,
                  double level, cut::Space &space) {
  const mesh::Surface &s = *p.surface;
  const auto in_region = [&](Index v) {
    const auto around = s.vertex_faces[v];
    return std::any_of(around.begin(), around.end(), [&](Index f) { return space.inside[f] != 0; });
  };
  Vec<Index> among;
  const auto take = [&](Index f) {
    if (!space.faces[f]) space.faces.set(f, 1), among.push_back(f);
  };
  for (const Index f : growth.mixed()) take(f);
  for (const Index f : filled) take(f);
  for (const Index f : growth.beside())
    for (const Index v : s.triangle[f])
      if (!space.marks[v]) {
        space.marks.set(v, 1);
        if (rising(v) - level < 0 && in_region(v))
          for (const Index g : s.vertex_faces[v])
            if (!space.inside[g]) take(g);
      }
  space.marks.clear();
  for (const Index f : among)
    for (const Index v : s.triangle[f])
      if (!space.marks[v]) {
        space.marks.set(v, 1);
        if (in_region(v)) space.level.set(v, rising(v) - level);
      }
  std::sort(among.begin(), among.end());
  const cut::Score score = cut::score(s, rising, p.relief->concavity,
                                      cut::contour(
                                          s, [&](Index v) { return space.level[v]; }, 0, among));
  space.marks.clear();
  space.faces.clear();
  space.level.clear();
  return score;
}

}  // namespace

std::span<const double> own_levels() {
  // Finer or wider ones change the mean IoU by less than .001.
  static constexpr double levels[] = {0.3, 0.4, 0.5, 0.6, 0.7, 0.8};
  return levels;
}

Vec<double> sampled_levels(const Options &options, double limit) {
  Vec<double> levels;
  for (std::size_t k = 0; k < options.contours; ++k)
    if (const double iso = cut::iso_value(k, options.contours); iso < limit) levels.push_back(iso);
  return levels;
}

Vec<double> level_values(const Prepared &p, Index group, cut::Values rising, std::span<const double> levels) {
  const mesh::Surface &surface = *p.surface;
  const auto space = p.space();
  const auto foreign = [&](Index v) { return kind_for(p, group, v) == kForeign; };
  Vec<double> values;
  cut::Growth growth(surface, rising, p.seeds[group], space->inside);
  for (const double level : levels) {
    growth.rise(level);
    const Vec<Index> filled =
        cut::fill_holes(surface, p.widened * p.options.hole_area, foreign, growth.beside(), space->inside);
    const cut::Score s = border(p, growth, filled, rising, level, *space);
    const double value =
        s.concavity * std::sqrt(s.harmonic) * plausible(p, group, growth.area() + cut::area_of(surface, filled));
    values.push_back(s.length > 0 && value > -1 ? value : -1);
    for (const Index f : filled) space->inside.set(f, 0);
  }
  return values;
}

double best_level(const Prepared &p, Index group, cut::Values rising, std::span<const double> levels) {
  const Vec<double> values = level_values(p, group, rising, levels);
  const auto best = std::max_element(values.begin(), values.end());
  if (best == values.end() || *best < 0) return std::numeric_limits<double>::quiet_NaN();
  return levels[static_cast<std::size_t>(best - values.begin())];
}

}  // namespace ts::tooth
