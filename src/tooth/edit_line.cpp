#include "tooth/edit_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/shown.h"
#include "cut/contour.h"
#include "tooth/extract.h"

namespace ts::tooth {
namespace {

// What smoothing and offsets may leave out without a word, mm^2: a disc of the radius that lines are smoothed by has
// .1, the occlusal face of the smallest tooth some 25.
constexpr double kCrumb = 1;
constexpr double kShort = 3.5;  // mm: around a disc of that area

// Where a preset does not smooth: the default's, without which no line could be led through a point. mm.
constexpr double kSmooth = 0.2;

double distance_to_segment(const Vec3 &p, const Vec3 &a, const Vec3 &b) {
  const Vec3 d = b - a;
  const double l = d.squaredNorm();
  return (p - a - (l > 0 ? std::clamp((p - a).dot(d) / l, 0.0, 1.0) : 0) * d).norm();
}

// visit(vertex, distance) for the corners of the faces that a segment of the line crosses.
void each_corner(const mesh::Surface &s, const cut::Polyline &line, std::size_t i, const auto &visit) {
  const Vec3 &a = line.points[i].position, &b = line.points[(i + 1) % line.points.size()].position;
  for (const Index v : s.triangle[line.faces[i]]) visit(v, distance_to_segment(s.position[v], a, b));
}

Vec<const cut::Polyline *> lines_of(const Tooth &tooth) {
  Vec<const cut::Polyline *> lines;
  for (const Cut &c : tooth.loops) lines.push_back(&c.line);
  return lines;
}

// The marks and the region that the border is taken of.
cut::Space &sides_of(const mesh::Surface &s, std::span<const cut::Polyline *const> lines,
                     const cut::CrossedEdges &crossed, cut::Space &space) {
  cut::mark_sides(s, lines, space);
  cut::take_within(s, crossed, space);
  return space;
}

constexpr std::uint8_t kKept = 16;  // a mark beside those of the cut room: on an edge that is crossed where it was

}  // namespace

Relining::Relining(const Prepared &prepared, const Tooth &tooth)
    : p_(prepared),
      s_(*prepared.surface),
      tooth_(tooth),
      space_(prepared.space()),
      lines_(lines_of(tooth)),
      crossed_(s_, lines_),
      border_(s_, sides_of(s_, lines_, crossed_, *space_)) {}

double Relining::radius() const {
  return p_.options.smooth_radius > 0 ? p_.options.smooth_radius : kSmooth;
}

double Relining::reach_along(const Stretch &stretch) const {
  const cut::Polyline &line = *lines_[stretch.loop];
  const auto n = static_cast<Index>(line.points.size());
  double length = 0;
  for (Index i = stretch.first; i != stretch.last; i = (i + 1) % n)
    length += (line.points[(i + 1) % n].position - line.points[i].position).norm();
  return 2 * length + 20 * s_.mean_edge;  // edges zigzag
}

void Relining::hold_inside() {
  for (const Index v : space_->marks.touched())
    if (within(v)) space_->level.set(v, -1);
}

// Beside the line that stays psi has the profile of a smoothed step, by the distance from it: so that which is made
// anew joins it.
void Relining::hold_kept(const Vec<cut::CrossedEdge> &kept) {
  SparseArray<double> &psi = space_->level;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Vec<std::pair<Index, double>> distance;
  for (const cut::CrossedEdge &c : kept) {
    const cut::Polyline &line = *lines_[c.line];
    if (c.place >= line.faces.size()) continue;
    const std::size_t next = (c.place + 1) % line.points.size();
    const auto &q = line.points[next];
    if (!(space_->marks[q.a] & kKept) || !(space_->marks[q.b] & kKept)) continue;
    each_corner(s_, line, c.place, [&](Index v, double d) { distance.emplace_back(v, d); });
  }
  std::ranges::sort(distance);
  for (const cut::CrossedEdge &c : kept)
    for (const Index v : {c.point.a, c.point.b}) {
      const auto at = std::ranges::lower_bound(distance, v, {}, &std::pair<Index, double>::first);
      const double d = at != distance.end() && at->first == v ? at->second : kFar;
      const double value = std::max(1e-9, 1 - std::exp(-d / radius()));
      psi.set(v, within(v) ? -value : value);
    }
}

Tooth Relining::follow(const Stretch &stretch, std::span<const Index> way, std::span<const cut::Through> through,
                       const cut::Polyline &drawn) {
  cut::Space &space = *space_;
  border_.take(way, tooth_.seeds);
  const auto n = static_cast<Index>(lines_[stretch.loop]->points.size());
  const Index steps = (stretch.last + n - stretch.first) % n;
  Vec<cut::CrossedEdge> kept;
  Vec<geometry::PathStart> starts;
  for (const cut::CrossedEdge &c : crossed_.all()) {
    const Index along = (c.place + n - stretch.first) % n;
    const bool stays = c.line != stretch.loop || along == 0 || along >= steps;
    if (stays) kept.push_back(c);
    for (const Index v : {c.point.a, c.point.b}) {
      if (stays)
        space.marks.set(v, space.marks[v] | kKept);
      else
        starts.push_back({v});
    }
  }
  for (const Index v : way) starts.push_back({v});
  for (const Index v : border_.freed()) starts.push_back({v});
  Vec<Index> zone;
  for (const Index v : space.paths.within(
           starts, [&](Index e) { return p_.relief->length[e]; }, std::max(4 * radius(), 2 * s_.mean_edge)))
    if (!(space.marks[v] & kKept) && kind(v) == kFree) zone.push_back(v);
  std::ranges::sort(zone);
  for (const Index f : space.faces.touched()) {
    if (!space.faces[f]) continue;
    for (const Index v : s_.triangle[f]) {
      if (space.level[v] != 1) continue;
      double in = 0, out = 0;
      for (const Index g : s_.vertex_faces[v]) (space.faces[g] ? in : out) += s_.face_area[g];
      double psi = out > 0 ? (out - in) / (out + in) : -1;
      if (out > 0 && !std::ranges::binary_search(zone, v)) psi = within(v) ? -1 : 1;  // on what stays of the border
      space.level.set(v, psi);
    }
  }
  hold_kept(kept);
  cut::smooth_psi(s_, p_.relief->cotangent, radius(), zone, through, space);
  return finish(std::move(zone), kept, drawn);
}

Tooth Relining::offset(double mm) {
  cut::Space &space = *space_;
  geometry::Marcher &march = space.march;
  march.begin(geometry::Marcher::Front::straight);
  for (const cut::Polyline *line : lines_)
    for (std::size_t i = 0; i < line->faces.size(); ++i)
      each_corner(s_, *line, i, [&](Index v, double d) { march.start(v, d); });
  Vec<Index> zone;
  march.run([&](Index v, double d) {
    if (d > std::abs(mm)) return false;
    if (mm < 0 && within(v) && kind(v) == kOwn)
      throw Error(Fault::edit_no_loop,
                  "a cut moved inwards by " + shown(-mm) + " mm would leave out feature points of the tooth");
    if (mm > 0 && !within(v) && p_.group_at[v] != mesh::none && p_.group_at[v] != tooth_.group)
      throw Error(Fault::edit_on_tooth,
                  "a cut moved outwards by " + shown(mm) + " mm would take in feature points of another tooth");
    zone.push_back(v);
    return true;
  });
  // Those beside them too, whose distances the march has left behind.
  const std::size_t reached = zone.size();
  for (std::size_t i = 0; i < reached; ++i)
    for (const Index e : s_.vertex_edges[zone[i]]) zone.push_back(s_.other_end(e, zone[i]));
  for (const cut::CrossedEdge &c : crossed_.all()) zone.push_back(c.point.a), zone.push_back(c.point.b);
  std::ranges::sort(zone);
  zone.erase(std::unique(zone.begin(), zone.end()), zone.end());
  hold_inside();
  for (const Index v : zone) space.level.set(v, (within(v) ? -march.distance(v) : march.distance(v)) - mm);
  return finish(std::move(zone), {}, {});
}

Tooth Relining::smooth(double radius) {
  cut::Space &space = *space_;
  Vec<geometry::PathStart> starts;
  for (const cut::CrossedEdge &c : crossed_.all()) starts.push_back({c.point.a}), starts.push_back({c.point.b});
  Vec<Index> zone;
  for (const Index v : space.paths.within(
           starts, [&](Index e) { return p_.relief->length[e]; }, std::max(4 * radius, 2 * s_.mean_edge)))
    if (kind(v) == kFree) zone.push_back(v);
  std::ranges::sort(zone);
  hold_inside();
  for (const geometry::PathStart &at : starts) {
    if (!std::ranges::binary_search(zone, at.vertex)) continue;
    double in = 0, all = 0;
    for (const Index f : s_.vertex_faces[at.vertex]) {
      const double share = cut::share_within(
          s_, f, [&](Index v) { return within(v); }, crossed_);
      in += share * s_.face_area[f];
      all += s_.face_area[f];
    }
    space.level.set(at.vertex, all > 0 ? 1 - 2 * in / all : 1);
  }
  cut::smooth_psi(s_, p_.relief->cotangent, radius, zone, {}, space);
  return finish(std::move(zone), {}, {});
}

// psi is set; the region is space.inside, and space.faces where a border was led another way.
Tooth Relining::finish(Vec<Index> zone, const Vec<cut::CrossedEdge> &kept, const cut::Polyline &drawn) {
  cut::Space &space = *space_;
  space.marks.clear();
  const double lost = cut::drop_unreached(s_, zone, true, tooth_.seeds, space);
  const double filled = cut::drop_unreached(s_, zone, false, {}, space);
  if (lost > kCrumb || filled > kCrumb)
    throw Error(Fault::edit_no_loop, "the cut would fall into several: a piece of " + shown(std::max(lost, filled)) +
                                         " mm^2 would come off");
  Vec<Index> around;
  for (const Index v : zone)
    for (const Index f : s_.vertex_faces[v]) around.push_back(f);
  std::ranges::sort(around);
  around.erase(std::unique(around.begin(), around.end()), around.end());
  Vec<Index> among = around;
  for (const cut::Polyline *line : lines_) among.insert(among.end(), line->faces.begin(), line->faces.end());
  std::ranges::sort(among);
  among.erase(std::unique(among.begin(), among.end()), among.end());
  Vec<cut::Polyline> lines = cut::contour(
      s_, [&](Index v) { return space.level[v]; }, 0, among);
  // Short loops may go, and open lines may come off the rim of the scan and become one; none may fall into several.
  const auto is_open = [](const cut::Polyline &l) { return !l.closed; };
  Index were_open = 0, have_to_stay = 0;
  for (const cut::Polyline *line : lines_) {
    were_open += is_open(*line);
    have_to_stay += line->closed && line->length > kShort;
  }
  const auto are_open = static_cast<Index>(std::ranges::count_if(lines, is_open));
  if (lines.empty() || lines.size() < have_to_stay || lines.size() > lines_.size() || are_open > were_open)
    throw Error(Fault::edit_no_loop, "the cut would be " + std::to_string(lines.size()) + " lines, " +
                                         std::to_string(are_open) + " of them open; it is " +
                                         std::to_string(lines_.size()) + ", " + std::to_string(were_open) +
                                         " of them open");
  join_kept(lines, kept, drawn);
  Tooth made;
  made.group = tooth_.group;
  made.seeds = tooth_.seeds;
  made.iso = tooth_.iso;
  std::ranges::stable_sort(lines, [](const auto &a, const auto &b) { return a.length > b.length; });
  for (cut::Polyline &line : lines) made.loops.push_back({std::move(line), tooth_.iso, 0, 0});
  take_faces(around, made);
  take_stock(p_, made, space);
  check_points(made);
  return made;
}

// Puts the points that stay in their places, each line beginning with the first of them.
void Relining::join_kept(Vec<cut::Polyline> &lines, const Vec<cut::CrossedEdge> &kept,
                         const cut::Polyline &drawn) const {
  if (kept.empty()) return;
  Vec<const cut::Polyline *> views;
  for (const cut::Polyline &l : lines) views.push_back(&l);
  const cut::CrossedEdges anew(s_, views);
  // Where a point is on its edge does not change what the line crosses.
  const cut::Polyline *const hand[] = {&drawn};
  const cut::CrossedEdges by_hand(s_, hand);
  for (const cut::CrossedEdge &c : by_hand.all())
    if (const cut::CrossedEdge *at = anew.find(c.edge)) lines[at->line].points[at->place] = c.point;
  Vec<std::pair<Index, Index>> begin(lines.size(), {mesh::none, 0});  // place in the old line, in the new one
  for (const cut::CrossedEdge &c : kept) {
    const cut::CrossedEdge *at = anew.find(c.edge);
    if (!at)
      throw Error(Fault::edit_crossing, "the new line would run over the cut beyond the stretch that it is to replace");
    lines[at->line].points[at->place] = c.point;
    begin[at->line] = std::min(begin[at->line], {c.place, at->place});
  }
  for (std::size_t k = 0; k < lines.size(); ++k) {
    cut::Polyline &line = lines[k];
    if (line.closed && begin[k].first != mesh::none) {
      std::rotate(line.points.begin(), line.points.begin() + begin[k].second, line.points.end());
      std::rotate(line.faces.begin(), line.faces.begin() + begin[k].second, line.faces.end());
    }
    line.length = 0;
    for (std::size_t i = 0; i < line.faces.size(); ++i)
      line.length += (line.points[(i + 1) % line.points.size()].position - line.points[i].position).norm();
  }
}

// A face that the new line crosses belongs to the tooth with more than half of its area; far from it faces stay.
void Relining::take_faces(std::span<const Index> around, Tooth &made) {
  cut::Space &space = *space_;
  Vec<Index> come, gone;
  if (!space.faces.touched().empty()) {
    for (const Index f : space.faces.touched())
      if (space.faces[f] && !space.inside[f]) come.push_back(f);
    for (const Index f : space.inside.touched())
      if (space.inside[f] && !space.faces[f]) gone.push_back(f);
  }
  space.inside.clear();
  for (const Index f : tooth_.faces) space.inside.set(f, 1);
  for (const Index f : come) space.inside.set(f, 1);
  for (const Index f : gone) space.inside.set(f, 0);
  const cut::CrossedEdges crossed(s_, lines_of(made));
  const auto inner = [&](Index v) { return space.level[v] < 0; };
  for (const Index f : around) {
    const bool in = cut::share_within(s_, f, inner, crossed) > 0.5;
    if (in != (space.inside[f] != 0)) space.inside.set(f, in);
  }
  cut::keep_seeded(s_, tooth_.seeds, space.inside);
  made.faces = cut::faces_of(space.inside);
}

void Relining::check_points(const Tooth &made) const {
  for (const Index v : made.seeds)
    if (!(space_->level[v] < 0) || !std::ranges::binary_search(made.vertices, v))
      throw Error(Fault::edit_crossing, "a feature point of the tooth would lie outside the cut");
  for (const Index v : made.vertices)
    if (const Index g = p_.group_at[v];
        g != mesh::none && g != made.group && space_->level[v] < 0 && !std::ranges::binary_search(tooth_.vertices, v))
      throw Error(Fault::edit_on_tooth, "a feature point of another tooth would lie within the cut");
}

}  // namespace ts::tooth
