#include <doctest/doctest.h>

#include "made_up.h"
#include "tooth/session.h"

using namespace ts;
using namespace ts::tooth;
using namespace made_up;

namespace {

constexpr Index kMissing = 2, kMade = 4;  // the tooth without a group; the index of a made one: after four groups

// Five teeth, the middle one without a group: those beyond it are groups 2 and 3.
const Row &gapped() {
  static const Row r = [] {
    Row all = row(5);
    all.features.groups.erase(all.features.groups.begin() + kMissing);
    return all;
  }();
  return r;
}
Index tooth_of(Index group) {
  return group == kMade ? kMissing : group < kMissing ? group : group + 1;
}

const Segmenter &segmenter() {
  static const Segmenter s(gapped().surface, gapped().features, default_options(), one);
  return s;
}
mesh::SurfacePoint on(Index tooth, double dx = 0, double dy = 0) {
  return gapped().at(centre_x(tooth) + dx, centre_y + dy);
}
bool holds(const Tooth &t, const mesh::SurfacePoint &at) {
  return std::binary_search(t.faces.begin(), t.faces.end(), at.face);
}
bool same(const Click &a, const Click &b) {
  bool equal = a.target == b.target && a.neighbour == b.neighbour && a.target_distance == b.target_distance &&
               a.teeth.size() == b.teeth.size();
  for (std::size_t k = 0; equal && k < a.teeth.size(); ++k)
    equal = a.teeth[k].group == b.teeth[k].group && a.teeth[k].faces == b.teeth[k].faces &&
            a.teeth[k].seeds == b.teeth[k].seeds && a.teeth[k].confidence == b.teeth[k].confidence;
  return equal;
}

}  // namespace

TEST_CASE("a click on a crown without a group makes one") {
  for (const double dx : {-2.0, 0.0, 1.5}) {
    const mesh::SurfacePoint at = on(kMissing, dx, 0.8);
    const Click c = segmenter().click(at);
    CHECK(c.target == kMade);
    CHECK(c.neighbour == (dx > 0 ? 2 : 1));  // beside it along the arch, the nearer one
    CHECK(c.among);
    CHECK(c.target_distance < segmenter().details(c).neighbour_distance);
    REQUIRE(c.teeth.size() == 2);
    for (const Tooth &t : c.teeth) CHECK(iou(gapped(), t.faces, tooth_of(t.group)) > 0.9);
    CHECK(holds(c.teeth[0], at));
    CHECK(c.teeth[0].warnings == Warning::made_by_click);
    CHECK(c.teeth[0].confidence < 0.75);
    CHECK(c.teeth[1].warnings == 0);
    // The disc of the click, and nothing further away.
    CHECK(c.teeth[0].seeds.size() > 5);
    for (const Index v : c.teeth[0].seeds) CHECK((gapped().surface.position[v] - at.position).norm() <= 0.7 + 1e-9);
    const ClickView view = segmenter().view(c);
    for (const Index v : c.teeth[0].seeds) CHECK(std::abs(view.u[v]) < 1e-5);
    for (const Index v : c.teeth[1].seeds) CHECK(std::abs(view.u[v] - 1) < 1e-5);
  }
  Options vertex = default_options();
  vertex.seed_radius = 0;
  const Click c = Segmenter(gapped().surface, gapped().features, vertex, one).click(on(kMissing));
  CHECK(c.target == kMade);
  CHECK(c.teeth[0].seeds.size() == 1);
}

TEST_CASE("a made group is there for the clicks that follow") {
  Session session(gapped().surface);
  const auto click = [&](const mesh::SurfacePoint &at) {
    session.add(segmenter().click(at, session.teeth(), {}, session.among()));
  };
  click(on(kMissing, -1, 0.5));
  const Vec<Index> faces = session.tooth(kMade)->faces;
  for (const double dx : {-2.4, 0.3, 2.4}) {  // it finds it, however near another's points, and makes no other
    click(on(kMissing, dx, -1));
    CHECK(session.click(session.clicks() - 1).target == kMade);
    CHECK(session.tooth(kMade)->faces == faces);
  }
  click(on(1, 2));  // it is the neighbour there, and background
  CHECK(session.click(session.clicks() - 1).target == 1);
  CHECK(session.click(session.clicks() - 1).neighbour == 0);  // passed over: it stands separated
  click(on(3, 1));
  click(on(4));
  CHECK(session.teeth() == Vec<Index>{0, 1, kMade, 2, 3});
  for (const Index g : session.teeth()) {
    CHECK(iou(gapped(), session.tooth(g)->faces, tooth_of(g)) > 0.9);
    CHECK(((session.tooth(g)->warnings & Warning::made_by_click) != 0) == (g == kMade));
  }
  // The labels: feature groups from 1, then the made one.
  const Vec<std::uint32_t> labels = session.labels();
  double right = 0;
  for (Index f = 0; f < labels.size(); ++f)
    if ((labels[f] == 0 ? 0 : tooth_of(labels[f] - 1) + 1) == gapped().label[f]) right += gapped().surface.face_area[f];
  CHECK(right / gapped().surface.area > 0.95);
  CHECK(segmenter().groups() == 4);
}

