#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include "features/analysis.h"
#include "made_up.h"
#include "mesh/bvh.h"
#include "mesh_judge.h"
#include "tooth/crossings.h"
#include "tooth/frame.h"
#include "tooth/session.h"
#include "tooth/tooth_mesh.h"
#include "toothseg_arch.h"

using namespace ts;
using namespace ts::tooth;
using namespace made_up;

namespace {

std::vector<judge::Point> points_of(const PartMesh &m) {
  std::vector<judge::Point> points;
  for (const Vec3 &p : m.position) points.push_back({p.x(), p.y(), p.z()});
  return points;
}

std::vector<judge::Face> faces_of(const PartMesh &m) {
  std::vector<judge::Face> faces;
  for (const Triangle &t : m.triangle) faces.push_back({t[0], t[1], t[2]});
  return faces;
}

// What must hold of every closed part, by our own count of its sides and by the judges.
void check_closed(const PartMesh &m) {
  std::set<std::pair<Index, Index>> sides;
  for (const auto &[a, b, c] : m.triangle)
    for (const auto &[v, w] : {std::pair{a, b}, {b, c}, {c, a}}) CHECK(sides.insert({v, w}).second);
  for (const auto &[v, w] : sides) CHECK(sides.contains({w, v}));
  CHECK(m.loops == 0);
  CHECK(m.volume > 0);
  CHECK(judge::watertight(points_of(m), faces_of(m)));
  for (const auto &crossing : judge::crossings_near(points_of(m), faces_of(m), {m.flag.begin(), m.flag.end()}))
    CHECK_MESSAGE(false, "triangles ", crossing[0], " and ", crossing[1], " cross");
  for (Index v = 0; v < m.position.size(); ++v) CHECK(m.normal[v].norm() == doctest::Approx(1));
}

struct Parts {
  Vec<PartMesh> tooth;
  PartMesh gingiva;
};

// All parts of a session, open; they have to add up.
Parts parts_of(const mesh::Surface &s, const Session &session, bool inside_out = false) {
  Vec<const Tooth *> teeth;
  for (const Index g : session.teeth()) teeth.push_back(session.tooth(g));
  const Partition p = partition(s, teeth);
  Parts parts;
  double area = 0;
  for (Index k = 0; k < teeth.size(); ++k) {
    parts.tooth.push_back(part_of(p, k, inside_out, one));
    area += parts.tooth.back().area;
  }
  parts.gingiva = part_of(p, mesh::none, inside_out, one);
  CHECK((area + parts.gingiva.area) / s.area == doctest::Approx(1).epsilon(1e-12));
  return parts;
}

Session all_teeth(const mesh::Surface &s, const features::Features &f) {
  const Segmenter segmenter(s, f, default_options(), one);
  Session session(s);
  Vec<mesh::SurfacePoint> at;
  const mesh::Bvh bvh(s);
  for (const Vec3 &p : segmenter.propose_clicks()) at.push_back(bvh.nearest(s, p));
  for (auto &o : segmenter.clicks(at, {}))
    if (o.click) session.add(std::move(*o.click));
  return session;
}

mesh::Surface arch(std::uint64_t seed, double crowding, std::uint32_t triangles) {
  tsa_options o{};
  REQUIRE(tsa_options_init(&o, sizeof o) == TSA_OK);
  o.jaw = seed % 2 ? TSA_JAW_UPPER : TSA_JAW_LOWER;
  o.crowding = crowding;
  o.seed = seed;
  o.triangles = triangles;
  tsa_arch *made = nullptr;
  REQUIRE(tsa_create(&o, &made) == TSA_OK);
  const std::unique_ptr<tsa_arch, decltype(&tsa_destroy)> keep(made, tsa_destroy);
  std::uint32_t vertices = 0, faces = 0;
  REQUIRE(tsa_get_positions(made, nullptr, 0, &vertices) == TSA_OK);
  REQUIRE(tsa_get_triangles(made, nullptr, 0, &faces) == TSA_OK);
  Vec<Vec3> position(vertices);
  Vec<Triangle> triangle(faces);
  REQUIRE(tsa_get_positions(made, position.data()->data(), vertices, &vertices) == TSA_OK);
  REQUIRE(tsa_get_triangles(made, triangle.data()->data(), faces, &faces) == TSA_OK);
  return mesh::make_surface(std::move(position), std::move(triangle));
}

// The surface without the faces whose centre is as `gone` says.
mesh::Surface without(const mesh::Surface &s, const auto &gone) {
  Vec<Triangle> triangle;
  for (const Triangle &t : s.triangle)
    if (!gone((s.position[t[0]] + s.position[t[1]] + s.position[t[2]]) / 3)) triangle.push_back(t);
  Vec<Vec3> position;
  Vec<Index> place(s.vertices(), mesh::none);
  for (Triangle &t : triangle)
    for (Index &v : t) {
      if (place[v] == mesh::none) place[v] = static_cast<Index>(position.size()), position.push_back(s.position[v]);
      v = place[v];
    }
  return mesh::make_surface(std::move(position), std::move(triangle));
}

}  // namespace

