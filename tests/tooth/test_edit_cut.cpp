#include <doctest/doctest.h>

#include <cstring>
#include <map>
#include <random>
#include <set>

#include "made_up.h"
#include "mesh/bvh.h"
#include "tooth/session.h"

using namespace ts;
using namespace ts::tooth;
using namespace made_up;

namespace {

// Tooth 2 of a row of five, and the others, as clicks cut them.
struct Bench {
  Row r = row(5);
  mesh::Bvh tree{r.surface};
  Segmenter segmenter{r.surface, r.features, default_options(), one};
  Click click = segmenter.click(r.at(centre_x(2) + 2, centre_y));
  Tooth tooth = click.teeth[0];
  Tooth neighbour = click.teeth[1];
  Vec<const Tooth *> others = {&neighbour};

  Tooth edit(const Tooth &t, const CutEdit &e) const {
    const auto nearest = [&](const Vec3 &p) { return tree.nearest(r.surface, p); };
    return segmenter.edit(t, e, {others, nearest}, click);
  }
  Tooth edit_again(const Tooth &t, std::span<EditRecord> e) const {
    const auto nearest = [&](const Vec3 &p) { return tree.nearest(r.surface, p); };
    return segmenter.edit_again(t, e, {others, nearest}, click);
  }
  Vec3 on(double x, double y) const {
    return tree.nearest(r.surface, {x, y, kHeight * (1 - std::pow(std::min(1.0, rho(x, y, 2)), 2.5))}).position;
  }
};

const Bench &bench() {
  static const Bench b;
  return b;
}

// The middle of the buccal side of tooth 2, where its cut runs along flat gum.
const Vec3 buccal(double out) {
  return bench().on(centre_x(2), centre_y - kHalfDepth - out);
}

std::size_t nearest_point(const cut::Polyline &line, const Vec3 &at) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < line.points.size(); ++i)
    if ((line.points[i].position - at).norm() < (line.points[best].position - at).norm()) best = i;
  return best;
}

double distance_to(const cut::Polyline &line, const Vec3 &at) {
  double least = 1e9;
  for (std::size_t i = 0; i < line.faces.size(); ++i) {
    const Vec3 &a = line.points[i].position, d = line.points[(i + 1) % line.points.size()].position - a;
    const double t = std::clamp((at - a).dot(d) / std::max(1e-30, d.squaredNorm()), 0.0, 1.0);
    least = std::min(least, (at - a - t * d).norm());
  }
  return least;
}

bool same_point(const cut::EdgePoint &p, const cut::EdgePoint &q) {
  return p.a == q.a && p.b == q.b && std::memcmp(&p.t, &q.t, sizeof p.t) == 0 &&
         std::memcmp(p.position.data(), q.position.data(), 3 * sizeof(double)) == 0;
}

bool same_tooth(const Tooth &a, const Tooth &b) {
  bool equal = a.group == b.group && a.faces == b.faces && a.vertices == b.vertices && a.seeds == b.seeds &&
               a.area == b.area && a.confidence == b.confidence && a.warnings == b.warnings &&
               a.gradient == b.gradient && a.loops.size() == b.loops.size();
  for (std::size_t i = 0; equal && i < a.loops.size(); ++i) {
    const auto &p = a.loops[i].line, &q = b.loops[i].line;
    equal = p.points.size() == q.points.size() && p.faces == q.faces && p.length == q.length;
    for (std::size_t k = 0; equal && k < p.points.size(); ++k) equal = same_point(p.points[k], q.points[k]);
  }
  return equal;
}

// In plan view, which is faithful for a height field.
bool encloses(const cut::Polyline &line, double x, double y) {
  bool in = false;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const Vec3 &a = line.points[i].position, &b = line.points[(i + 1) % line.points.size()].position;
    if ((a.y() > y) != (b.y() > y) && x < a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) in = !in;
  }
  return in;
}

