#include "tooth/extract.h"

#include <algorithm>
#include <cmath>

#include "cut/line.h"
#include "cut/refine.h"
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

Vec<Index> seeds_of(const Prepared &p, Index group) {
  Vec<Index> seeds;
  for (Index n = 0; n < p.nodes.size(); ++n)
    if (p.nodes.group[n] == group && !p.outlier[n])
      seeds.insert(seeds.end(), p.nodes.vertices[n].begin(), p.nodes.vertices[n].end());
  std::sort(seeds.begin(), seeds.end());
  return seeds;
}

// 1 = seeds of the tooth, 2 = of other teeth and gingiva, 0 = neither.
Vec<std::uint8_t> fixed_for(const Prepared &p, Index group) {
  Vec<std::uint8_t> fixed(p.surface->vertices(), 0);
  for (Index n = 0; n < p.nodes.size(); ++n) {
    if (p.outlier[n]) continue;
    for (const Index v : p.nodes.vertices[n]) fixed[v] = p.nodes.group[n] == group ? 1 : 2;
  }
  return fixed;
}

// 1 = seeds of other teeth and gingiva: no hole may be filled over them.
Vec<std::uint8_t> foreign_of(Vec<std::uint8_t> fixed) {
  for (std::uint8_t &f : fixed) f = f == 2;
  return fixed;
}

// With everything else held, a tooth's own field decides: what it is does then not depend on the pair it was separated
// in. The paper's rule looks at the field of the pair.
bool own_field_decides(const Options &o) {
  return o.background == Background::all && o.cut_rule != CutRule::gradient;
}

// Levels of 1 - u_own that are tried; finer or wider ones change the mean IoU by less than .001.
constexpr double kLevels[] = {0.3, 0.4, 0.5, 0.6, 0.7, 0.8};
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

// The component rule: of each level the component of `rising` (0 on the tooth's seeds) below it that holds the seeds,
// holes filled; the best is that whose border has the largest concavity x sqrt(harmonic mean gradient), times how
// plausible its area is. NaN if none has a border.
double best_level(const Prepared &p, const Vec<double> &rising, Index group, std::span<const double> levels) {
  const mesh::Surface &surface = *p.surface;
  const Vec<Index> seeds = seeds_of(p, group);
  const Vec<std::uint8_t> foreign = foreign_of(fixed_for(p, group));
  double best = -1, found = std::numeric_limits<double>::quiet_NaN();
  Vec<double> phi(rising.size()), alone(rising.size(), 1);
  for (const double level : levels) {
    for (std::size_t v = 0; v < phi.size(); ++v) phi[v] = rising[v] - level;
    cut::Mask inside = cut::grow(surface, phi, seeds);
    cut::fill_holes(surface, p.widened * p.options.hole_area, foreign, inside);
    const Vec<Index> faces = cut::faces_of(inside), corners = cut::vertices_of(surface, faces);
    // The contour's part around this component: where phi is kept negative on it alone.
    for (const Index v : corners) alone[v] = phi[v];
    Vec<Index> around;
    for (const Index v : corners)
      for (const Index f : surface.vertex_faces[v]) {
        const auto &t = surface.triangle[f];
        if (alone[t[0]] >= 0 || alone[t[1]] >= 0 || alone[t[2]] >= 0) around.push_back(f);
      }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    const cut::Score s = cut::score(surface, rising, p.concavity, cut::contour(surface, alone, 0, around));
    for (const Index v : corners) alone[v] = 1;
    const double value = s.concavity * std::sqrt(s.harmonic) * plausible(p, group, cut::area_of(surface, faces));
    if (s.length > 0 && value > best) best = value, found = level;
  }
  return found;
}

// 0 on the seeds of one of the two teeth, growing outwards, from the field of the pair.
Vec<double> rising_from(const Vec<double> &field, bool falls) {
  Vec<double> rising(field);
  if (falls)
    for (double &x : rising) x = 1 - x;
  return rising;
}

// Sampled iso-values below `limit`.
Vec<double> levels_below(const Prepared &p, double limit) {
  Vec<double> levels;
  for (std::size_t k = 0; k < p.options.contours; ++k)
    if (const double iso = cut::iso_value(k, p.options.contours); iso < limit) levels.push_back(iso);
  return levels;
}

