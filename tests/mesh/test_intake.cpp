// Checks, units, welding, and what is dropped.
#include "shapes.h"

using namespace shapes;
using ts::Fault;

TEST_CASE("a clean mesh passes as it is") {
  const RawMesh raw = hills(12);
  const Model m = model_of(raw);
  check_promises(m);
  const IntakeReport &r = m.report;
  CHECK(r.input_vertices == 169);
  CHECK(r.input_faces == 288);
  CHECK(r.vertices == 169);
  CHECK(r.faces == 288);
  CHECK(r.components == 1);
  CHECK(r.boundary_loops == 1);
  CHECK(r.polygons + r.welded_vertices + r.unreferenced_vertices + r.degenerate_faces + r.duplicate_faces == 0);
  CHECK(r.flipped_faces + r.non_manifold_edges + r.non_manifold_vertices + r.unorientable_edges == 0);
  for (Index f = 0; f < 288; ++f) {
    CHECK(m.face_source[f] == f);
    CHECK(m.label_source[f] == f);
    CHECK(m.surface.triangle[f] == Triangle{raw.corner[3 * f], raw.corner[3 * f + 1], raw.corner[3 * f + 2]});
  }
  for (Index v = 0; v < 169; ++v) CHECK(m.vertex_map[v] == v);
}

TEST_CASE("the measures are right") {
  const Model m = model_of(cube({1, 2, 3}, 10));
  check_promises(m);
  CHECK(m.report.area == doctest::Approx(600));
  CHECK(m.report.diagonal == doctest::Approx(std::sqrt(300.0)));
  CHECK(m.report.mean_edge == doctest::Approx((12 * 10 + 6 * std::sqrt(200.0)) / 18));
  CHECK(m.report.boundary_loops == 0);
}

TEST_CASE("a mesh without faces is empty") {
  check_fault(Fault::mesh_empty, "no face", [] { model_of({}); });
  RawMesh points = hills(3);
  points.corner.clear();
  check_fault(Fault::mesh_empty, "no face", [&] { model_of(points); });
  check_fault(Fault::mesh_empty, "degenerate", [] {
    model_of(triangles({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}));
  });
}

TEST_CASE("the first coordinate that is not finite is named") {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    RawMesh raw = hills(10);
    raw.position[40].y() = bad;
    raw.position[77].z() = bad;
    check_fault(Fault::mesh_non_finite, "vertex 40", [&] { model_of(raw); });
  }
}

TEST_CASE("an index out of range is named with its face") {
  RawMesh raw = plane(12);
  raw.corner[3 * 7 + 1] = 169;
  check_fault(Fault::mesh_index_range, "face 7 names vertex 169", [&] { model_of(raw); });
  RawMesh mixed = polygons({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}, {{0, 1, 2, 3}, {0, 1, 2}, {0, 9, 2}});
  check_fault(Fault::mesh_index_range, "face 2 names vertex 9", [&] { model_of(mixed); });
}

TEST_CASE("coordinates beyond 1e9 mm are too large, in any unit") {
  RawMesh raw = plane(2);
  raw.position[3].x() = 1.1e6;
  CHECK_NOTHROW(model_of(raw));
  check_fault(Fault::mesh_too_large, "vertex 3", [&] { model_of(raw, {Unit::m, 0}); });
  raw.position[3].x() = -1.1e9;
  check_fault(Fault::mesh_too_large, "vertex 3", [&] { model_of(raw); });
}

TEST_CASE("units are converted") {
  for (const auto &[unit, scale] :
       {std::pair(Unit::mm, 1.0), {Unit::cm, 10.0}, {Unit::m, 1000.0}, {Unit::inch, 25.4}}) {
    const Model m = model_of(cube({0, 0, 0}, 2), {unit, 0});
    CHECK(m.report.diagonal == doctest::Approx(scale * std::sqrt(12.0)));
  }
}

TEST_CASE("a size that no scan has is refused, with the units that would do") {
  const auto checked = [](double side) { model_of(cube({5, 5, 5}, side / std::sqrt(3.0)), {Unit::checked_mm, 0}); };
  CHECK_NOTHROW(checked(9.01));
  CHECK_NOTHROW(checked(399.9));
  check_fault(Fault::mesh_units, "diagonal of 0.085", [&] { checked(0.085); });
  check_fault(Fault::mesh_units, "m (85 mm)", [&] { checked(0.085); });
  check_fault(Fault::mesh_units, "cm (85 mm) or inch (215.9 mm)", [&] { checked(8.5); });
  check_fault(Fault::mesh_units, "no unit", [&] { checked(85000); });
}