// A closed, simple line on edges, around all seeds; figures that belong to the faces.
void check_valid(const Tooth &t) {
  const mesh::Surface &s = bench().r.surface;
  REQUIRE(t.loops.size() == 1);
  const cut::Polyline &line = t.loops[0].line;
  REQUIRE(line.closed);
  REQUIRE(line.faces.size() == line.points.size());
  double length = 0;
  std::size_t off = 0;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const cut::EdgePoint &p = line.points[i], &q = line.points[(i + 1) % line.points.size()];
    const auto &f = s.triangle[line.faces[i]];
    const auto in_face = [&](Index v) { return std::ranges::find(f, v) != f.end(); };
    off += !(in_face(p.a) && in_face(p.b) && in_face(q.a) && in_face(q.b)) || !(p.t > 0 && p.t < 1) ||
           (p.position - (1 - p.t) * s.position[p.a] - p.t * s.position[p.b]).norm() > 1e-9;
    length += (q.position - p.position).norm();
  }
  CHECK(off == 0);
  CHECK(std::abs(length - line.length) < 1e-9);
  // A triangle that is crossed once only cannot hold two segments that cross each other.
  CHECK(std::set<Index>(line.faces.begin(), line.faces.end()).size() == line.faces.size());
  std::size_t outside = 0;
  for (const Index v : t.seeds)
    outside += !encloses(line, s.position[v].x(), s.position[v].y()) || !std::ranges::binary_search(t.vertices, v);
  CHECK(outside == 0);
  double area = 0;
  std::set<Index> vertices;
  for (const Index f : t.faces) {
    area += s.face_area[f];
    vertices.insert(s.triangle[f].begin(), s.triangle[f].end());
  }
  CHECK(std::abs(t.area - area) < 1e-9);
  CHECK(t.vertices == Vec<Index>(vertices.begin(), vertices.end()));
  CHECK(std::ranges::is_sorted(t.faces));
  CHECK(t.loops[0].gradient > 0);
  CHECK(t.confidence > 0);
}

// Faces near a place belong to the tooth where more than half of them is within the line; counted by points of a fine
// grid over each, so that a face near to half and half may be either.
std::size_t faces_amiss(const Tooth &t, const Vec3 &at, double radius) {
  const mesh::Surface &s = bench().r.surface;
  std::size_t amiss = 0;
  for (Index f = 0; f < s.faces(); ++f) {
    const auto &v = s.triangle[f];
    const Vec3 &a = s.position[v[0]], &b = s.position[v[1]], &c = s.position[v[2]];
    if (((a + b + c) / 3 - at).norm() > radius) continue;
    int in = 0, all = 0;
    constexpr int kGrid = 12;
    for (int i = 0; i < kGrid; ++i)
      for (int j = 0; j < kGrid - i; ++j) {
        const double u = (i + 1.0 / 3) / kGrid, w = (j + 1.0 / 3) / kGrid;
        const Vec3 p = a + u * (b - a) + w * (c - a);
        in += encloses(t.loops[0].line, p.x(), p.y());
        ++all;
      }
    const double share = double(in) / all;
    if (std::abs(share - 0.5) > 0.1) amiss += (share > 0.5) != std::ranges::binary_search(t.faces, f);
  }
  return amiss;
}

// The points of `before` that are farther than `half` along it from point `at` and not among those of `after`.
std::size_t moved_beyond(const cut::Polyline &before, std::size_t at, double half, const cut::Polyline &after) {
  std::map<std::pair<Index, Index>, const cut::EdgePoint *> there;
  for (const cut::EdgePoint &p : after.points) there[{p.a, p.b}] = &p;
  const std::size_t n = before.points.size();
  Vec<double> along(n, 1e9);
  for (const bool on : {true, false}) {
    double sum = 0;
    for (std::size_t k = 0, i = at; k < n; ++k) {
      along[i] = std::min(along[i], sum);
      const std::size_t next = on ? (i + 1) % n : (i + n - 1) % n;
      sum += (before.points[next].position - before.points[i].position).norm();
      i = next;
    }
  }
  std::size_t moved = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (along[i] < half) continue;
    const auto it = there.find({before.points[i].a, before.points[i].b});
    moved += it == there.end() || !same_point(before.points[i], *it->second);
  }
  return moved;
}

CutEdit drag_of(const Vec3 &from, const Vec3 &to, double reach = 0) {
  return {EditKind::drag, {from, to}, reach};
}

