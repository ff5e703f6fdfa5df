#include "tooth/edit_cut.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/shown.h"
#include "geometry/geodesic.h"
#include "tooth/edit_line.h"

namespace ts::tooth {
namespace {

// What is less than the accuracy of a scanner is no drag. mm.
constexpr double kNoLength = 0.01;

// How far aside the way of a drag is twice as dear, mm: what borders of labelled crowns lie from ours at the 95th
// percentile (docs/accuracy.md).
constexpr double kAside = 0.45;

void need_finite(double value, const char *name) {
  if (!std::isfinite(value)) throw Error(Fault::invalid_argument, std::string(name) + " is not finite");
}

mesh::SurfacePoint on_surface(const Prepared &p, const Tooth &tooth, const Vec3 &at, const Surroundings &around) {
  mesh::SurfacePoint point = around.nearest(at);
  if (point.distance > p.options.click_reach)
    throw Error(Fault::click_off_surface, shown(at) + " is " + shown(point.distance) + " mm from the surface");
  if (!std::ranges::binary_search(tooth.faces, point.face))
    for (const Tooth *other : around.others)
      if (std::ranges::binary_search(other->faces, point.face))
        throw Error(Fault::edit_on_tooth, shown(at) + " lies on another tooth");
  return point;
}

struct OnLine {
  Index loop = 0, place = 0;
  double distance = std::numeric_limits<double>::infinity();
};

// The point of a cut that is nearest to a position; of `loop` alone, if given.
OnLine nearest_on(const Tooth &tooth, const Vec3 &at, Index loop = mesh::none) {
  OnLine best;
  for (Index k = 0; k < tooth.loops.size(); ++k) {
    if (loop != mesh::none && k != loop) continue;
    const auto &points = tooth.loops[k].line.points;
    for (Index i = 0; i < points.size(); ++i)
      if (const double d = (points[i].position - at).norm(); d < best.distance) best = {k, i, d};
  }
  return best;
}

OnLine near_cut(const Prepared &p, const Tooth &tooth, const Vec3 &at, Index loop = mesh::none) {
  const OnLine on = nearest_on(tooth, at, loop);
  if (on.distance > p.options.click_reach)
    throw Error(Fault::edit_off_cut, shown(at) + " is " + shown(on.distance) + " mm from the cut, more than " +
                                         shown(p.options.click_reach));
  return on;
}

// From one place of a line on, or back, to the first that is `far` along it; an open line ends at its ends.
Index along(const cut::Polyline &line, Index from, bool on, double far) {
  const auto n = static_cast<Index>(line.points.size());
  Index at = from;
  for (double sum = 0; sum < far;) {
    if (!line.closed && at == (on ? n - 1 : 0)) break;
    const Index next = on ? (at + 1) % n : (at + n - 1) % n;
    sum += (line.points[next].position - line.points[at].position).norm();
    at = next;
  }
  return at;
}

double length_along(const cut::Polyline &line, Index from, Index to) {
  const auto n = static_cast<Index>(line.points.size());
  double sum = 0;
  for (Index i = from; i != to; i = (i + 1) % n)
    sum += (line.points[(i + 1) % n].position - line.points[i].position).norm();
  return sum;
}

// A stretch with its points moved along with the one at `place`, which goes to `to`, the less the farther they are from
// it; at most some 16 of them.
Vec<Vec3> bent(const cut::Polyline &line, const Stretch &stretch, Index place, double half, const Vec3 &to) {
  const auto n = static_cast<Index>(line.points.size());
  const Index count = (stretch.last + n - stretch.first) % n, every = count / 16 + 1;
  const Vec3 way = to - line.points[place].position;
  Vec<Vec3> guide;
  for (Index k = 0; k <= count; ++k) {
    const Index i = (stretch.first + k) % n;
    const bool before = k <= (place + n - stretch.first) % n;
    if (i != place && i != stretch.last && k % every != 0) continue;
    const double away = before ? length_along(line, i, place) : length_along(line, place, i);
    const double share = away < half ? (1 + std::cos(std::numbers::pi * away / half)) / 2 : 0;
    guide.push_back(line.points[i].position + share * way);
  }
  return guide;
}

double distance_to_line(const Vec3 &p, const Vec<Vec3> &line) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec3 d = line[i + 1] - line[i], q = p - line[i];
    const double l = d.squaredNorm();
    least = std::min(least, (q - (l > 0 ? std::clamp(q.dot(d) / l, 0.0, 1.0) : 0) * d).squaredNorm());
  }
  return std::sqrt(least);
}

