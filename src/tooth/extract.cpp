#include "tooth/extract.h"

#include <algorithm>
#include <cmath>

#include "cut/line.h"
#include "tooth/level.h"
#include "tooth/warnings.h"

namespace ts::tooth {
namespace {

double mean_inside(const Prepared &p, Fields &fields, bool of_target, const Vec<Index> &faces) {
  double sum = 0, area = 0;
  for (const Index f : faces) {
    const auto &t = p.surface->triangle[f];
    const double a = fields.own(t[0], of_target), b = fields.own(t[1], of_target), c = fields.own(t[2], of_target);
    sum += p.surface->face_area[f] * (a + b + c) / 3;
    area += p.surface->face_area[f];
  }
  return area > 0 ? sum / area : 0;
}

// Geometric mean of how far the field is one inside and of how much of the cut runs in seams, less with a warning.
// kSeam scales it so that what is given 0.9 can be relied on: docs/accuracy.md has the calibration.
double confidence(double inside, const Tooth &tooth) {
  constexpr double kSeam = 0.6;
  double length = 0, concavity = 0;
  for (const Cut &c : tooth.loops) length += c.line.length, concavity += c.line.length * c.concavity;
  const double seam = length > 0 ? std::min(1.0, concavity / length / kSeam) : 0;
  return std::sqrt(std::clamp(inside, 0.0, 1.0) * seam * (tooth.warnings ? 0.5 : 1));
}

}  // namespace

Selection select_cuts(const Prepared &p, const Pick &pick, Fields &fields) {
  Selection s;
  const Vec<double> u = fields.all_of_u();
  const double v_med = cut::histogram(u, p.options.histogram_bins).v_med;
  switch (p.options.cut_rule) {
    case CutRule::half:
      s.target_iso = v_med / 2;
      s.neighbour_iso = (1 + v_med) / 2;
      break;
    case CutRule::gradient: {
      const Vec<cut::Score> scores = cut::score_all(*p.surface, u, p.relief->concavity, p.options.contours);
      const cut::Chosen chosen = cut::largest_gradient(scores, v_med);
      if (chosen.target != SIZE_MAX) s.target_iso = cut::iso_value(chosen.target, scores.size());
      if (chosen.neighbour != SIZE_MAX) s.neighbour_iso = cut::iso_value(chosen.neighbour, scores.size());
      break;
    }
    case CutRule::component:
      p.executor->each(pick.neighbour != mesh::none ? 2 : 1, [&](std::size_t i) {
        const bool target = i == 0;
        const double level = best_level(
            p, target ? pick.target : pick.neighbour, [&](Index v) { return target ? u[v] : 1 - u[v]; },
            sampled_levels(p.options, target ? v_med : 1 - v_med));
        (target ? s.target_iso : s.neighbour_iso) = target ? level : 1 - level;
      });
      break;
  }
  if (pick.neighbour == mesh::none) s.neighbour_iso = std::numeric_limits<double>::quiet_NaN();
  return s;
}

Region pair_region(const Prepared &p, Fields &fields, double iso, Index group, bool is_target) {
  if (std::isnan(iso)) return {};
  return {iso,
          faces_below_zero(p, group, [&](Index v) { return 4 * (is_target ? fields.u(v) - iso : iso - fields.u(v)); })};
}

Tooth extract_tooth(const Prepared &p, Fields &fields, Region region, Index group, bool is_target) {
  const mesh::Surface &surface = *p.surface;
  if (std::isnan(region.iso))
    throw Error(Fault::no_cut, "no contour of the field around group " + std::to_string(group) + " looks like a tooth");
  if (region.faces.empty() || region.faces.size() == surface.faces())
    throw Error(Fault::no_cut, "the field of group " + std::to_string(group) + " separates nothing");
  Tooth tooth;
  tooth.group = group;
  tooth.iso = region.iso;
  tooth.seeds = p.seeds[group];
  tooth.faces = std::move(region.faces);
  const auto space = p.space();
  for (const Index f : tooth.faces) space->inside.set(f, 1);
  for (cut::Polyline &line :
       cut::smooth_line(surface, p.relief->length, p.relief->cotangent, p.options.smooth_radius, tooth.seeds, *space))
    tooth.loops.push_back({std::move(line), tooth.iso, 0, 0});
  take_stock(p, tooth, *space);
  set_confidence(p, fields, is_target, tooth);
  return tooth;
}

void take_stock(const Prepared &p, Tooth &tooth, cut::Space &space) {
  const mesh::Surface &surface = *p.surface;
  tooth.vertices = cut::vertices_of(surface, tooth.faces, space);
  tooth.area = cut::area_of(surface, tooth.faces);
  tooth.warnings = 0;
  if (tooth.area / p.widened < p.options.area_min) tooth.warnings |= Warning::area_small;
  if (tooth.area / p.widened > p.options.area_max) tooth.warnings |= Warning::area_large;
  if (p.live.size() < 2) tooth.warnings |= Warning::no_neighbour;
  if (tooth.group >= p.found) tooth.warnings |= Warning::made_by_click;
  if (!p.rejected[tooth.group].empty()) tooth.warnings |= Warning::seed_rejected;
  tooth.warnings |= warnings_of_place(p, tooth.group, tooth.vertices) |
                    warnings_of_shape(surface, tooth.faces, p.occlusal, p.inside_out);
  for (Cut &c : tooth.loops) {
    c.concavity = cut::mean_concavity(p.relief->concavity, c.line);
    if (!c.line.closed) tooth.warnings |= Warning::open_at_border;
  }
  if (tooth.loops.size() != 1) tooth.warnings |= Warning::several_loops;
}

void set_confidence(const Prepared &p, Fields &fields, bool is_target, Tooth &tooth) {
  tooth.confidence = confidence(mean_inside(p, fields, is_target, tooth.faces), tooth);
}

void measure_cuts(const Prepared &p, Fields &fields, Tooth &tooth) {
  double length = 0, gradient = 0;
  for (Cut &c : tooth.loops) {
    const cut::Score s =
        cut::score(*p.surface, [&](Index v) { return fields.u(v); }, p.relief->concavity, {&c.line, 1});
    c.gradient = s.gradient;
    length += s.length;
    gradient += s.length * s.gradient;
  }
  if (length > 0) tooth.gradient = gradient / length;
}

}  // namespace ts::tooth