Fault fault_of_edit(const CutEdit &edit, const Tooth &tooth = bench().tooth) {
  const Tooth before = tooth;
  try {
    bench().edit(tooth, edit);
  } catch (const Error &e) {
    CHECK(same_tooth(before, tooth));
    CHECK(std::strlen(e.what()) > 10);
    return e.fault();
  }
  return Fault::internal;  // no error
}

}  // namespace

TEST_CASE("a dragged cut passes through the new place, and stays where it is elsewhere") {
  const Tooth &before = bench().tooth;
  const cut::Polyline &line = before.loops[0].line;
  const std::size_t at = nearest_point(line, buccal(0));
  for (const double out : {1.0, 2.0, 0.4, -0.6}) {
    CAPTURE(out);
    const Vec3 to = buccal(out);
    const Tooth after = bench().edit(before, drag_of(line.points[at].position, to));
    check_valid(after);
    CHECK(distance_to(after.loops[0].line, to) < 0.02);
    CHECK((out > 0.3 ? after.area > before.area : after.area < before.area));
    CHECK(moved_beyond(line, at, 2.5 + 0.5, after.loops[0].line) == 0);
    CHECK(faces_amiss(after, to, 2) == 0);
    CHECK(after.group == before.group);
    CHECK(after.seeds == before.seeds);
    CHECK(after.iso == before.iso);
    // Far away the faces are the same.
    Vec<Index> changed;
    std::ranges::set_symmetric_difference(before.faces, after.faces, std::back_inserter(changed));
    CHECK(changed.empty() == false);
    for (const Index f : changed) CHECK((bench().r.surface.position[bench().r.surface.triangle[f][0]] - to).norm() < 5);
  }
}

TEST_CASE("a shorter reach moves less") {
  const cut::Polyline &line = bench().tooth.loops[0].line;
  const std::size_t at = nearest_point(line, buccal(0));
  const Tooth narrow = bench().edit(bench().tooth, drag_of(line.points[at].position, buccal(1), 1.5));
  const Tooth wide = bench().edit(bench().tooth, drag_of(line.points[at].position, buccal(1), 4));
  check_valid(narrow);
  check_valid(wide);
  CHECK(moved_beyond(line, at, 1.5 + 0.5, narrow.loops[0].line) == 0);
  CHECK(moved_beyond(line, at, 4 + 0.5, wide.loops[0].line) == 0);
  CHECK(wide.area > narrow.area);
}

TEST_CASE("a dragged cut follows the valley that it is dragged to") {
  const cut::Polyline &valley = bench().tooth.loops[0].line;
  const Tooth away = bench().edit(bench().tooth, {EditKind::offset, {}, 0.9});
  const std::size_t at = nearest_point(away.loops[0].line, buccal(0.9));
  const Tooth back = bench().edit(away, drag_of(away.loops[0].line.points[at].position,
                                                valley.points[nearest_point(valley, buccal(0))].position, 3));
  check_valid(back);
  // In the middle 3 mm of the stretch, all of which was .9 away.
  std::size_t many = 0, off = 0;
  for (const cut::EdgePoint &p : back.loops[0].line.points)
    if (std::abs(p.position.x() - centre_x(2)) < 1.5 && p.position.y() < centre_y) {
      ++many;
      off += distance_to(valley, p.position) > 0.25;
    }
  CHECK(many > 5);
  CHECK(off == 0);
}

