#include <doctest/doctest.h>

#include "made_up.h"
#include "tooth/session.h"

using namespace ts;
using namespace ts::tooth;
using namespace made_up;

TEST_CASE("teeth and labels of a session do not depend on the order of its clicks") {
  const Row r = row(5);
  const Executor one(1);
  const Segmenter segmenter(r.surface, r.features, default_options(), one);
  const Vec<mesh::SurfacePoint> points = {r.at(centre_x(0) + 2, centre_y), r.at(centre_x(3) - 2, centre_y),
                                          r.at(centre_x(3) + 2, centre_y)};
  Session forth(r.surface), back(r.surface);
  CHECK(forth.labels() == Vec<std::uint32_t>(r.surface.faces(), 0));
  for (Index k = 0; k < 3; ++k) CHECK(forth.add(segmenter.click(points[k])) == k);
  for (Index k = 3; k-- > 0;) back.add(segmenter.click(points[k]));
  CHECK(forth.teeth() == Vec<Index>{0, 1, 2, 3, 4});
  CHECK(back.teeth() == forth.teeth());
  const Vec<std::uint32_t> labels = forth.labels();
  CHECK(labels == back.labels());
  double right = 0;
  for (Index f = 0; f < labels.size(); ++f)
    if (labels[f] == r.label[f]) right += r.surface.face_area[f];
  CHECK(right / r.surface.area > 0.95);
  // Separated again: the later click has it.
  CHECK(forth.click_of(3) == 2);
  CHECK(back.click_of(3) == 1);
  CHECK(forth.click_of(2) == 1);
  CHECK(forth.click(1).neighbour == 2);
  CHECK(forth.tooth(3) != nullptr);
  CHECK(forth.clicks() == 3);
}

TEST_CASE("nothing there: no tooth, no click") {
  const Row r = row(2);
  Session s(r.surface);
  CHECK(s.teeth().empty());
  CHECK(s.tooth(0) == nullptr);
  CHECK(s.click_of(0) == mesh::none);
  CHECK_THROWS_AS(s.click(0), Error);
}

TEST_CASE("a face of two teeth goes to the one with the nearer seed, whichever came first") {
  const Row r = row(2);
  const auto tooth = [&](Index group, double seed_x) {
    Click c;
    Tooth t;
    t.group = group;
    for (Index f = 0; f < r.surface.faces(); ++f) t.faces.push_back(f);
    t.seeds = {r.vertex_at(seed_x, 10)};
    c.teeth.push_back(t);
    return c;
  };
  Session a(r.surface), b(r.surface);
  a.add(tooth(0, 10)), a.add(tooth(1, 30));
  b.add(tooth(1, 30)), b.add(tooth(0, 10));
  CHECK(a.labels() == b.labels());
  const Vec<std::uint32_t> labels = a.labels();
  for (Index f = 0; f < labels.size(); ++f) {
    const double x = r.surface.position[r.surface.triangle[f][0]].x();
    if (x < 17) CHECK(labels[f] == 1);
    if (x > 23) CHECK(labels[f] == 2);
  }
}