TEST_CASE("parts share the points of the cut bit for bit") {
  const Row r = row(3);
  const Parts parts = parts_of(r.surface, all_teeth(r.surface, r.features));
  REQUIRE(parts.tooth.size() == 3);
  const auto less = [](const Vec3 &a, const Vec3 &b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::map<Vec3, int, decltype(less)> count(less);
  const auto add = [&](const PartMesh &m) {
    for (Index v = 0; v < m.position.size(); ++v)
      if (m.flag[v] & VertexFlag::on_cut) ++count[m.position[v]];
  };
  for (const PartMesh &m : parts.tooth) {
    CHECK(judge::manifold_and_oriented(points_of(m), faces_of(m)));
    CHECK(m.loops == 1);
    CHECK(m.volume == 0);
    add(m);
  }
  add(parts.gingiva);
  CHECK(count.size() > 200);
  for (const auto &[p, n] : count) CHECK(n >= 2);
}

TEST_CASE("teeth of a row, closed") {
  const Row r = row(3);
  for (PartMesh m : parts_of(r.surface, all_teeth(r.surface, r.features)).tooth) {
    const double area = m.area;
    close(m, one, {});
    check_closed(m);
    CHECK(m.filled == 1);
    CHECK(m.area - m.fill_area == doctest::Approx(area).epsilon(m.trimmed ? 0.03 : 1e-12));
    CHECK(m.fill_area == doctest::Approx(40).epsilon(0.25));  // of the foot: some 6.8 by 6.4, rounded
    // The foot is flat: what closes it is so too, where the tooth stands on the gum.
    for (Index v = 0; v < m.position.size(); ++v)
      if (m.flag[v] & VertexFlag::of_fill) CHECK(m.position[v].z() < 0.3 * kHeight);
  }
}

TEST_CASE("the gingiva with its sockets and the rim of the scan closed") {
  const Row r = row(2);
  PartMesh m = parts_of(r.surface, all_teeth(r.surface, r.features)).gingiva;
  CHECK(m.loops >= 2);  // the rim, and the sockets, which hang together where the teeth touch
  close(m, one, {});
  CHECK(judge::watertight(points_of(m), faces_of(m)));
}

TEST_CASE("a scan whose faces look inwards: parts look outwards all the same") {
  const Row r = row(2);
  Vec<Triangle> turned = r.surface.triangle;
  for (Triangle &t : turned) std::swap(t[1], t[2]);
  const mesh::Surface s = mesh::make_surface(r.surface.position, turned);
  features::Features f = r.features;
  f.inside_out = true;
  for (PartMesh m : parts_of(s, all_teeth(s, f), true).tooth) {
    close(m, one, {});
    check_closed(m);
  }
}

#ifdef TS_SANITIZED
constexpr unsigned kArches = 1;  // ten times as slow
#else
constexpr unsigned kArches = 3;
#endif

TEST_CASE("synthetic arches: every tooth closed, watertight, manifold, oriented and without crossings at the cut") {
  if (!judge::has_cgal()) MESSAGE("CGAL is not installed: crossings are not judged");
  constexpr double crowding[] = {0.65, 0.35, 0};
  for (unsigned k = 0; k < kArches; ++k) {
    CAPTURE(k);
    const mesh::Surface s = arch(3 - k, crowding[k], 30000);
    const Parts parts = parts_of(s, all_teeth(s, features::detect(s, {}, one, {})));
    CHECK(parts.tooth.size() >= 12);
    for (PartMesh m : parts.tooth) {
      close(m, one, {});
      check_closed(m);
    }
  }
}

TEST_CASE("a hole of the scan in a crown, a cut over a hole, a crown at the rim: closed too") {
  const Row r = row(2);
  const double x = centre_x(1), y = centre_y;
  const mesh::Surface top = without(r.surface, [&](const Vec3 &p) { return std::hypot(p.x() - x, p.y() - y) < 0.8; });
  const mesh::Surface side =
      without(r.surface, [&](const Vec3 &p) { return std::hypot(p.x() - x, p.y() - y + 3.2) < 1.2; });
  const mesh::Surface rim = without(r.surface, [&](const Vec3 &p) { return p.x() > x + 2.2; });
  for (const mesh::Surface *s : {&top, &side, &rim}) {
    Row cut = r;
    cut.surface = *s;
    features::Features f = r.features;
    for (features::Group &g : f.groups)
      for (features::Point &p : g.points) p.vertex = cut.vertex_at(p.position.x(), p.position.y());
    const Parts parts = parts_of(*s, all_teeth(*s, f));
    REQUIRE(parts.tooth.size() == 2);
    PartMesh m = parts.tooth[1];
    CHECK(std::ranges::any_of(m.flag, [](auto v) { return v & VertexFlag::on_rim; }));
    CHECK(m.loops == (s == &top ? 2 : 1));
    close(m, one, {});
    check_closed(m);
  }
}

TEST_CASE("what cannot be closed says so and stays as it was") {
  // A tube, and a spike through the middle of its end.
  const mesh::Surface tube = forms::tube(3, 4, 24, 6);
  PartMesh m;
  m.position = tube.position;
  m.triangle = tube.triangle;
  const Index n = static_cast<Index>(m.position.size());
  for (const Vec3 &p : {Vec3(-1, -1, -3), Vec3(1, -1, -3), Vec3(0, 1, -3), Vec3(0, 0, 8)}) m.position.push_back(p);
  for (const Triangle &t : {Triangle{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
    m.triangle.push_back({n + t[0], n + t[1], n + t[2]});
  m.flag.assign(m.position.size(), 0);
  m.source.assign(m.triangle.size(), 0);
  measure(m, one);
  CHECK(m.loops == 2);
  CHECK(m.components == 2);
  try {
    close(m, one, {});
    FAIL("closed");
  } catch (const Error &e) {
    CHECK(e.fault() == Fault::not_closed);
    CHECK(std::string(e.what()).find("without crossing") != std::string::npos);
  }
  CHECK(m.loops == 2);
  CHECK(m.position.size() == n + 4);
  m.position.resize(n);
  m.triangle.resize(tube.triangle.size());
  m.flag.resize(n);
  m.source.resize(m.triangle.size());
  close(m, one, {});
  check_closed(m);
  CHECK(m.volume == doctest::Approx(tube.area * 3 / 2).epsilon(0.02));
}

TEST_CASE("crossings are found, touching neighbours are none") {
  const Vec<Vec3> p = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, -1}, {0.5, 0.5, 1}, {3, 3, 0}, {2, 2, 0}};
  CHECK(crossings(p, Vec<Triangle>{{0, 1, 2}, {3, 4, 5}}, 1) == Vec<std::array<Index, 2>>{{0, 1}});
  CHECK(crossings(p, Vec<Triangle>{{0, 1, 2}, {3, 4, 5}}, 2).empty());
  CHECK(crossings(p, Vec<Triangle>{{0, 1, 2}, {1, 6, 2}}, 0).empty());
  CHECK(crossings(p, Vec<Triangle>{{0, 1, 2}, {1, 5, 4}}, 0).empty());
  CHECK(crossings(p, Vec<Triangle>{{0, 1, 2}, {0, 3, 4}}, 0).size() == 1);  // beside the corner they share
  const Vec<Vec3> folded = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, 0}};
  CHECK(crossings(folded, Vec<Triangle>{{0, 1, 2}, {1, 0, 3}}, 0).size() == 1);
}

