#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "features/analysis.h"
#include "features/doubts.h"
#include "toothseg_arch.h"

using namespace ts;

namespace {

// Five times as slow with AddressSanitizer: there one of each two arches, of both jaws.
#ifdef TS_SANITIZED
constexpr bool kHalf = true;
#else
constexpr bool kHalf = false;
#endif

struct Arch {
  mesh::Surface surface;
  Vec<std::uint32_t> label;
  std::uint32_t teeth = 0;
};

Arch make(std::uint32_t jaw, double crowding, std::uint64_t seed, const std::vector<std::uint32_t> &missing,
          std::uint32_t base, std::uint32_t triangles = 20000, double noise = 0) {
  tsa_options o{};
  REQUIRE(tsa_options_init(&o, sizeof o) == TSA_OK);
  o.jaw = jaw;
  o.crowding = crowding;
  o.seed = seed;
  o.triangles = triangles;
  o.noise = noise;
  o.base = base;
  o.missing = missing.data();
  o.missing_count = static_cast<std::uint32_t>(missing.size());
  tsa_arch *made = nullptr;
  REQUIRE(tsa_create(&o, &made) == TSA_OK);
  const std::unique_ptr<tsa_arch, decltype(&tsa_destroy)> keep(made, tsa_destroy);
  std::uint32_t vertices = 0, faces = 0;
  Arch arch;
  REQUIRE(tsa_get_positions(made, nullptr, 0, &vertices) == TSA_OK);
  REQUIRE(tsa_get_triangles(made, nullptr, 0, &faces) == TSA_OK);
  REQUIRE(tsa_get_teeth(made, nullptr, 0, &arch.teeth) == TSA_OK);
  Vec<mesh::Vec3> position(vertices);
  Vec<mesh::Triangle> triangle(faces);
  arch.label.resize(faces);
  REQUIRE(tsa_get_positions(made, position.data()->data(), vertices, &vertices) == TSA_OK);
  REQUIRE(tsa_get_triangles(made, triangle.data()->data(), faces, &faces) == TSA_OK);
  REQUIRE(tsa_get_labels(made, arch.label.data(), faces, &faces) == TSA_OK);
  arch.surface = mesh::make_surface(std::move(position), std::move(triangle));
  return arch;
}

// Each tooth has exactly one group, each group lies on one tooth, in order along the arch.
void check(const Arch &arch) {
  const features::Features f = features::detect(arch.surface, {}, Executor(1), {});
  CHECK(f.occlusal.z() > 0.9);
  CHECK(!f.inside_out);
  REQUIRE(f.groups.size() == arch.teeth);
  std::vector<std::uint32_t> order;
  for (const features::Group &g : f.groups) {
    std::map<std::uint32_t, int> votes;
    for (const features::Point &p : g.points)
      for (const mesh::Index face : arch.surface.vertex_faces[p.vertex]) ++votes[arch.label[face]];
    std::uint32_t best = 0;
    int most = 0, all = 0;
    for (const auto &[label, count] : votes) {
      all += count;
      if (count > most) most = count, best = label;
    }
    CHECK(best > 0);
    CHECK(most > 0.8 * all);
    order.push_back(best);
  }
  if (order.front() > order.back()) std::reverse(order.begin(), order.end());
  for (std::size_t k = 0; k < order.size(); ++k) CHECK(order[k] == k + 1);
}

}  // namespace

TEST_CASE("synthetic arches, straight and mildly crowded" * doctest::test_suite("many arches")) {
  for (const std::uint32_t jaw : {TSA_JAW_UPPER, TSA_JAW_LOWER})
    for (const double crowding : {0.0, 0.35}) {
      CAPTURE(jaw);
      CAPTURE(crowding);
      if (kHalf && (jaw == TSA_JAW_UPPER) != (crowding > 0)) continue;
      check(make(jaw, crowding, 2, {}, 0));
    }
}

TEST_CASE("severely crowded: one tooth before the other, which no line across the arch parts" *
          doctest::test_suite("many arches")) {
  for (const std::uint32_t jaw : {TSA_JAW_LOWER, TSA_JAW_UPPER})
    for (const std::uint64_t seed : {4, 5}) {
      CAPTURE(jaw);
      CAPTURE(seed);
      if (kHalf && (jaw == TSA_JAW_UPPER) != (seed == 4)) continue;
      check(make(jaw, 1, seed, {}, 0));
    }
}

TEST_CASE("lower incisors in pairs as wide as upper central ones, one before the other" *
          doctest::test_suite("many arches")) {
  check(make(TSA_JAW_LOWER, 0.47454577173215756, 325, {37, 45, 36}, 0, 13452, 0.25589691502637352));
}

TEST_CASE("noise does not part upper central incisors" * doctest::test_suite("many arches")) {
  check(make(TSA_JAW_UPPER, 0.165, 21, {}, 0, 15622, 0.32));
  check(make(TSA_JAW_UPPER, 0.397, 88, {}, 0, 16961, 0.32));
}

TEST_CASE("synthetic arches with missing teeth" * doctest::test_suite("many arches")) {
  check(make(TSA_JAW_UPPER, 0.2, 4, {12, 16, 25}, 0));
  check(make(TSA_JAW_LOWER, 0.2, 5, {31, 46}, 0));
}

