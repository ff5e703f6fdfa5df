#include "tooth/region.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/stop.h"
#include "cut/refine.h"
#include "tooth/level.h"

namespace ts::tooth {
namespace {

// What a border costs, for its size (a round crown .28 for each mm all in flat surface, .02 for each in the deepest of
// seams): one that costs less than kConvincing is not doubted, and a level is left only for one that costs less by more
// than kAlike. 15 labelled scans, mean IoU, and 624 teeth of random crowded arches of 8,000 to 20,000 triangles, teeth
// under .9: without other levels .9747 and 142, 1/2.5 .9749 and 70, 1/3 .9753 and 53, always tried .9753 and 51; kAlike
// 1.1 .9753 and 55, 1 .9746 and 46.
constexpr double kConvincing = 1 / 3.0, kAlike = 1.05;
// Levels that are worth less than this share of the best are not tried; at .1 the same, at .5 64 teeth under .9.
constexpr double kWorthTrying = 0.25;

// Of the edges of the border what the minimum cut prices them at, over the square root of the area. Where the scan ends
// is no seam.
double cost_of_border(const Prepared &p, std::span<const Index> faces) {
  const mesh::Surface &s = *p.surface;
  if (faces.empty()) return std::numeric_limits<double>::infinity();
  const auto space = p.space();
  for (const Index f : faces) space->inside.set(f, 1);
  double price = 0;
  for (const Index f : faces)
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Index e = s.edge_of[h];
      if (s.twin[h] == mesh::none)
        price += p.relief->length[e];
      else if (!space->inside[mesh::face_of(s.twin[h])])
        price += p.relief->price[e];
    }
  return price / p.lengthened / std::sqrt(cut::area_of(s, faces) / p.widened);
}

Vec<Index> own_faces(const Prepared &p, Index group, Fields &fields, bool of_target, double level) {
  return faces_below_zero(p, group, [&](Index v) {
    const double over = 1 - fields.own(v, of_target) - level;
    return over / (over < 0 ? level : 1 - level);
  });
}

Vec<double> own_values(const Prepared &p, Index group, Fields &fields, bool of_target, std::span<const double> levels) {
  if (p.options.cut_rule != CutRule::component) return {};
  return level_values(
      p, group, [&](Index v) { return 1 - fields.own(v, of_target); }, levels);
}

Region region_at(const Prepared &p, Index group, Fields &fields, bool of_target, double level) {
  // Of the field of a tooth's own 0 to 1 is 0 to 1/2 of u.
  return {of_target ? level / 2 : 1 - level / 2, own_faces(p, group, fields, of_target, level)};
}

// `value` of each level; none where the rule is another.
Region cheapest(const Prepared &p, Index group, Fields &fields, bool of_target, const Vec<double> &value) {
  const std::span<const double> levels = own_levels();
  Vec<std::size_t> order(value.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return value[a] > value[b]; });
  // Where there is no border at any level, a piece of the scan that is all tooth, and by the other rules it is 1/2.
  if (value.empty() || value[order[0]] < 0) return region_at(p, group, fields, of_target, 0.5);
  Vec<Region> tried;
  Vec<double> cost;
  for (const std::size_t k : order) {
    if (!tried.empty() && value[k] < kWorthTrying * value[order[0]]) break;
    stop_if_asked();
    tried.push_back(region_at(p, group, fields, of_target, levels[k]));
    cost.push_back(cost_of_border(p, tried.back().faces));
    if (!(p.options.refine_band > 0) || cost.back() < kConvincing) break;
  }
  const double enough = kAlike * *std::min_element(cost.begin(), cost.end());
  const auto first = std::find_if(cost.begin(), cost.end(), [&](double c) { return c <= enough; });
  return std::move(tried[static_cast<std::size_t>(first - cost.begin())]);
}

Index group_of(const Pick &pick, bool target) {
  return target ? pick.target : pick.neighbour;
}

}  // namespace

Vec<Index> faces_below_zero(const Prepared &p, Index group, cut::Values phi) {
  const mesh::Surface &surface = *p.surface;
  const auto space = p.space();
  cut::Mask &inside = space->inside;
  const auto foreign = [&](Index v) { return kind_for(p, group, v) == kForeign; };
  const double hole = p.widened * p.options.hole_area;
  cut::Growth growth(surface, phi, p.seeds[group], inside);
  growth.rise(0);
  cut::fill_holes(surface, hole, foreign, growth.beside(), inside);
  if (p.options.refine_band > 0) {
    cut::refine(
        surface, phi, p.relief->length, p.relief->price, [&](Index v) { return kind_for(p, group, v); },
        {p.lengthened * p.options.refine_band}, *space);
    cut::keep_seeded(surface, p.seeds[group], inside);
    cut::fill_holes(surface, hole, foreign, cut::beside(surface, inside), inside);
  }
  return cut::faces_of(inside);
}

Region own_region(const Prepared &p, const Pick &pick, Fields &fields, bool of_target) {
  const Index group = group_of(pick, of_target);
  return cheapest(p, group, fields, of_target, own_values(p, group, fields, of_target, own_levels()));
}

Region own_region_in_halves(const Prepared &p, const Pick &pick, Fields &fields) {
  const std::span<const double> all = own_levels(), lower = all.first(all.size() / 2);
  Vec<double> value[2];
  p.executor->each(2, [&](std::size_t k) {
    if (k == 1) {  // what this looks at is what the cut looks at next
      value[1] = own_values(p, pick.target, fields, true, all.subspan(lower.size()));
    } else {
      Fields apart(p, pick, false);
      value[0] = own_values(p, pick.target, apart, true, lower);
    }
  });
  value[0].insert(value[0].end(), value[1].begin(), value[1].end());
  return cheapest(p, pick.target, fields, true, value[0]);
}

}  // namespace ts::tooth