TEST_CASE("which way a tooth looks") {
  Row r = row(4);
  const Session session = all_teeth(r.surface, r.features);
  const Vec3 up(0, 0, 1);
  Vec<Vec3> along;  // bent away, so that there is an inside of the arch
  for (double x = 0; x <= 2 * kMargin + kPitch * 4; x += 1)
    along.push_back({x, centre_y - 0.002 * std::pow(x - kMargin - 2 * kPitch, 2), kHeight});
  for (const Index g : session.teeth()) {
    const ToothFrame f = frame_of(r.surface, *session.tooth(g), up, along);
    CHECK(f.from_arch);
    CHECK(f.occlusal == up);
    CHECK(f.mesial.x() * (g < 2 ? 1 : -1) > 0.99);
    CHECK(f.buccal.y() > 0.99);
    CHECK(std::abs(f.mesial.dot(f.buccal)) + std::abs(f.mesial.dot(up)) < 1e-12);
    CHECK(f.width == doctest::Approx(2 * kHalfWidth).epsilon(0.12));
    CHECK(f.depth == doctest::Approx(2 * kHalfDepth).epsilon(0.12));
    CHECK(f.height == doctest::Approx(kHeight).epsilon(0.12));
    CHECK(f.centre.x() == doctest::Approx(centre_x(g)).epsilon(0.01));
    const ToothFrame alone = frame_of(r.surface, *session.tooth(g), up, {});
    CHECK(!alone.from_arch);
    CHECK(alone.mesial.norm() == doctest::Approx(1));
    CHECK(std::abs(alone.mesial.dot(alone.buccal)) + std::abs(alone.mesial.dot(up)) < 1e-12);
  }
}