TEST_CASE("drags that are refused change nothing and say why") {
  const cut::Polyline &line = bench().tooth.loops[0].line;
  const Vec3 from = line.points[nearest_point(line, buccal(0))].position;
  CHECK(fault_of_edit(drag_of(from, buccal(0) - Vec3(0, 0, 5))) == Fault::click_off_surface);
  CHECK(fault_of_edit(drag_of(from, from)) == Fault::edit_nothing);
  CHECK(fault_of_edit(drag_of(from, bench().on(centre_x(3), centre_y - 2))) == Fault::edit_on_tooth);
  CHECK(fault_of_edit(drag_of(from + Vec3(0, -4, 0), buccal(1))) == Fault::edit_off_cut);
  // Beyond the cut on the other side: past it the way leads around the teeth beside it.
  CHECK(fault_of_edit(drag_of(from, bench().on(centre_x(2), centre_y + kHalfDepth + 1.5))) == Fault::edit_on_tooth);
  // Onto the cut itself.
  CHECK(fault_of_edit(drag_of(from, bench().on(centre_x(2), centre_y + kHalfDepth))) == Fault::edit_crossing);
  // Past the points on this side.
  CHECK(fault_of_edit(drag_of(from, bench().on(centre_x(2), centre_y + 0.5))) == Fault::edit_crossing);
  // On a point.
  CHECK(fault_of_edit(drag_of(from, bench().on(centre_x(2) - 1.5, centre_y - 1.4))) == Fault::edit_crossing);
  CHECK(fault_of_edit(drag_of(from, buccal(1), -1)) == Fault::invalid_argument);
  CHECK(fault_of_edit(drag_of(from, buccal(1), std::nan(""))) == Fault::invalid_argument);
  CHECK(fault_of_edit(drag_of(from, Vec3(0, std::nan(""), 0))) == Fault::invalid_argument);
  CHECK(fault_of_edit({EditKind::drag, {from}, 0}) == Fault::invalid_argument);
}

TEST_CASE("a drawn stretch runs by its points, joined to the cut; the longer piece stays") {
  const Tooth &before = bench().tooth;
  const cut::Polyline &line = before.loops[0].line;
  CutEdit stroke{EditKind::draw, {}, 0};
  const Vec<Vec3> wanted = {bench().on(centre_x(2) - 2, centre_y - kHalfDepth - 0.3),
                            bench().on(centre_x(2) - 1, centre_y - kHalfDepth - 1.5),
                            bench().on(centre_x(2) + 1, centre_y - kHalfDepth - 1.6),
                            bench().on(centre_x(2) + 2, centre_y - kHalfDepth - 0.3)};
  stroke.points = wanted;
  const Tooth after = bench().edit(before, stroke);
  check_valid(after);
  for (std::size_t i = 1; i + 1 < wanted.size(); ++i)
    CHECK(distance_to(after.loops[0].line, wanted[i]) < 0.06);  // a corner, within a triangle
  // On flat gum the shortest way between two points is straight.
  for (double t = 0; t <= 1; t += 0.1)
    CHECK(distance_to(after.loops[0].line, (1 - t) * wanted[1] + t * wanted[2]) < 0.06);
  CHECK(after.area > before.area + 3);
  const std::size_t at = nearest_point(line, buccal(0));
  CHECK(moved_beyond(line, at, 3.2, after.loops[0].line) == 0);
  CHECK(faces_amiss(after, buccal(1), 2) == 0);
  // Drawn the other way round it is the same line.
  std::ranges::reverse(stroke.points);
  const Tooth other = bench().edit(before, stroke);
  check_valid(other);
  CHECK(std::abs(other.area - after.area) < 0.3);
  // A stroke with a loop in it.
  stroke.points = {wanted[0],
                   wanted[1],
                   wanted[2],
                   bench().on(centre_x(2) + 0.5, centre_y - kHalfDepth - 2.6),
                   bench().on(centre_x(2), centre_y - kHalfDepth - 0.8),
                   wanted[3]};
  check_valid(bench().edit(before, stroke));
}