TEST_CASE("several groups can be made, each with an index of its own") {
  Row r = row(6);
  std::erase_if(r.features.groups, [](const auto &g) {
    const double x = g.points[0].position.x();
    return std::abs(x - centre_x(1)) < 3 || std::abs(x - centre_x(4)) < 3;
  });
  const Segmenter s(r.surface, r.features, default_options(), one);
  Session session(r.surface);
  for (const Index tooth : {4u, 1u, 4u, 1u})
    session.add(s.click(r.at(centre_x(tooth), centre_y), session.teeth(), {}, session.among()));
  for (const Index k : {0u, 2u}) CHECK(session.click(k).target == 4);
  for (const Index k : {1u, 3u}) CHECK(session.click(k).target == 5);
  CHECK(iou(r, session.tooth(4)->faces, 4) > 0.9);
  CHECK(iou(r, session.tooth(5)->faces, 1) > 0.9);
  const Vec<Index> teeth = session.teeth();
  CHECK(std::ranges::find(teeth, 5u) < std::ranges::find(teeth, 4u));
}

TEST_CASE("the last crown of a row without a group, where the field is the gingiva's but for a fifth") {
  Row r = row(3);
  r.features.groups.erase(r.features.groups.begin());
  Options o = default_options();
  o.gingiva_distance = 20;  // they are steep: 13 along them do not reach the second
  const Segmenter s(r.surface, r.features, o, one);
  const Click c = s.click(r.at(centre_x(0), centre_y));
  CHECK(c.target == 2);
  CHECK(c.neighbour == 0);
  CHECK(iou(r, c.teeth[0].faces, 0) > 0.9);
}

TEST_CASE("two crowns side by side without a group") {
  Row r = row(6);
  r.features.groups.erase(r.features.groups.begin() + 2, r.features.groups.begin() + 4);
  Options o = default_options();
  o.gingiva_distance = 20;  // they are steep: 13 along them do not reach the second
  const Segmenter s(r.surface, r.features, o, one);
  Session session(r.surface);
  for (const Index tooth : {3u, 2u, 3u})
    session.add(s.click(r.at(centre_x(tooth), centre_y), session.teeth(), {}, session.among()));
  CHECK(session.click(0).target == 4);
  CHECK(session.click(1).target == 5);
  CHECK(session.click(2).target == 4);
  CHECK(session.click(1).neighbour == 1);  // the made one beside it stands separated
  CHECK(iou(r, session.tooth(4)->faces, 3) > 0.9);
  CHECK(iou(r, session.tooth(5)->faces, 2) > 0.9);
  CHECK(session.teeth() == Vec<Index>{1, 5, 4, 2});
}

TEST_CASE("clicks at once are the same clicks one after the other, also where one makes a group") {
  Vec<mesh::SurfacePoint> at = {
      on(0, 1),  on(kMissing, 0, 0.5), on(1, 1), gapped().at(centre_x(2), 1.0), on(kMissing, 1),
      on(3, -2), on(kMissing, -1),     on(4)};
  for (const unsigned threads : {1u, 3u}) {
    const Executor executor(threads);
    const Segmenter s(gapped().surface, gapped().features, default_options(), executor);
    const auto outcomes = s.clicks(at, {});
    Session session(gapped().surface);
    for (std::size_t i = 0; i < at.size(); ++i) {
      CAPTURE(i);
      CHECK(outcomes[i].click.has_value() == (i != 3));
      if (!outcomes[i].click) {
        CHECK(outcomes[i].fault == Fault::click_on_gingiva);
        continue;
      }
      const Click c = segmenter().click(at[i], session.teeth(), {}, session.among());
      CHECK(same(c, *outcomes[i].click));
      session.add(c);
    }
    CHECK(session.teeth().size() == 5);
    // A batch goes on from what was made before it.
    const auto more = s.clicks(Vec<mesh::SurfacePoint>{on(kMissing, 1, 1)}, session.teeth(), {}, session.among());
    REQUIRE(more[0].click);
    CHECK(more[0].click->target == kMade);
  }
}

#ifdef TS_SANITIZED
constexpr double kClickStride = 2;  // ten times as slow
#else
constexpr double kClickStride = 1;
#endif

TEST_CASE("what is clicked beside the crowns is refused as ever, and makes nothing") {
  const Click made = segmenter().click(on(kMissing));
  for (const Among &among : {Among(), made.among})
    for (const double y : {1.0, centre_y - kHalfDepth - 4, centre_y + kHalfDepth + 5})
      CHECK(fault_of([&] { segmenter().click(gapped().at(centre_x(kMissing), y), {}, {}, among); }) ==
            Fault::click_on_gingiva);
  // A tooth is what holds the click, or what it lies at the edge of and no other tooth is under it; or none is given.
  const auto at_edge = [](const Tooth &t, const mesh::SurfacePoint &at) {
    return std::ranges::any_of(t.vertices,
                               [&](Index v) { return (gapped().surface.position[v] - at.position).norm() < 1; });
  };
  int given = 0;
  for (double x = centre_x(0) - 3; x < centre_x(4) + 3; x += kClickStride * 0.83)
    for (double y = centre_y - 4; y < centre_y + 4; y += kClickStride * 1.17) {
      const mesh::SurfacePoint at = gapped().at(x, y);
      try {
        const Click c = segmenter().click(at);
        CHECK((holds(c.teeth[0], at) || at_edge(c.teeth[0], at)));
        CHECK(iou(gapped(), c.teeth[0].faces,
                  gapped().label[at.face] ? gapped().label[at.face] - 1 : tooth_of(c.target)) > 0.8);
        ++given;
      } catch (const Error &e) {
        CHECK((e.fault() == Fault::click_on_gingiva || e.fault() == Fault::no_cut));
      }
    }
  CHECK(given > 150 / (kClickStride * kClickStride));
}

TEST_CASE("the paper's pair stays the closest two, whatever was clicked") {
  Options o = paper_options();
  const Segmenter s(gapped().surface, gapped().features, o, one);
  const Click c = s.click(on(kMissing, -1));
  CHECK(c.target < kMade);
  CHECK(!c.among);
}
