#include <doctest/doctest.h>

#include <cstring>
#include <set>

#include "made_up.h"
#include "tooth/segmenter.h"

using namespace ts;
using namespace ts::tooth;
using namespace made_up;

namespace {

const Row &five() {
  static const Row r = row(5);
  return r;
}

bool same(const Tooth &a, const Tooth &b) {
  bool equal = a.group == b.group && a.faces == b.faces && a.vertices == b.vertices && a.seeds == b.seeds &&
               a.area == b.area && a.confidence == b.confidence && a.loops.size() == b.loops.size();
  for (std::size_t i = 0; equal && i < a.loops.size(); ++i) {
    const auto &p = a.loops[i].line.points, &q = b.loops[i].line.points;
    equal = p.size() == q.size() && a.loops[i].gradient == b.loops[i].gradient;
    for (std::size_t k = 0; equal && k < p.size(); ++k)
      equal = p[k].a == q[k].a && p[k].b == q[k].b && p[k].t == q[k].t && p[k].position == q[k].position;
  }
  return equal;
}

void check_cut(const mesh::Surface &s, const Tooth &t) {
  REQUIRE(t.loops.size() == 1);
  CHECK(t.loops[0].line.closed);
  CHECK(t.loops[0].gradient > 0);
  // Every point within about an edge of the border of the faces.
  std::set<Index> faces(t.faces.begin(), t.faces.end()), border;
  for (const Index f : t.faces)
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      if (s.twin[h] != mesh::none && !faces.contains(mesh::face_of(s.twin[h]))) {
        border.insert(s.from(h));
        border.insert(s.to(h));
      }
  for (const auto &p : t.loops[0].line.points) {
    double near = 1e9;
    for (const Index v : border) near = std::min(near, (s.position[v] - p.position).norm());
    CHECK(near < 2 * s.mean_edge);
  }
}

}  // namespace

TEST_CASE("a click separates the tooth under it and the neighbour nearer to it") {
  const Segmenter segmenter(five().surface, five().features, default_options(), one);
  for (Index k = 0; k < 5; ++k)
    for (const double side : {-1.0, 1.0}) {
      const Click c = segmenter.click(five().at(centre_x(k) + side * 2, centre_y + 0.6));
      CHECK(c.target == k);
      const Index other = k == 0 ? 1 : k == 4 ? 3 : side < 0 ? k - 1 : k + 1;
      CHECK(c.neighbour == other);
      CHECK(c.target_distance < segmenter.details(c).neighbour_distance);
      REQUIRE(c.teeth.size() == 2);
      for (const Tooth &t : c.teeth) {
        CHECK(iou(five(), t.faces, t.group) > 0.9);
        CHECK(t.warnings == 0);
        CHECK(t.confidence > 0.8);
        CHECK((t.group == k ? t.iso > 0 && t.iso < 0.5 : t.iso > 0.5 && t.iso < 1));  // its side of the rest
        check_cut(five().surface, t);
        for (const Index v : t.seeds) CHECK(std::binary_search(t.vertices.begin(), t.vertices.end(), v));
      }
    }
}

TEST_CASE("the half rule cuts half way between a tooth and the rest") {
  Options o = default_options();
  o.cut_rule = CutRule::half;
  const Click c = Segmenter(five().surface, five().features, o, one).click(five().at(centre_x(1) + 2, centre_y));
  CHECK(c.teeth[0].iso == 0.25);
  CHECK(c.teeth[1].iso == 0.75);
}

TEST_CASE("what a tooth is does not depend on the pair it was separated in") {
  const Segmenter segmenter(five().surface, five().features, default_options(), one);
  const Click a = segmenter.click(five().at(centre_x(1) + 2, centre_y));
  const Click b = segmenter.click(five().at(centre_x(3) - 2, centre_y));
  REQUIRE(a.teeth[1].group == 2);
  REQUIRE(b.teeth[1].group == 2);
  CHECK(a.teeth[1].faces == b.teeth[1].faces);
}