double mean_inside(const Prepared &p, const Vec<double> &own, const Vec<Index> &faces) {
  double sum = 0, area = 0;
  for (const Index f : faces) {
    const auto &t = p.surface->triangle[f];
    sum += p.surface->face_area[f] * (own[t[0]] + own[t[1]] + own[t[2]]) / 3;
    area += p.surface->face_area[f];
  }
  return area > 0 ? sum / area : 0;
}

void add_cuts(const Prepared &p, const Fields &fields, Tooth &tooth, const cut::Mask &inside) {
  bool open = false;
  double length = 0, gradient = 0;
  for (cut::Polyline &line : cut::smooth_line(*p.surface, p.cotangent, inside, p.options.smooth_radius, tooth.seeds)) {
    const cut::Score s = cut::score(*p.surface, fields.u, p.concavity, {&line, 1});
    open = open || !line.closed;
    length += s.length;
    gradient += s.length * s.gradient;
    tooth.loops.push_back({std::move(line), tooth.iso, s.gradient, s.concavity});
  }
  if (length > 0) tooth.gradient = gradient / length;
  if (open) tooth.warnings |= Warning::open_at_border;
  if (tooth.loops.size() != 1) tooth.warnings |= Warning::several_loops;
}

// Geometric mean of how far the field is one inside and of how much of the cut runs in seams, less with a warning.
// kSeam scales it so that what is given 0.9 can be relied on: docs/accuracy.md has the calibration.
double confidence(const Prepared &p, const Vec<double> &own, const Tooth &tooth) {
  constexpr double kSeam = 0.6;
  double length = 0, concavity = 0;
  for (const Cut &c : tooth.loops) length += c.line.length, concavity += c.line.length * c.concavity;
  const double seam = length > 0 ? std::min(1.0, concavity / length / kSeam) : 0;
  return std::sqrt(std::clamp(mean_inside(p, own, tooth.faces), 0.0, 1.0) * seam * (tooth.warnings ? 0.5 : 1));
}

}  // namespace

Fields solve_fields(const Prepared &p, const Pick &pick) {
  Vec<Eigen::VectorXd> at_nodes;
  at_nodes.push_back(p.solver->solve_nodes(held_for(p, pick, pick.target), p.options.alpha));
  if (pick.neighbour != mesh::none)
    at_nodes.push_back(p.solver->solve_nodes(held_for(p, pick, pick.neighbour), p.options.alpha));
  Vec<Vec<double>> extended = p.solver->extend(at_nodes);
  Fields fields;
  fields.target = std::move(extended[0]);
  if (extended.size() > 1)
    fields.neighbour = std::move(extended[1]);
  else {
    fields.neighbour.resize(fields.target.size());
    for (std::size_t v = 0; v < fields.target.size(); ++v) fields.neighbour[v] = 0 * fields.target[v];  // NaN stays
  }
  fields.u.resize(fields.target.size());
  for (std::size_t v = 0; v < fields.u.size(); ++v) fields.u[v] = (1 - fields.target[v] + fields.neighbour[v]) / 2;
  return fields;
}