void refuse_vertex(const Relining &lining, const Prepared &p, Index v) {
  if (lining.kind(v) == kForeign)
    throw Error(Fault::edit_on_tooth,
                "at " + shown(p.surface->position[v]) +
                    " the line would run through points of another tooth, or gingiva for certain");
  throw Error(Fault::edit_crossing, "at " + shown(p.surface->position[v]) +
                                        " the line would run through the rest of the cut, or the tooth's own points");
}

void refuse_unless_on(const Tooth &made, const Vec3 &at, double reach) {
  if (nearest_on(made, at).distance > reach)
    throw Error(Fault::edit_crossing, "the line cannot be led through " + shown(at) + ": the tooth is too thin there");
}

struct Freed {
  Stretch stretch;
  Index begin, end;  // of its border
};

// Frees the border along a stretch of `half` on either side of a point; a shorter one, and `half` with it, where it
// begins or ends so near to another part of the border that it is taken for that.
Freed free_around(const Prepared &p, Relining &lining, const cut::Polyline &line, const OnLine &on, double &half) {
  constexpr double kShorter = 0.85;
  for (int tries = 4;;) {
    Freed f{{on.loop, along(line, on.place, false, half), along(line, on.place, true, half)}, mesh::none, mesh::none};
    f.begin = lining.border().nearest(line.points[f.stretch.first], p.relief->length, half);
    f.end = lining.border().nearest(line.points[f.stretch.last], p.relief->length, half);
    if (f.stretch.first == f.stretch.last || f.begin == mesh::none || f.end == mesh::none || f.begin == f.end)
      throw Error(Fault::edit_crossing, "the mesh is too coarse for a stretch of " + shown(2 * half) + " mm");
    try {
      lining.border().free_stretch(f.begin, f.end, p.relief->length, lining.reach_along(f.stretch));
      return f;
    } catch (const Error &e) {
      if (e.fault() == Fault::cancelled || --tries == 0) throw;
      half *= kShorter;
    }
  }
}

Tooth drag(const Prepared &p, const Tooth &tooth, const CutEdit &edit, const Surroundings &around) {
  if (edit.points.size() != 2) throw Error(Fault::invalid_argument, "a drag is from one point to another");
  if (edit.amount < 0) throw Error(Fault::invalid_argument, "reach is negative");
  const mesh::Surface &s = *p.surface;
  const mesh::SurfacePoint to = on_surface(p, tooth, edit.points[1], around);
  const OnLine on = near_cut(p, tooth, edit.points[0]);
  const cut::Polyline &line = tooth.loops[on.loop].line;
  const Vec3 from = line.points[on.place].position;
  const double far = (to.position - from).norm();
  if (far < kNoLength) throw Error(Fault::edit_nothing, "the drag is " + shown(far) + " mm long");
  Relining lining(p, tooth);
  cut::Reroute &border = lining.border();
  // Of a short loop not all may move.
  double half = std::min(edit.amount > 0 ? edit.amount : std::max(kHalfStretch, far), 0.4 * line.length);
  const Freed freed = free_around(p, lining, line, on, half);
  const auto &[stretch, begin, end] = freed;
  const Index by = to.nearest_vertex(s);
  if (by == begin || by == end || border.barred(by) || lining.kind(by) != kFree) refuse_vertex(lining, p, by);
  border.bolt(begin), border.bolt(end);
  // As the minimum cut prices it, but what lies nearer to the old line than half the drag is no valley: it is what the
  // line is to leave. And dearer away from the old line bent towards the new place: where no valley leads, the mesh
  // must not.
  border.leave(far / 2, p.relief->length);
  const Vec<Vec3> guide = bent(line, stretch, on.place, half, to.position);
  const double most = 1.5 * (half + far);
  const auto way_to = [&](Index corner) {
    return border.cheapest(corner, by, [&](Index e) {
      const auto &[v, w] = s.edge[e];
      const auto out = [&](Index x) {
        return x != corner && (lining.kind(x) != kFree || (s.position[x] - from).norm() > most);
      };
      if (out(v) || out(w)) return std::numeric_limits<double>::infinity();
      const double price = border.is_left(v) && border.is_left(w) ? p.relief->length[e] : p.relief->price[e];
      return price * (1 + distance_to_line((s.position[v] + s.position[w]) / 2, guide) / kAside);
    });
  };
  // One way first, then the other, past it; where the first leaves no room, the other way round.
  Vec<Index> way;
  for (const bool forth : {true, false}) {
    Vec<Index> first = way_to(forth ? begin : end);
    for (const Index v : first)
      if (v != by) border.bolt(v);
    Vec<Index> second = first.empty() ? first : way_to(forth ? end : begin);
    if (second.empty()) {
      for (const Index v : first)
        if (v != begin && v != end) border.unbolt(v);
      continue;
    }
    if (!forth) first.swap(second);
    way = std::move(first);
    way.insert(way.end(), second.rbegin() + 1, second.rend());
    break;
  }
  if (way.empty())
    throw Error(Fault::edit_crossing,
                "no way leads from the cut through " + shown(to.position) + " that does not cross it");
  const cut::Through through[] = {{to.face, to.barycentric}};
  Tooth made = lining.follow(stretch, way, through, {});
  refuse_unless_on(made, to.position, s.mean_edge);
  return made;
}