TEST_CASE("strokes that are refused change nothing and say why") {
  const auto stroke = [](Vec<Vec3> points) { return CutEdit{EditKind::draw, std::move(points), 0}; };
  CHECK(fault_of_edit(stroke({})) == Fault::invalid_argument);
  CHECK(fault_of_edit(stroke({buccal(0)})) == Fault::invalid_argument);
  CHECK(fault_of_edit(stroke({buccal(0), Vec3(0, 0, std::nan(""))})) == Fault::invalid_argument);
  CHECK(fault_of_edit(stroke({buccal(0), buccal(0)})) == Fault::edit_nothing);
  CHECK(fault_of_edit(stroke({buccal(0), buccal(0) - Vec3(0, 0, 4)})) == Fault::click_off_surface);
  CHECK(fault_of_edit(stroke({buccal(4), buccal(6)})) == Fault::edit_off_cut);
  CHECK(fault_of_edit(stroke({buccal(0), buccal(6)})) == Fault::edit_off_cut);
  CHECK(fault_of_edit(stroke({buccal(0), bench().on(centre_x(3), centre_y - 2)})) == Fault::edit_on_tooth);
  CHECK(fault_of_edit(stroke({buccal(0), buccal(1), buccal(0)})) == Fault::edit_crossing);
  // Across the points of the tooth, and through its middle, which would leave some out.
  const auto across = [&](double x) {
    return stroke({bench().on(centre_x(2) + x, centre_y - kHalfDepth), bench().on(centre_x(2) + x, centre_y),
                   bench().on(centre_x(2) + x, centre_y + kHalfDepth)});
  };
  CHECK(fault_of_edit(across(1.5)) == Fault::edit_crossing);
  CHECK(fault_of_edit(across(0)) == Fault::edit_crossing);
}

TEST_CASE("an offset moves the cut by its amount, and the area with its sign") {
  const Tooth &before = bench().tooth;
  double last = 0;
  for (const double mm : {-0.9, -0.5, -0.2, 0.2, 0.5, 1.0}) {
    CAPTURE(mm);
    const Tooth after = bench().edit(before, {EditKind::offset, {}, mm});
    check_valid(after);
    CHECK(after.area > last);
    last = after.area;
    CHECK((mm > 0) == (after.area > before.area));
    // The area of a strip along the cut, more or less for its bends.
    const double strip = std::abs(after.area - before.area) / (before.loops[0].line.length * std::abs(mm));
    CHECK(strip > 0.75);
    CHECK(strip < 1.3);
    // On the flat gum the straight distance is that along the surface.
    if (mm > 0)
      for (const cut::EdgePoint &p : after.loops[0].line.points)
        if (p.position.y() < centre_y - kHalfDepth)
          CHECK(std::abs(distance_to(before.loops[0].line, p.position) - mm) < 0.12 * mm + 0.03);
    CHECK(faces_amiss(after, buccal(mm), 4) == 0);
  }
  CHECK(fault_of_edit({EditKind::offset, {}, 0}) == Fault::edit_nothing);
  CHECK(fault_of_edit({EditKind::offset, {}, -4}) == Fault::edit_no_loop);
  CHECK(fault_of_edit({EditKind::offset, {}, 6}) == Fault::edit_on_tooth);
  CHECK(fault_of_edit({EditKind::offset, {}, 1e300}) == Fault::edit_on_tooth);
  CHECK(fault_of_edit({EditKind::offset, {}, -INFINITY}) == Fault::invalid_argument);
}

TEST_CASE("smoothing shortens a cut, the more the stronger") {
  const Vec3 at = bench().tooth.loops[0].line.points[nearest_point(bench().tooth.loops[0].line, buccal(0))].position;
  const Tooth bent = bench().edit(bench().tooth, drag_of(at, buccal(1.5), 1.6));
  double last = bent.loops[0].line.length;
  for (const double strength : {0.2, 0.5, 1.0}) {
    const Tooth after = bench().edit(bent, {EditKind::smooth, {}, strength});
    check_valid(after);
    CHECK(after.loops[0].line.length < last);
    last = after.loops[0].line.length;
    CHECK(faces_amiss(after, buccal(0.5), 4) == 0);
  }
  for (const double bad : {0.0, -1.0, 2.5, double(INFINITY)})
    CHECK(fault_of_edit({EditKind::smooth, {}, bad}) == Fault::invalid_argument);
}

TEST_CASE("edits are applied again to the tooth of another click, or dropped with the reason") {
  const Tooth &automatic = bench().tooth;
  const cut::Polyline &line = automatic.loops[0].line;
  Vec<EditRecord> edits(3);
  edits[0].edit = drag_of(line.points[nearest_point(line, buccal(0))].position, buccal(1));
  edits[1].edit = drag_of(buccal(5), buccal(6));  // no cut there
  edits[2].edit = {EditKind::offset, {}, 0.2};
  const Tooth step = bench().edit(bench().edit(automatic, edits[0].edit), edits[2].edit);
  const Tooth again = bench().edit_again(automatic, edits);
  CHECK(same_tooth(step, again));
  CHECK(!edits[0].dropped);
  CHECK(edits[1].dropped);
  CHECK(edits[1].fault == Fault::edit_off_cut);
  CHECK(edits[1].why.find("mm from the cut") != std::string::npos);
  CHECK(!edits[2].dropped);
}