TEST_CASE("other backgrounds and rules find the same teeth on an easy row") {
  for (const Background background : {Background::neighbour, Background::gingiva, Background::all})
    for (const CutRule rule : {CutRule::gradient, CutRule::component, CutRule::half}) {
      Options o = default_options();
      o.background = background;
      o.cut_rule = rule;
      // A pair alone leaves the teeth beyond it undecided: ends of a row of two.
      const Row pair = row(2);
      const Segmenter segmenter(pair.surface, pair.features, o, one);
      const Click c = segmenter.click(pair.at(centre_x(0), centre_y));
      REQUIRE(c.teeth.size() == 2);
      CAPTURE(int(background));
      CAPTURE(int(rule));
      for (const Tooth &t : c.teeth) CHECK(iou(pair, t.faces, t.group) > 0.9);
    }
}

TEST_CASE("every weighting scheme runs") {
  for (const auto scheme : {field::Scheme::concavity, field::Scheme::paper, field::Scheme::cotangent,
                            field::Scheme::uniform, field::Scheme::feature}) {
    Options o = default_options();
    o.weights = scheme;
    const Segmenter segmenter(five().surface, five().features, o, one);
    const Click c = segmenter.click(five().at(centre_x(2), centre_y));
    CHECK(iou(five(), c.teeth[0].faces, 2) > 0.5);
  }
}

TEST_CASE("the paper's pair: u is 0 and 1 on the points, split at V_med, cut where the gradient is largest") {
  const Row pair = row(2);
  const Segmenter segmenter(pair.surface, pair.features, paper_options(), one);
  const Click c = segmenter.click(pair.at(centre_x(0), centre_y));
  CHECK(c.target == 0);
  CHECK(c.neighbour == 1);
  const ClickView view = segmenter.view(c);
  for (const auto &p : pair.features.groups[0].points) CHECK(std::abs(view.u[p.vertex]) < 1e-4);
  for (const auto &p : pair.features.groups[1].points) CHECK(std::abs(view.u[p.vertex] - 1) < 1e-4);
  for (const double u : view.u) CHECK((u > -1e-9 && u < 1 + 1e-9));
  Index all = 0;
  for (const Index n : view.histogram) all += n;
  CHECK(all == pair.surface.vertices());
  const auto fullest = std::max_element(view.histogram.begin(), view.histogram.end()) - view.histogram.begin();
  const double v_med = segmenter.details(c).v_med;
  CHECK(v_med == doctest::Approx((double(fullest) + 0.5) / 50));
  REQUIRE(view.contours.size() == 100);
  const Contour *best[2] = {};
  for (const Contour &k : view.contours) {
    const Contour *&b = best[k.iso > v_med];
    if (k.length > 0 && (!b || k.gradient > b->gradient)) b = &k;
  }
  CHECK(best[0]->iso == c.target_iso);
  CHECK(best[1]->iso == c.neighbour_iso);
  CHECK(best[0]->chosen == 1);
  CHECK(best[1]->chosen == 2);
  int chosen = 0;
  for (const Contour &k : view.contours) chosen += k.chosen != 0;
  CHECK(chosen == 2);
  for (const Tooth &t : c.teeth) CHECK(!t.faces.empty());
}

TEST_CASE("any number of threads gives the same bytes") {
  const Executor three(3);
  const Segmenter a(five().surface, five().features, default_options(), one);
  const Segmenter b(five().surface, five().features, default_options(), three);
  Vec<Click> together(5);
  three.each(5, [&](std::size_t k) { together[k] = b.click(five().at(centre_x(Index(k)) + 1, centre_y)); });
  for (Index k = 0; k < 5; ++k) {
    const Click c = a.click(five().at(centre_x(k) + 1, centre_y));
    CHECK(c.target == together[k].target);
    CHECK(c.neighbour == together[k].neighbour);
    REQUIRE(c.teeth.size() == together[k].teeth.size());
    for (std::size_t i = 0; i < c.teeth.size(); ++i) CHECK(same(c.teeth[i], together[k].teeth[i]));
    const ClickView u = a.view(c), v = b.view(together[k]);
    CHECK(u.u == v.u);
    CHECK(u.histogram == v.histogram);
    REQUIRE(u.contours.size() == v.contours.size());
    for (std::size_t i = 0; i < u.contours.size(); ++i) CHECK(u.contours[i].gradient == v.contours[i].gradient);
  }
}