// A stroke as it goes from vertex to vertex, with the points that it passes by, and where it crosses an edge.
struct Step {
  Index vertex;
  cut::Through through;
  cut::EdgePoint crossing = {};
};

cut::EdgePoint crossing_of(const mesh::Surface &s, const geometry::EdgeCrossing &c) {
  if (!(c.t > 1e-6 && c.t < 1 - 1e-6)) return {};  // at a vertex
  cut::EdgePoint p{c.a, c.b, c.t, Vec3::Zero()};
  if (p.a > p.b) std::swap(p.a, p.b), p.t = 1 - p.t;
  p.position = (1 - p.t) * s.position[p.a] + p.t * s.position[p.b];
  return p;
}

Vec<Step> steps_of(const Prepared &p, const Vec<mesh::SurfacePoint> &stroke, cut::Space &space) {
  const mesh::Surface &s = *p.surface;
  Vec<Step> steps;
  // Where the stroke comes back to itself the detour is left out.
  const auto add = [&](const Step &step) {
    const auto before = std::ranges::find(steps, step.vertex, &Step::vertex);
    if (before != steps.end() && steps.back().vertex != step.vertex) steps.erase(before + 1, steps.end());
    steps.push_back(step);
  };
  for (std::size_t i = 0; i < stroke.size(); ++i) {
    if (i > 0) {
      // Three times as long as straight is no stroke of a hand any more, but round another part.
      const double limit = 3 * (stroke[i].position - stroke[i - 1].position).norm() + 2;
      try {
        for (const geometry::EdgeCrossing &c : geometry::geodesic(s, stroke[i - 1], stroke[i], limit, space.march)) {
          const Index v = c.t < 0.5 ? c.a : c.b;
          const Index face = s.vertex_faces[v].front();
          cut::Through through{face, Vec3::Zero()};
          for (const Index f : s.vertex_faces[v]) {
            Vec3 weight = Vec3::Zero();
            for (std::size_t k = 0; k < 3; ++k)
              weight[static_cast<Eigen::Index>(k)] = s.triangle[f][k] == c.a   ? 1 - c.t
                                                     : s.triangle[f][k] == c.b ? c.t
                                                                               : 0;
            if (weight.sum() > 1 - 1e-12) {
              through = {f, weight};
              break;
            }
          }
          add({v, through, crossing_of(s, c)});
        }
      } catch (const Error &e) {
        if (e.fault() != Fault::not_found) throw;
        throw Error(Fault::edit_crossing, "no short way along the surface leads from " + shown(stroke[i - 1].position) +
                                              " to " + shown(stroke[i].position));
      }
    }
    add({stroke[i].nearest_vertex(s), {stroke[i].face, stroke[i].barycentric}});
  }
  return steps;
}

mesh::SurfacePoint point_of(const mesh::Surface &s, const cut::Polyline &line, Index place) {
  const cut::EdgePoint &at = line.points[place];
  mesh::SurfacePoint p;
  p.face = line.faces[std::min<std::size_t>(place, line.faces.size() - 1)];
  p.position = at.position;
  for (std::size_t k = 0; k < 3; ++k)
    p.barycentric[static_cast<Eigen::Index>(k)] = s.triangle[p.face][k] == at.a   ? 1 - at.t
                                                  : s.triangle[p.face][k] == at.b ? at.t
                                                                                  : 0;
  return p;
}

// Lets the steps begin on the border: at the last vertex of it that they pass before `join` mm, or by a short way to
// it.
void join_border(const Prepared &p, cut::Reroute &border, const cut::EdgePoint &at, double join, Vec<Step> &steps) {
  const mesh::Surface &s = *p.surface;
  std::size_t from = steps.size();
  double sum = 0;
  for (std::size_t i = 0; i < steps.size() && sum <= join; ++i) {
    if (border.on_border(steps[i].vertex)) from = i;
    if (i + 1 < steps.size()) sum += (s.position[steps[i + 1].vertex] - s.position[steps[i].vertex]).norm();
  }
  if (from < steps.size()) {
    steps.erase(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(from));
    return;
  }
  const Index begin = border.nearest(at, p.relief->length, join);
  const Vec<Index> way =
      begin == mesh::none ? Vec<Index>()
                          : border.cheapest(begin, steps.front().vertex, [&](Index e) { return p.relief->length[e]; });
  if (way.empty()) throw Error(Fault::edit_crossing, "the stroke cannot be joined to the cut at " + shown(at.position));
  const cut::Through none{s.vertex_faces[begin].front(), Vec3::Zero()};
  for (std::size_t i = way.size() - 1; i-- > 0;) steps.insert(steps.begin(), Step{way[i], none});
}