TEST_CASE("a synthetic arch on a plaster base" * doctest::test_suite("many arches")) {
  check(make(TSA_JAW_UPPER, 0, 3, {}, 1));
}

TEST_CASE("the features of a turned or mirrored arch are the turned or mirrored features" *
          doctest::test_suite("many arches")) {
  const Arch arch = make(TSA_JAW_UPPER, 0.2, 4, {16}, 0);
  const features::Features before = features::detect(arch.surface, {}, Executor(1), {});
  Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(2.1, mesh::Vec3(1, -2, 0.5).normalized()) * Eigen::AngleAxisd(0.7, mesh::Vec3::UnitZ()))
          .toRotationMatrix();
  Eigen::Matrix3d mirror = turn;
  mirror.col(0) *= -1;
  const mesh::Vec3 shift(-140, 60, 25);
  for (const Eigen::Matrix3d &m : {turn, mirror}) {
    Vec<mesh::Vec3> position;
    for (const mesh::Vec3 &p : arch.surface.position) position.push_back(m * p + shift);
    Vec<mesh::Triangle> triangle = arch.surface.triangle;
    if (m.determinant() < 0)
      for (auto &corners : triangle) std::swap(corners[1], corners[2]);
    const features::Features after =
        features::detect(mesh::make_surface(std::move(position), std::move(triangle)), {}, Executor(1), {});
    CHECK((m * before.occlusal - after.occlusal).norm() < 1e-9);
    REQUIRE(after.groups.size() == before.groups.size());
    for (std::size_t g = 0; g < after.groups.size(); ++g) {
      REQUIRE(after.groups[g].points.size() == before.groups[g].points.size());
      for (std::size_t i = 0; i < after.groups[g].points.size(); ++i)
        CHECK(after.groups[g].points[i].vertex == before.groups[g].points[i].vertex);
    }
  }
}

// Both in one file, the second one moved.
mesh::Surface both(const Arch &arch, const Arch &other, const Eigen::Matrix3d &turn, const mesh::Vec3 &shift) {
  Vec<mesh::Vec3> position = arch.surface.position;
  Vec<mesh::Triangle> triangle = arch.surface.triangle;
  const auto n = static_cast<mesh::Index>(position.size());
  for (const mesh::Vec3 &p : other.surface.position) position.push_back(turn * p + shift);
  for (mesh::Triangle t : other.surface.triangle) {
    for (mesh::Index &v : t) v += n;
    triangle.push_back(t);
  }
  return mesh::make_surface(std::move(position), std::move(triangle));
}

TEST_CASE("two arches in one file do not pass for one" * doctest::test_suite("many arches")) {
  using features::Doubt;
  const Arch made[] = {make(TSA_JAW_UPPER, 0.2, 6, {}, 0), make(TSA_JAW_LOWER, 0.2, 6, {}, 0)};
  for (const std::uint32_t jaw : {TSA_JAW_UPPER, TSA_JAW_LOWER}) {
    CAPTURE(jaw);
    if (kHalf && jaw == TSA_JAW_LOWER) continue;
    const Arch &arch = made[jaw == TSA_JAW_LOWER];
    mesh::Vec3 low = arch.surface.position[0], high = low;
    for (const mesh::Vec3 &p : arch.surface.position) low = low.cwiseMin(p), high = high.cwiseMax(p);
    const mesh::Vec3 size = high - low;
    const Eigen::Matrix3d same = Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d round = Eigen::Vector3d(-1, -1, 1).asDiagonal(),
                          over = Eigen::Vector3d(-1, 1, -1).asDiagonal();
    const auto looks = [](const mesh::Surface &s) { return features::analyse(s, {}, Executor(1), {}).looks; };

    const features::Looks one = looks(arch.surface);
    CHECK(one.warnings == 0);
    CHECK(features::detect(arch.surface, {}, Executor(1), {}).looks.coverage == one.coverage);
    CHECK(one.opposed < 0.1);
    CHECK(one.coverage > 0.95);
    CHECK(one.length > 90);
    CHECK(one.length < 160);

    const features::Looks beside = looks(both(arch, arch, same, {size.x() + 5, 0, 0}));
    CHECK(beside.warnings == Doubt::several_arches);
    CHECK(beside.coverage < 0.85);

    // With the open sides facing each other, whichever that is: the curve runs round both.
    unsigned said = 0;
    for (const double y : {2 * low.y() - 5, 2 * high.y() + 5})
      said |= looks(both(arch, arch, round, {low.x() + high.x(), y, 0})).warnings;
    CHECK(said == Doubt::several_arches);

    // The very same arch on itself looks nowhere: no_teeth. Two jaws differ. (They may come to no_teeth later on.)
    const Arch &other = made[jaw == TSA_JAW_UPPER];
    double top = other.surface.position[0].z();
    for (const mesh::Vec3 &p : other.surface.position) top = std::max(top, p.z());
    const features::Looks biting = looks(both(arch, other, over, {low.x() + high.x(), 0, high.z() + top + 0.5}));
    CHECK((biting.warnings & Doubt::opposed) != 0);
    CHECK(biting.opposed > 0.6);
  }
}
