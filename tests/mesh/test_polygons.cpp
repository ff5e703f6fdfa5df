#include "mesh/triangulate.h"
#include "shapes.h"

using namespace shapes;

namespace {

RawMesh one_polygon(const std::vector<std::pair<double, double>> &outline, const Eigen::Matrix3d &pose) {
  RawMesh raw;
  for (const auto &[x, y] : outline) {
    raw.corner.push_back(static_cast<Index>(raw.position.size()));
    raw.position.push_back(pose * Vec3(x, y, 0));
  }
  raw.face_start = {0, static_cast<Index>(raw.corner.size())};
  return raw;
}

// The area says that the triangles neither leave the polygon nor overlap: none may look the other way.
void check_cut(const std::vector<std::pair<double, double>> &outline, double area) {
  const Eigen::Matrix3d tilted = Eigen::AngleAxisd(1.1, Vec3(1, 2, -0.5).normalized()).toRotationMatrix();
  for (const Eigen::Matrix3d &pose : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), tilted}) {
    const RawMesh raw = one_polygon(outline, pose);
    const Model m = model_of(raw);
    check_promises(m);
    CHECK(m.report.polygons == 1);
    CHECK(m.report.faces == outline.size() - 2);
    CHECK(m.report.boundary_loops == 1);
    CHECK(m.report.flipped_faces == 0);
    CHECK(m.report.area == doctest::Approx(area));
    for (const Index f : m.face_source) CHECK(f == 0);
    for (const Vec3 &n : m.surface.face_normal) CHECK(n.dot(pose.col(2)) == doctest::Approx(1));
  }
}

}  // namespace

TEST_CASE("convex polygons") {
  check_cut({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, 100);
  check_cut({{0, 0}, {10, 0}, {12, 5}, {5, 12}, {-1, 6}},
            10 * 5 / 2.0 + (10 * 5 - 12 * 0) / 2.0 + (12 * 12 - 5 * 5) / 2.0 + (5 * 6 + 1 * 12) / 2.0 - 25);
}

TEST_CASE("concave polygons") {
  check_cut({{0, 0}, {10, 0}, {10, 10}, {5, 2}}, 100 / 2.0 - 15);
  check_cut({{5, 2}, {0, 0}, {10, 0}, {10, 10}}, 100 / 2.0 - 15);
  check_cut({{0, 0}, {30, 0}, {30, 10}, {20, 10}, {20, 5}, {10, 5}, {10, 10}, {0, 10}}, 250);
  std::vector<std::pair<double, double>> star, comb = {{0, 0}, {400, 0}};
  for (int i = 0; i < 40; ++i) {
    const double r = i % 2 ? 4 : 10, a = 2 * M_PI * i / 40;
    star.emplace_back(r * std::cos(a), r * std::sin(a));
  }
  check_cut(star, 40 * 0.5 * 4 * 10 * std::sin(2 * M_PI / 40));
  for (int i = 100; i > 0; --i) comb.emplace_back(4 * i, 10), comb.emplace_back(4 * i - 2, 1);
  comb.emplace_back(0, 10);
  check_cut(comb, 400 * 10 - 9 * 400 / 2.0);
}

TEST_CASE("corners on a straight line make no triangle without area") {
  check_cut({{0, 0}, {5, 0}, {10, 0}, {10, 10}}, 50);
  check_cut({{0, 0}, {10, 0}, {10, 5}, {10, 10}, {5, 10}, {0, 10}, {0, 5}}, 100);
}

TEST_CASE("repeated corners are passed over, polygons without area dropped") {
  const Model m = model_of(polygons({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {20, 0, 0}},
                                    {{0, 0, 1, 2, 2, 3, 0}, {0, 1, 4, 1}, {0, 1}, {}, {2}}));
  check_promises(m);
  CHECK(m.report.input_faces == 5);
  CHECK(m.report.faces == 2);
  CHECK(m.report.degenerate_faces == 4);
  CHECK(m.label_source[1] != none);
  CHECK(m.label_source[3] == none);
}

TEST_CASE("a polygon that crosses itself gives some triangles and no trouble") {
  const Model m = model_of(
      polygons({{0, 0, 0}, {10, 0, 0}, {0, 9, 0}, {10, 10, 0}, {5, 15, 0}}, {{0, 1, 2, 3, 4}, {3, 1, 4, 0, 2}}));
  check_promises(m);
  CHECK(m.report.faces >= 3);
}

// Found by the fuzzer of OBJ files.
TEST_CASE("a polygon is one face, however many of its triangles were turned round") {
  const Model m = model_of(
      polygons({{3, -3, 0.6}, {6, -6, 0}, {0, -6, 0}, {3, -3, 957.3}, {6, 0, 3}, {3, 0, 3}}, {{0, 1, 2, 0, 3, 4, 5}}));
  check_promises(m);
  CHECK(m.report.faces > 2);
  CHECK(m.report.flipped_faces == 1);
}

TEST_CASE("mixed faces keep their sources; neighbours stay joined") {
  const Model m =
      model_of(polygons({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {20, 5, 1}}, {{1, 4, 2}, {0, 1, 2, 3}}));
  check_promises(m);
  CHECK(m.face_source == Vec<Index>{0, 1, 1});
  CHECK(m.label_source == Vec<Index>{0, 1});
  CHECK(m.report.components == 1);
}

TEST_CASE("huge convex polygons are fine, huge concave ones refused by name") {
  std::vector<std::pair<double, double>> round;
  const int n = 20000;
  for (int i = 0; i < n; ++i) round.emplace_back(100 * std::cos(2 * M_PI * i / n), 100 * std::sin(2 * M_PI * i / n));
  CHECK(model_of(one_polygon(round, Eigen::Matrix3d::Identity())).report.faces == n - 2);
  round[77] = {0, 0};
  check_fault(ts::Fault::mesh_too_large, "face 0 is concave",
              [&] { model_of(one_polygon(round, Eigen::Matrix3d::Identity())); });
  CHECK(most_concave_corners < n);
}