Tooth draw(const Prepared &p, const Tooth &tooth, const CutEdit &edit, const Surroundings &around) {
  if (edit.points.size() < 2)
    throw Error(Fault::invalid_argument, "a stroke has at least 2 points, not " + std::to_string(edit.points.size()));
  const mesh::Surface &s = *p.surface;
  Vec<mesh::SurfacePoint> stroke;
  for (const Vec3 &at : edit.points) stroke.push_back(on_surface(p, tooth, at, around));
  double length = 0;
  for (std::size_t i = 1; i < stroke.size(); ++i) length += (stroke[i].position - stroke[i - 1].position).norm();
  if (length < kNoLength) throw Error(Fault::edit_nothing, "the stroke is " + shown(length) + " mm long");
  const OnLine a = near_cut(p, tooth, stroke.front().position);
  const OnLine b = near_cut(p, tooth, stroke.back().position, a.loop);
  const cut::Polyline &line = tooth.loops[a.loop].line;
  if (a.place == b.place)
    throw Error(Fault::edit_crossing,
                "the stroke comes back to where it leaves the cut, " + shown(line.points[a.place].position));
  // The shorter of the two pieces goes.
  const bool ahead =
      line.closed ? length_along(line, a.place, b.place) <= length_along(line, b.place, a.place) : a.place < b.place;
  const Stretch stretch{a.loop, ahead ? a.place : b.place, ahead ? b.place : a.place};

  stroke.insert(stroke.begin(), point_of(s, line, a.place));
  stroke.push_back(point_of(s, line, b.place));
  Vec<Step> steps;
  {
    const auto space = p.space();
    steps = steps_of(p, stroke, *space);
  }
  Relining lining(p, tooth);
  cut::Reroute &border = lining.border();
  const double join = std::max(3 * s.mean_edge, 0.5);
  join_border(p, border, line.points[a.place], join, steps);
  std::ranges::reverse(steps);
  join_border(p, border, line.points[b.place], join, steps);
  if (ahead) std::ranges::reverse(steps);
  Vec<Index> way;
  Vec<cut::Through> through;
  cut::Polyline drawn;
  for (const Step &step : steps) {
    if (way.empty() || way.back() != step.vertex) way.push_back(step.vertex);
    if (!step.through.weight.isZero()) through.push_back(step.through);
    if (step.crossing.a != mesh::none) drawn.points.push_back(step.crossing);
  }
  if (way.size() < 2 || way.front() == way.back())
    throw Error(Fault::edit_nothing, "the stroke does not leave the cut");
  border.free_stretch(way.front(), way.back(), p.relief->length, lining.reach_along(stretch));
  for (std::size_t i = 1; i + 1 < way.size(); ++i)
    if (border.barred(way[i]) || lining.kind(way[i]) != kFree) refuse_vertex(lining, p, way[i]);
  return lining.follow(stretch, way, through, drawn);
}

}  // namespace

Tooth apply_edit(const Prepared &p, const Tooth &tooth, const CutEdit &edit, const Surroundings &around) {
  need_finite(edit.amount, "the amount of the edit");
  for (const Vec3 &at : edit.points)
    for (const double x : at) need_finite(x, "a point of the edit");
  switch (edit.kind) {
    case EditKind::drag: return drag(p, tooth, edit, around);
    case EditKind::draw: return draw(p, tooth, edit, around);
    case EditKind::offset:
      if (edit.amount == 0) throw Error(Fault::edit_nothing, "the offset is 0");
      return Relining(p, tooth).offset(edit.amount);
    case EditKind::smooth:
      if (!(edit.amount > 0 && edit.amount <= kMostSmoothing))
        throw Error(Fault::invalid_argument,
                    "strength is " + shown(edit.amount) + ", not within (0, " + shown(kMostSmoothing) + "]");
      return Relining(p, tooth).smooth(edit.amount);
  }
  throw Error(Fault::invalid_argument, "no such kind of edit");
}

Tooth apply_edits(const Prepared &p, Tooth tooth, std::span<EditRecord> edits, const Surroundings &around) {
  for (EditRecord &record : edits) {
    record.dropped = false;
    try {
      tooth = apply_edit(p, tooth, record.edit, around);
    } catch (const Error &e) {
      if (e.fault() == Fault::cancelled || e.fault() == Fault::out_of_memory) throw;
      record.dropped = true;
      record.fault = e.fault();
      record.why = e.what();
    }
  }
  return tooth;
}

}  // namespace ts::tooth
