#include "tooth/extract.h"

#include <algorithm>
#include <cmath>

#include "cut/line.h"
#include "cut/refine.h"
#include "tooth/level.h"
#include "tooth/warnings.h"

namespace ts::tooth {
namespace {

// Node values for "1 on `group`, 0 on what else is held".
Vec<double> held_for(const Prepared &p, const Pick &pick, Index group) {
  Vec<double> held(p.nodes.size(), field::free_node);
  for (Index n = 0; n < p.nodes.size(); ++n) {
    const Index g = p.nodes.group[n];
    if (p.outlier[n]) continue;
    const bool rest = g == field::gingiva_group || p.options.background == Background::all;
    if (g == group)
      held[n] = 1;
    else if (rest || g == pick.target || g == pick.neighbour)
      held[n] = 0;
  }
  return held;
}

field::Solution solve(const Prepared &p, const Pick &pick, Index group) {
  const Vec<double> held = held_for(p, pick, group);
  if (p.border) return p.border->extend(p.border->solve_nodes(held, p.options.alpha));
  return p.solver->extend(p.solver->solve_nodes(held, p.options.alpha));
}

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

Level best_own(const Prepared &p, Index group, Fields &fields, bool of_target, std::span<const double> levels) {
  if (p.options.cut_rule != CutRule::component) return {};
  return best_level(
      p, group, [&](Index v) { return 1 - fields.own(v, of_target); }, levels);
}

// Where there is no border at any level, a piece of the scan that is all tooth, and by the other rules it is 1/2.
double own_level(const Level &best) {
  return std::isnan(best.at) ? 0.5 : best.at;
}

}  // namespace

Fields::Fields(const Prepared &p, const Pick &pick, bool whole) : prepared_(p), target_(solve(p, pick, pick.target)) {
  if (pick.neighbour != mesh::none) neighbour_.emplace(solve(p, pick, pick.neighbour));
  if (!whole) return;
  target_.evaluate_all();
  if (neighbour_) neighbour_->evaluate_all();
}

Vec<double> Fields::all_of_u() {
  Vec<double> all(prepared_.surface->vertices());
  for (Index v = 0; v < all.size(); ++v) all[v] = u(v);
  return all;
}

std::size_t Fields::bytes() const {
  return target_.bytes() + (neighbour_ ? neighbour_->bytes() : 0);
}

double Fields::milliseconds() const {
  const double target = target_.milliseconds(), neighbour = neighbour_ ? neighbour_->milliseconds() : 0;
  return prepared_.executor->threads() > 1 ? std::max(target, neighbour) : target + neighbour;
}

bool own_field_decides(const Options &o) {
  return o.background == Background::all && o.cut_rule != CutRule::gradient;
}

double own_iso(const Prepared &p, const Pick &pick, Fields &fields, bool of_target) {
  // Of the field of a tooth's own 0 to 1 is 0 to 1/2 of u.
  const double level =
      own_level(best_own(p, of_target ? pick.target : pick.neighbour, fields, of_target, own_levels()));
  return of_target ? level / 2 : 1 - level / 2;
}

double own_iso_in_halves(const Prepared &p, const Pick &pick, Fields &fields) {
  const std::span<const double> all = own_levels(), lower = all.first(all.size() / 2);
  Level best[2];
  p.executor->each(2, [&](std::size_t k) {
    if (k == 0) {  // what this looks at is what the cut looks at next
      best[0] = best_own(p, pick.target, fields, true, all.subspan(lower.size()));
    } else {
      Fields apart(p, pick, false);
      best[1] = best_own(p, pick.target, apart, true, lower);
    }
  });
  return own_level(best[1].value >= best[0].value ? best[1] : best[0]) / 2;
}

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
        const double level =
            best_level(
                p, target ? pick.target : pick.neighbour, [&](Index v) { return target ? u[v] : 1 - u[v]; },
                sampled_levels(p.options, target ? v_med : 1 - v_med))
                .at;
        (target ? s.target_iso : s.neighbour_iso) = target ? level : 1 - level;
      });
      break;
  }
  if (pick.neighbour == mesh::none) s.neighbour_iso = std::numeric_limits<double>::quiet_NaN();
  return s;
}

Tooth extract_tooth(const Prepared &p, Fields &fields, const Selection &selection, Index group, bool is_target) {
  const mesh::Surface &surface = *p.surface;
  Tooth tooth;
  tooth.group = group;
  tooth.iso = is_target ? selection.target_iso : selection.neighbour_iso;
  if (std::isnan(tooth.iso))
    throw Error(Fault::no_cut, "no contour of the field around group " + std::to_string(group) + " looks like a tooth");
  tooth.seeds = p.seeds[group];

  // phi: about -1 deep in the tooth and 1 on the background.
  const bool own = own_field_decides(p.options);
  const double level = 2 * (is_target ? tooth.iso : 1 - tooth.iso);
  const auto phi = [&](Index v) {
    if (!own) return 4 * (is_target ? fields.u(v) - tooth.iso : tooth.iso - fields.u(v));
    const double over = 1 - fields.own(v, is_target) - level;
    return over / (over < 0 ? level : 1 - level);
  };

  const auto space = p.space();
  cut::Mask &inside = space->inside;
  const auto foreign = [&](Index v) { return kind_for(p, group, v) == kForeign; };
  const double hole = p.widened * p.options.hole_area;
  cut::Growth growth(surface, phi, tooth.seeds, inside);
  growth.rise(0);
  cut::fill_holes(surface, hole, foreign, growth.beside(), inside);
  if (p.options.refine_band > 0) {
    cut::refine(
        surface, phi, p.relief->length, p.relief->price, [&](Index v) { return kind_for(p, group, v); },
        {p.lengthened * p.options.refine_band}, *space);
    cut::keep_seeded(surface, tooth.seeds, inside);
    cut::fill_holes(surface, hole, foreign, cut::beside(surface, inside), inside);
  }
  tooth.faces = cut::faces_of(inside);
  if (tooth.faces.empty() || tooth.faces.size() == surface.faces())
    throw Error(Fault::no_cut, "the field of group " + std::to_string(group) + " separates nothing");
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