TEST_CASE("vertices that no face uses do not count for the size") {
  RawMesh raw = cube({0, 0, 0}, 30);
  raw.position.push_back({5000, 0, 0});
  const Model m = model_of(raw, {Unit::checked_mm, 0});
  CHECK(m.report.diagonal == doctest::Approx(30 * std::sqrt(3.0)));
  CHECK(m.report.unreferenced_vertices == 1);
  CHECK(m.vertex_map[8] == none);
}

TEST_CASE("a soup welds to the mesh it was made of") {
  const RawMesh raw = hills(20);
  const Model whole = model_of(raw), welded = model_of(soup(raw));
  check_promises(welded);
  CHECK(welded.report.welded_vertices == 3 * 800 - 441);
  CHECK(welded.report.vertices == whole.report.vertices);
  CHECK(welded.report.boundary_loops == 1);
  CHECK(geometry(welded.surface) == geometry(whole.surface));
}

TEST_CASE("zero and minus zero are one coordinate") {
  RawMesh raw = triangles({{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {-0.0, 0, -0.0}, {10, -0.0, 0}, {0, -10, 0}},
                          {{0, 1, 2}, {4, 3, 5}});
  const Model m = model_of(raw);
  CHECK(m.report.welded_vertices == 2);
  CHECK(m.report.components == 1);
}

TEST_CASE("with a tolerance close vertices become one, others do not") {
  RawMesh raw = soup(hills(15));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-0.004, 0.004);
  for (Vec3 &p : raw.position) p += Vec3(shift(random), shift(random), shift(random));
  CHECK(model_of(raw).report.vertices > 1000);
  const Model m = model_of(raw, {Unit::mm, 0.02});
  check_promises(m);
  CHECK(m.report.vertices == 256);
  CHECK(m.report.faces == 450);
  for (std::size_t v = 0; v < raw.position.size(); ++v)
    CHECK((m.surface.position[m.vertex_map[v]] - raw.position[v]).norm() <= 0.02);
}

TEST_CASE("a chain of close vertices does not collapse") {
  RawMesh raw;  // a strip whose steps are shorter than the tolerance
  for (Index i = 0; i <= 100; ++i) {
    raw.position.push_back({0.1 * i, 0, 0});
    raw.position.push_back({0.1 * i, 10, 0});
    if (i > 0)
      for (const Index v : {2 * i - 2, 2 * i, 2 * i + 1, 2 * i - 2, 2 * i + 1, 2 * i - 1}) raw.corner.push_back(v);
  }
  const Model m = model_of(raw, {Unit::mm, 0.25});
  check_promises(m);
  CHECK(m.report.area == doctest::Approx(100).epsilon(0.03));
  CHECK(m.report.vertices < 2 * 51);
  const auto &p = m.surface.position;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) CHECK((p[i] - p[j]).norm() >= 0.25);
}

TEST_CASE("tolerances that are no lengths are refused, odd ones work") {
  check_fault(Fault::invalid_argument, "weld_tolerance", [] { model_of(plane(3), {Unit::mm, -1}); });
  check_fault(Fault::invalid_argument, "weld_tolerance", [] { model_of(plane(3), {Unit::mm, std::nan("")}); });
  CHECK(model_of(plane(3), {Unit::mm, 1e-300}).report.vertices == 16);
  CHECK(model_of(plane(3), {Unit::mm, 1e-30}).report.vertices == 16);
  check_fault(Fault::mesh_empty, "degenerate", [] { model_of(plane(3), {Unit::mm, 1e6}); });
}

TEST_CASE("degenerate faces go and take the label of what they touch") {
  RawMesh raw = plane(4);  // faces 0 .. 31
  for (const Index v : {0u, 0u, 6u, 6u, 6u, 6u, 10u, 11u, 12u}) raw.corner.push_back(v);
  raw.position.push_back({100, 100, 100});
  for (int i = 0; i < 3; ++i) raw.corner.push_back(25);
  const Model m = model_of(raw);
  check_promises(m);
  CHECK(m.report.degenerate_faces == 4);
  CHECK(m.report.unreferenced_vertices == 1);
  CHECK(m.report.faces == 32);
  for (const auto &[face, corners] : {std::pair(32u, std::set<Index>{0, 6}), {33u, {6}}, {34u, {10, 11, 12}}}) {
    REQUIRE(m.label_source[face] < 32);
    bool touches = false;
    for (const Index v : m.surface.triangle[m.label_source[face]]) touches |= corners.count(v) > 0;
    CHECK(touches);
  }
  CHECK(m.label_source[35] == none);
}