Selection select_cuts(const Prepared &p, const Pick &pick, const Fields &fields) {
  Selection s;
  s.v_med = cut::histogram(fields.u, p.options.histogram_bins).v_med;
  s.target_iso = s.neighbour_iso = std::numeric_limits<double>::quiet_NaN();
  switch (p.options.cut_rule) {
    case CutRule::half:
      s.target_iso = p.options.background == Background::all ? 0.25 : s.v_med / 2;
      s.neighbour_iso = p.options.background == Background::all ? 0.75 : (1 + s.v_med) / 2;
      break;
    case CutRule::gradient: {
      const Vec<cut::Score> scores = cut::score_all(*p.surface, fields.u, p.concavity, p.options.contours);
      const cut::Chosen chosen = cut::largest_gradient(scores, s.v_med);
      if (chosen.target != SIZE_MAX) s.target_iso = cut::iso_value(chosen.target, scores.size());
      if (chosen.neighbour != SIZE_MAX) s.neighbour_iso = cut::iso_value(chosen.neighbour, scores.size());
      break;
    }
    case CutRule::component: {
      const bool own = own_field_decides(p.options);
      const auto level = [&](Index group, const Vec<double> &field, bool falls, double limit) {
        const Vec<double> levels = own ? Vec<double>(std::begin(kLevels), std::end(kLevels)) : levels_below(p, limit);
        const double best = best_level(p, rising_from(field, falls), group, levels);
        // No border at any level: a piece of the scan that is all tooth.
        return own ? (std::isnan(best) ? 0.5 : best) / 2 : best;
      };
      const bool two = pick.neighbour != mesh::none;
      p.executor->each(two ? 2 : 1, [&](std::size_t i) {
        if (i == 0)
          s.target_iso = level(pick.target, own ? fields.target : fields.u, own, s.v_med);
        else
          s.neighbour_iso = 1 - level(pick.neighbour, own ? fields.neighbour : fields.u, true, 1 - s.v_med);
      });
      break;
    }
  }
  if (pick.neighbour == mesh::none) s.neighbour_iso = std::numeric_limits<double>::quiet_NaN();
  return s;
}

Tooth extract_tooth(const Prepared &p, const Fields &fields, const Selection &selection, Index group, bool is_target) {
  const mesh::Surface &surface = *p.surface;
  const Vec<double> &own = is_target ? fields.target : fields.neighbour;
  Tooth tooth;
  tooth.group = group;
  tooth.iso = is_target ? selection.target_iso : selection.neighbour_iso;
  if (std::isnan(tooth.iso))
    throw Error(Fault::no_cut, "no contour of the field around group " + std::to_string(group) + " looks like a tooth");
  tooth.seeds = seeds_of(p, group);

  // phi: about -1 deep in the tooth and 1 on the background.
  Vec<double> phi(surface.vertices());
  if (own_field_decides(p.options)) {
    const double level = 2 * (is_target ? tooth.iso : 1 - tooth.iso);
    for (std::size_t v = 0; v < phi.size(); ++v) {
      const double over = 1 - own[v] - level;
      phi[v] = over / (over < 0 ? level : 1 - level);
    }
  } else {
    for (std::size_t v = 0; v < phi.size(); ++v)
      phi[v] = 4 * (is_target ? fields.u[v] - tooth.iso : tooth.iso - fields.u[v]);
  }

  const Vec<std::uint8_t> fixed = fixed_for(p, group);
  const Vec<std::uint8_t> foreign = foreign_of(fixed);
  cut::Mask inside = cut::grow(surface, phi, tooth.seeds);
  cut::fill_holes(surface, p.widened * p.options.hole_area, foreign, inside);
  if (p.options.refine_band > 0) {
    cut::refine(surface, phi, p.seam, fixed, {p.lengthened * p.options.refine_band}, inside);
    cut::keep_seeded(surface, tooth.seeds, inside);
    cut::fill_holes(surface, p.widened * p.options.hole_area, foreign, inside);
  }
  tooth.faces = cut::faces_of(inside);
  if (tooth.faces.empty() || tooth.faces.size() == surface.faces())
    throw Error(Fault::no_cut, "the field of group " + std::to_string(group) + " separates nothing");
  tooth.vertices = cut::vertices_of(surface, tooth.faces);
  tooth.area = cut::area_of(surface, tooth.faces);
  if (tooth.area / p.widened < p.options.area_min) tooth.warnings |= Warning::area_small;
  if (tooth.area / p.widened > p.options.area_max) tooth.warnings |= Warning::area_large;
  if (p.live.size() < 2) tooth.warnings |= Warning::no_neighbour;
  if (!p.rejected[group].empty()) tooth.warnings |= Warning::seed_rejected;
  tooth.warnings |=
      warnings_of_place(p, group, tooth.vertices) | warnings_of_shape(surface, tooth.faces, p.occlusal, p.inside_out);
  add_cuts(p, fields, tooth, inside);
  tooth.confidence = confidence(p, own, tooth);
  return tooth;
}

}  // namespace ts::tooth