TEST_CASE("the proposed clicks cover all teeth, two a click, the last alone of an odd number") {
  for (const Index n : {1u, 2u, 4u, 5u}) {
    const Row r = row(n);
    const Segmenter segmenter(r.surface, r.features, default_options(), one);
    const Vec<Vec3> clicks = segmenter.propose_clicks();
    CHECK(clicks.size() == (n + 1) / 2);
    std::set<Index> found;
    for (const Vec3 &p : clicks)
      for (const Tooth &t : segmenter.click(r.at(p.x(), p.y())).teeth) found.insert(t.group);
    CHECK(found.size() == n);
  }
}

TEST_CASE("clicks beside the teeth are refused: off the surface, on the gum, on a piece without points") {
  const Segmenter segmenter(five().surface, five().features, default_options(), one);
  mesh::SurfacePoint off = five().at(centre_x(0), centre_y);
  off.distance = 2.5;
  CHECK(fault_of([&] { segmenter.click(off); }) == Fault::click_off_surface);
  for (const double y : {1.0, centre_y - kHalfDepth - 4, centre_y + kHalfDepth + 5})
    CHECK(fault_of([&] { segmenter.click(five().at(centre_x(2), y)); }) == Fault::click_on_gingiva);
  // But never on a crown, however near its border.
  for (double a = 0; a < 6.2; a += 0.4) {
    const double x = centre_x(2) + 0.8 * kHalfWidth * std::cos(a), y = centre_y + 0.8 * kHalfDepth * std::sin(a);
    CHECK(segmenter.click(five().at(x, y)).target == 2);
  }
}

TEST_CASE("one group alone is cut from the gingiva, with a warning") {
  const Row r = row(1);
  Options pair = paper_options();
  pair.seed_radius = 0.7;
  for (const Options &o : {default_options(), pair}) {
    const Segmenter segmenter(r.surface, r.features, o, one);
    const Click c = segmenter.click(r.at(centre_x(0), centre_y));
    CHECK(c.neighbour == mesh::none);
    CHECK(std::isnan(c.neighbour_iso));
    REQUIRE(c.teeth.size() == 1);
    CHECK((c.teeth[0].warnings & Warning::no_neighbour) != 0);
    CHECK(iou(r, c.teeth[0].faces, 0) > (o.preset == Preset::paper ? 0.3 : 0.9));
  }
}

TEST_CASE("no point at all, options out of range, cancellation") {
  features::Features none = five().features;
  for (auto &g : none.groups) g.points.clear();
  CHECK(fault_of([&] { Segmenter(five().surface, none, default_options(), one); }) == Fault::no_constraint);
  const auto refused = [&](const auto &change) {
    Options o = default_options();
    change(o);
    return fault_of([&] { check(o); }) == Fault::invalid_argument;
  };
  CHECK(refused([](Options &o) { o.beta = 0; }));
  CHECK(refused([](Options &o) { o.alpha = -1; }));
  CHECK(refused([](Options &o) { o.c0 = std::nan(""); }));
  CHECK(refused([](Options &o) { o.contours = 0; }));
  CHECK(refused([](Options &o) { o.histogram_bins = 1; }));
  CHECK(refused([](Options &o) { o.area_max = 10; }));
  CHECK(refused([](Options &o) { o.weights = static_cast<field::Scheme>(9); }));
  CHECK_NOTHROW(check(default_options()));
  CHECK_NOTHROW(check(paper_options()));

  struct Stop final : Monitor {
    int left = 0;
    bool proceed(double, const char *) noexcept override { return left-- > 0; }
  };
  for (int k = 0; k < 4; ++k) {
    Stop stop;
    stop.left = k;
    CHECK(fault_of([&] { Segmenter(five().surface, five().features, default_options(), one, Progress(&stop)); }) ==
          Fault::cancelled);
  }
}