TEST_CASE("of the faces that a degenerate one touches the nearest gives the label") {
  RawMesh raw =
      triangles({{0, 0, 0}, {100, 1, 0}, {100, 0, 0}, {0, 1, 0}, {-0.5, 0.5, 0}}, {{0, 1, 2}, {0, 3, 4}, {0, 3, 3}});
  CHECK(model_of(raw).label_source[2] == 1);
}

TEST_CASE("duplicate faces go, whichever way they are wound, and take the label of the first") {
  RawMesh raw = plane(4);
  for (const Index v : {raw.corner[15], raw.corner[16], raw.corner[17]}) raw.corner.push_back(v);
  for (const Index v : {raw.corner[23], raw.corner[22], raw.corner[21]}) raw.corner.push_back(v);
  const Model m = model_of(raw);
  check_promises(m);
  CHECK(m.report.duplicate_faces == 2);
  CHECK(m.report.faces == 32);
  CHECK(m.report.non_manifold_edges == 0);
  CHECK(m.label_source[32] == 5);
  CHECK(m.label_source[33] == 7);
}

TEST_CASE("arrays of floats and doubles, packed or with a stride") {
  const RawMesh raw = hills(5);
  std::vector<float> floats;
  std::vector<double> wide;
  for (const Vec3 &p : raw.position) {
    for (int k = 0; k < 3; ++k) floats.push_back(static_cast<float>(p[k])), wide.push_back(p[k]);
    wide.push_back(-1);
  }
  const RawMesh f = from_arrays(floats.data(), Scalar::float32, 36, 0, raw.corner.data(), 50);
  const RawMesh d = from_arrays(wide.data(), Scalar::float64, 36, 32, raw.corner.data(), 50);
  CHECK(d.position == raw.position);
  CHECK(d.corner == raw.corner);
  CHECK(f.position[7] == raw.position[7].cast<float>().cast<double>());
  const RawMesh s = from_arrays(floats.data(), Scalar::float32, 36, 0, nullptr, 0);
  CHECK(s.faces() == 12);
  CHECK(s.face(11)[2] == 35);
  check_fault(Fault::invalid_argument, "soup", [&] { from_arrays(floats.data(), Scalar::float32, 35, 0, nullptr, 0); });
  check_fault(Fault::invalid_argument, "soup",
              [&] { from_arrays(floats.data(), Scalar::float32, 36, 0, nullptr, 11); });
  check_fault(Fault::invalid_argument, "stride", [&] { from_arrays(wide.data(), Scalar::float64, 3, 12, nullptr, 1); });
  check_fault(Fault::null, "NULL", [&] { from_arrays(nullptr, Scalar::float64, 3, 0, nullptr, 1); });
}

TEST_CASE("any number of threads gives the same model") {
  RawMesh raw = soup(hills(150));
  const Model a = make_model(raw, {Unit::mm, 0}, ts::Executor(1), {});
  const Model b = make_model(raw, {Unit::mm, 0}, ts::Executor(4), {});
  CHECK(a.surface.position == b.surface.position);
  CHECK(a.surface.triangle == b.surface.triangle);
  CHECK(a.vertex_map == b.vertex_map);
}

TEST_CASE("intake can be cancelled and never goes back") {
  struct Stop : ts::Monitor {
    bool proceed(double fraction, const char *) noexcept override {
      rising = rising && fraction >= last;
      last = fraction;
      return ++calls < stop_at;
    }
    int calls = 0, stop_at = 1000000;
    double last = 0;
    bool rising = true;
  };
  Stop all;
  make_model(hills(30), {Unit::mm, 0}, ts::Executor(1), ts::Progress(&all));
  CHECK(all.rising);
  CHECK(all.last == 1);
  for (int at = 1; at <= all.calls; ++at) {
    Stop stop;
    stop.stop_at = at;
    check_fault(Fault::cancelled, "intake", [&] {
      make_model(hills(30), {Unit::mm, 0}, ts::Executor(1), ts::Progress(&stop));
    });
  }
}
