#include "tooth/separate.h"

#include <algorithm>

#include "base/shown.h"
#include "tooth/extract.h"
#include "tooth/made.h"

namespace ts::tooth {
namespace {

// A click outside the tooth it was taken for lies on gingiva when this much of the field there is the gingiva's. Of 594
// clicks on labelled crowns the largest share was 0.68; of 227 on gingiva nine in ten have more than 0.79.
constexpr double kGingiva = 0.8;

// With the group of a crown taken away most of the field on it is the gingiva's too, and another figure has to tell the
// two: the conductance from a disc at the click to all that is held. A crown has a seam around it. Of 654 clicks on gum
// of the 15 labelled scans and 185 on crowns whose group was taken away, at most this have 12 of the 106 on gum around
// which something as large as a tooth can be cut out (with kGingiva 25), and 102 of the 112 crowns cut out well (64).
constexpr double kEnclosed = 0.3;

// mm. Borders of labelled crowns lie .45 from ours at the 95th percentile (docs/accuracy.md).
constexpr double kEdge = 1;

// mm below the mean of a tooth's points, and share of the distance from them that may be along the arch: the cingula of
// synthetic incisors, whose fossae are deeper than real ones, lie 3 to 6 below and at most .3; a tooth behind another
// has its own edge, one beside it stands along the arch.
constexpr double kBelow = 2, kAcross = 0.6;

// How much of the field at the click is each node's.
Eigen::VectorXd shares_at(const Prepared &p, const mesh::SurfacePoint &at) {
  const auto &corners = p.surface->triangle[at.face];
  const std::span<const double> weights(at.barycentric.data(), 3);
  return p.border ? p.border->measure(corners, weights) : p.solver->measure(corners, weights);
}

bool holds(const Tooth &tooth, const mesh::SurfacePoint &at) {
  return std::ranges::binary_search(tooth.faces, at.face);
}

// The group with most of these shares, `target` left out; none if there is no other.
Index strongest_of(const Prepared &p, const Eigen::VectorXd &share, Index target) {
  Vec<double> of_group(p.groups, 0);
  for (Index n = 0; n < p.nodes.size(); ++n)
    if (!p.outlier[n] && p.nodes.group[n] != field::gingiva_group && p.nodes.group[n] != target)
      of_group[p.nodes.group[n]] += share[n];
  const auto most = std::ranges::max_element(of_group);
  return most != of_group.end() && *most > 0 ? static_cast<Index>(most - of_group.begin()) : mesh::none;
}

bool on_gingiva(const Prepared &p, const mesh::SurfacePoint &at) {
  return p.nodes.gingiva != mesh::none && shares_at(p, at)[p.nodes.gingiva] > kGingiva;
}

// At the edge of a tooth: where it ends is known to about as much, and no other tooth lies under the click.
bool beside(const Prepared &p, const Tooth &tooth, const mesh::SurfacePoint &at) {
  return std::ranges::any_of(tooth.vertices,
                             [&](Index v) { return (p.surface->position[v] - at.position).norm() < kEdge; });
}

// The tooth of a group made of the click, and its neighbour.
Click separate_made(const Prepared &p, const mesh::SurfacePoint &at, std::span<const Index> separated, double pick_ms,
                    const Progress &progress) {
  Stopwatch watch;
  std::shared_ptr<const Prepared> made = make_group(p, at);
  if (const auto last = static_cast<Eigen::Index>(made->nodes.size()) - 1;
      made->border->schur()(last, last) > kEnclosed)
    throw Error(Fault::click_on_gingiva, "the click lies on gingiva or base, or too near the border of a crown");
  Pick picked = pick_group(*made, at, made->groups - 1);
  // The click is the centre of the group, and faces neither side.
  const auto away = [&](Index g) { return (centre_of(p, g) - at.position).norm(); };
  if (picked.other != mesh::none && away(picked.other) < away(picked.neighbour))
    std::swap(picked.neighbour, picked.other);
  settle(picked, separated);
  pick_ms += watch.lap();
  Click click = cut_out(*made, at, picked, pick_ms, progress);
  const Tooth &tooth = click.teeth[0];
  if (!holds(tooth, at) || (tooth.warnings & Warning::area_small))
    throw Error(Fault::click_on_gingiva,
                "the click lies on no crown: around it " + shown(tooth.area) + " mm^2 can be cut out");
  click.among = std::move(made);
  return click;
}

// Whether what a click cut out is no tooth of its own but the cingulum of `first`, which the fossa parts from its edge:
// it borders on that tooth, across the arch from its points and with its own top well below them.
bool shelf_of(const Prepared &p, const Tooth &tooth, const Tooth &first) {
  const Vec3 &along = p.along[first.group];
  if (along.isZero()) return false;
  const auto mean = [&](const Vec<Index> &vertices) {
    Vec3 sum = Vec3::Zero();
    for (const Index v : vertices) sum += p.surface->position[v];
    return Vec3(sum / static_cast<double>(vertices.size()));
  };
  const auto height = [&](Index v) { return p.surface->position[v].dot(p.occlusal); };
  const Vec3 points = mean(first.seeds);
  if (height(std::ranges::max(tooth.vertices, {}, height)) > points.dot(p.occlusal) - kBelow) return false;
  Vec3 away = mean(tooth.vertices) - points;
  away -= away.dot(p.occlusal) * p.occlusal;
  if (std::abs(away.dot(along)) > kAcross * away.norm()) return false;
  return std::ranges::any_of(tooth.vertices, [&](Index v) { return std::ranges::binary_search(first.vertices, v); });
}

// The teeth of the `first` click again, its target held at the click as well.
Click separate_extended(const Prepared &p, const mesh::SurfacePoint &at, const Click &first, double pick_ms,
                        const Progress &progress) {
  Stopwatch watch;
  std::shared_ptr<const Prepared> extended = extend_group(p, at, first.target);
  Pick picked;
  picked.target = first.target, picked.neighbour = first.neighbour, picked.target_distance = first.target_distance;
  Click click = cut_out(*extended, at, picked, pick_ms + watch.lap(), progress);
  if (!holds(click.teeth[0], at))
    throw Error(Fault::no_cut, "no cut takes the click and the tooth it borders on together");
  click.among = std::move(extended);
  return click;
}

}  // namespace

Click cut_out(const Prepared &p, const mesh::SurfacePoint &at, const Pick &picked, double pick_ms,
              const Progress &progress) {
  Stopwatch watch;
  Click click;
  click.at = at;
  click.target = picked.target;
  click.neighbour = picked.neighbour;
  click.target_distance = picked.target_distance;
  click.ms.pick = pick_ms;
  progress.part(0, 0.4, "field")(0);

  Fields fields(p, picked, !own_field_decides(p.options));
  const double nodes_ms = watch.lap();
  progress.part(0.4, 0.5, "cut")(0);

  // Each tooth's level and cut are one task where they need nothing of the other's.
  const bool own = own_field_decides(p.options);
  Selection selection;
  if (!own) selection = select_cuts(p, picked, fields);
  const double select_ms = watch.lap();
  double cut_ms[2] = {0, 0};
  progress.part(0.5, 1, "label")(0);

  Tooth both[2];
  bool found = false;
  p.executor->each(picked.neighbour == mesh::none ? 1 : 2, [&](std::size_t k) {
    const bool target = k == 0;
    const Index group = target ? picked.target : picked.neighbour;
    double &iso = target ? selection.target_iso : selection.neighbour_iso;
    Stopwatch task;
    Region region = own ? own_region(p, picked, fields, target) : pair_region(p, fields, iso, group, target);
    iso = region.iso;
    cut_ms[k] = task.lap();
    try {
      both[k] = extract_tooth(p, fields, std::move(region), group, target);
      if (!target) found = true;
    } catch (const Error &e) {
      if (target || e.fault() != Fault::no_cut) throw;  // the tooth clicked stands without its neighbour
    }
  });
  click.target_iso = selection.target_iso;
  click.neighbour_iso = selection.neighbour_iso;
  for (int k = 0; k < 1 + found; ++k) {
    measure_cuts(p, fields, both[k]);
    click.teeth.push_back(std::move(both[k]));
  }
  const double first = cut_ms[0], second = cut_ms[1];
  click.ms.cut = select_ms + (p.executor->threads() > 1 ? std::max(first, second) : first + second);
  click.ms.total = pick_ms + nodes_ms + select_ms + watch.lap();
  click.ms.label = std::max(0.0, click.ms.total - pick_ms - nodes_ms - click.ms.cut);
  // The field is solved where the cut looks at it; the two teeth may do so at the same time.
  click.ms.field = nodes_ms + fields.milliseconds();
  click.field_bytes = fields.bytes();
  progress(1);
  return click;
}

Tooth cut_out_target(const Prepared &p, const Pick &picked, const Progress &progress) {
  progress(0);
  const bool own = own_field_decides(p.options);
  Fields fields(p, picked, !own);
  Region region = own ? own_region_in_halves(p, picked, fields)
                      : pair_region(p, fields, select_cuts(p, picked, fields).target_iso, picked.target, true);
  progress(0.8);
  Tooth tooth = extract_tooth(p, fields, std::move(region), picked.target, true);
  measure_cuts(p, fields, tooth);
  progress(1);
  return tooth;
}

Pick take(const Prepared &p, const mesh::SurfacePoint &at) {
  if (at.distance > p.options.click_reach)
    throw Error(Fault::click_off_surface, "the click is " + shown(at.distance) + " mm from the surface");
  const Pick picked = pick(p, at);
  if (picked.target == mesh::none)
    throw Error(Fault::click_on_gingiva, "the click is on a piece of the surface without feature points");
  return picked;
}

Click separate(const Prepared &p, const mesh::SurfacePoint &at, const Pick &picked, double pick_ms,
               const Progress &progress, bool &evidence) {
  Click click = cut_out(p, at, picked, pick_ms, progress);
  evidence = false;
  if (holds(click.teeth[0], at)) return click;
  evidence = own_field_decides(p.options);
  if (!evidence && on_gingiva(p, at))
    throw Error(Fault::click_on_gingiva, "the click lies on gingiva or base, " + shown(picked.target_distance) +
                                             " from the nearest feature point");
  return click;
}

Click separate_by_evidence(const Prepared &p, const mesh::SurfacePoint &at, std::span<const Index> separated,
                           Click first, double pick_ms, const Progress &progress) {
  Stopwatch watch;
  // Whatever the gingiva's share: its tooth holds the click, or it does not.
  if (const Index group = strongest_of(p, shares_at(p, at), first.target); group != mesh::none) {
    Pick picked = pick_group(p, at, group);
    settle(picked, separated);
    pick_ms += watch.lap();
    try {
      Click click = cut_out(p, at, picked, pick_ms, progress.part(0, 0.5, "evidence"));
      if (holds(click.teeth[0], at)) return click;
    } catch (const Error &e) {
      if (e.fault() != Fault::no_cut) throw;  // then it is not what was clicked
    }
    pick_ms += watch.lap();
  }
  try {
    Click click = separate_made(p, at, separated, pick_ms + watch.lap(), progress.part(0.5, 0.8, "evidence"));
    if (!shelf_of(p, click.teeth[0], first.teeth[0])) return click;
    return separate_extended(p, at, first, pick_ms + watch.lap(), progress.part(0.8, 1, "evidence"));
  } catch (const Error &e) {
    const bool none = e.fault() == Fault::no_cut || e.fault() == Fault::click_on_gingiva;
    if (!none || !beside(p, first.teeth[0], at) || on_gingiva(p, at)) throw;
    return first;
  }
}

Index strongest_beside(const Prepared &p, const mesh::SurfacePoint &at, Index group) {
  const Eigen::VectorXd share = shares_at(p, at);
  const Index other = strongest_of(p, share, group);
  if (other == mesh::none) return field::gingiva_group;
  if (p.nodes.gingiva == mesh::none) return other;
  double of_other = 0, of_gingiva = 0;
  for (Index n = 0; n < p.nodes.size(); ++n) {
    if (p.nodes.group[n] == other && !p.outlier[n]) of_other += share[n];
    if (p.nodes.group[n] == field::gingiva_group) of_gingiva += share[n];
  }
  return of_gingiva > of_other ? field::gingiva_group : other;
}

}  // namespace ts::tooth