TEST_CASE("a point put on the wrong tooth is freed, reported, and does no harm") {
  Row r = row(3);
  const Index v = r.vertex_at(centre_x(1), centre_y);
  r.features.groups[0].points.push_back({v, r.surface.position[v], 0.3});
  const Segmenter segmenter(r.surface, r.features, default_options(), one);
  CHECK(segmenter.rejected_points(0) == Vec<Index>{4});
  CHECK(segmenter.rejected_points(1).empty());
  const Click c = segmenter.click(r.at(centre_x(0), centre_y));
  for (const Tooth &t : c.teeth) {
    CHECK(iou(r, t.faces, t.group) > 0.88);
    CHECK((t.warnings & Warning::seed_rejected) == (t.group == 0 ? Warning::seed_rejected : 0u));
  }
}

TEST_CASE("fewer points a tooth when asked for") {
  Options o = default_options();
  o.points_per_group = 1;
  o.seed_radius = 0;
  const Segmenter segmenter(five().surface, five().features, o, one);
  CHECK(segmenter.click(five().at(centre_x(2), centre_y)).teeth[0].seeds.size() == 1);
  o.points_per_group = 3;
  const Segmenter more(five().surface, five().features, o, one);
  CHECK(more.click(five().at(centre_x(2), centre_y)).teeth[0].seeds.size() == 3);
}

TEST_CASE("a crown at the border of the scan has an open cut and says so") {
  // The row cut off through the middle of its first tooth.
  Row r = row(3);
  Vec<mesh::Vec3> position;
  Vec<mesh::Triangle> triangle;
  Vec<Index> place(r.surface.vertices(), mesh::none);
  for (const auto &t : r.surface.triangle) {
    bool keep = true;
    for (const Index v : t) keep = keep && r.surface.position[v].x() > centre_x(0) - 0.1;
    if (!keep) continue;
    mesh::Triangle moved{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (place[t[k]] == mesh::none) place[t[k]] = Index(position.size()), position.push_back(r.surface.position[t[k]]);
      moved[k] = place[t[k]];
    }
    triangle.push_back(moved);
  }
  for (auto &g : r.features.groups) {
    std::erase_if(g.points, [&](const auto &p) { return place[p.vertex] == mesh::none; });
    for (auto &p : g.points) p.vertex = place[p.vertex];
  }
  r.surface = mesh::make_surface(position, triangle);
  const Segmenter segmenter(r.surface, r.features, default_options(), one);
  const Click c = segmenter.click(r.at(centre_x(0) + 1, centre_y));
  CHECK(c.target == 0);
  CHECK((c.teeth[0].warnings & Warning::open_at_border) != 0);
  REQUIRE(c.teeth[0].loops.size() == 1);
  CHECK(!c.teeth[0].loops[0].line.closed);
  CHECK((c.teeth[1].warnings & Warning::open_at_border) == 0);
}

TEST_CASE("a piece of the scan that is all tooth is taken whole") {
  Row r = row(2);
  const mesh::Surface crown = forms::plane(8, 8, 16, 16);
  Vec<Vec3> position(r.surface.position);
  Vec<mesh::Triangle> triangle(r.surface.triangle);
  const Index first_vertex = static_cast<Index>(position.size()), first_face = static_cast<Index>(triangle.size());
  for (const Vec3 &q : crown.position) position.push_back(q + Vec3(60, 0, 0));
  for (const mesh::Triangle &t : crown.triangle)
    triangle.push_back({t[0] + first_vertex, t[1] + first_vertex, t[2] + first_vertex});
  r.surface = mesh::make_surface(std::move(position), std::move(triangle));
  const Index middle = r.vertex_at(64, 4);
  r.features.groups.push_back({{{middle, r.surface.position[middle], 0.3}}, 0, 0, 1});
  const Segmenter segmenter(r.surface, r.features, default_options(), one);
  const Click c = segmenter.click(r.at(64, 4));
  CHECK(c.target == 2);
  REQUIRE(!c.teeth.empty());
  CHECK(c.teeth[0].faces.size() == crown.faces());
  CHECK(c.teeth[0].faces.front() == first_face);
  CHECK(c.teeth[0].loops.empty());
  CHECK((c.teeth[0].warnings & Warning::several_loops) != 0);
}