TEST_CASE("a session keeps the automatic tooth beside an edited one") {
  Session session(bench().r.surface);
  session.add(bench().segmenter.click(bench().r.at(centre_x(2) + 2, centre_y)));
  const Session before = session;
  Vec<EditRecord> edits(1);
  edits[0].edit = {EditKind::offset, {}, 0.3};
  session.replace(2, bench().edit(bench().tooth, edits[0].edit), edits);
  CHECK(session.tooth(2)->area > before.tooth(2)->area);
  CHECK(same_tooth(*session.automatic(2), *before.tooth(2)));
  CHECK(session.edits(2).size() == 1);
  CHECK(before.edits(2).empty());
  CHECK(same_tooth(*before.automatic(2), *before.tooth(2)));
  CHECK(session.automatic(0) == nullptr);
  session.replace(2, {}, {});
  CHECK(same_tooth(*session.tooth(2), *before.tooth(2)));
  CHECK(session.edits(2).empty());
}

#ifdef TS_SANITIZED
constexpr int kRuns = 60;  // ten times as slow
#else
constexpr int kRuns = 300;
#endif

TEST_CASE("random edits, one after the other in runs of up to six, never leave an invalid tooth") {
  std::mt19937 random(7);
  const auto uniform = [&](double a, double b) { return a + (b - a) * (static_cast<double>(random()) / 4294967296.0); };
  std::map<Fault, int> refused;
  int done = 0;
  for (int run = 0; run < kRuns; ++run) {
    Tooth tooth = bench().tooth;
    const int length = 1 + static_cast<int>(random() % 6);
    for (int k = 0; k < length; ++k) {
      const cut::Polyline &line = tooth.loops[0].line;
      const auto somewhere = [&](double far) {
        const Vec3 p = line.points[random() % line.points.size()].position;
        return bench().on(p.x() + uniform(-far, far), p.y() + uniform(-far, far));
      };
      CutEdit edit;
      switch (random() % 4) {
        case 0: {
          const Vec3 from = line.points[random() % line.points.size()].position;
          edit = drag_of(from, bench().on(from.x() + uniform(-2, 2), from.y() + uniform(-2, 2)),
                         random() % 2 ? 0 : uniform(0.5, 5));
          break;
        }
        case 1: {
          edit.kind = EditKind::draw;
          const std::size_t from = random() % line.points.size(), step = 2 + random() % 8;
          const double away = uniform(-1, 1);
          for (std::size_t i = 0; i < 4; ++i) {
            const Vec3 &p = line.points[(from + i * step) % line.points.size()].position;
            const Vec3 out = Vec3(p.x() - centre_x(2), p.y() - centre_y, 0).normalized() * (i % 3 ? away : 0);
            edit.points.push_back(bench().on(p.x() + out.x(), p.y() + out.y()));
          }
          if (random() % 5 == 0) edit.points.push_back(somewhere(2));
          break;
        }
        case 2: edit = {EditKind::offset, {}, uniform(-0.7, 0.7)}; break;
        default: edit = {EditKind::smooth, {}, uniform(0.01, 1)};
      }
      CAPTURE(run);
      CAPTURE(k);
      try {
        tooth = bench().edit(tooth, edit);
        ++done;
        check_valid(tooth);
      } catch (const Error &e) {
        ++refused[e.fault()];
      }
    }
  }
  MESSAGE(done << " done, " << refused[Fault::edit_crossing] << " crossing, " << refused[Fault::edit_on_tooth]
               << " on a tooth, " << refused[Fault::edit_no_loop] << " no loop, " << refused[Fault::edit_off_cut]
               << " off the cut, " << refused[Fault::internal] << " internal");
  CHECK(done > kRuns * 5 / 3);
  CHECK(refused[Fault::internal] == 0);
}
