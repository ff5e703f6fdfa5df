// SPDX-License-Identifier: Apache-2.0
#include "arch_mesh.h"

namespace {

// Manifold, wound alike on both sides of every edge, in one piece, without handles, with as many rims as said.
void checkShell(const ArchMesh &m, int rims) {
  const auto edges = m.edges();
  std::vector<std::vector<uint32_t>> rim(m.points.size());
  std::vector<uint32_t> parent(m.points.size());
  for (uint32_t v = 0; v < parent.size(); ++v) parent[v] = v;
  const auto root = [&](uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  int wrong = 0;
  for (const auto &[e, s] : edges) {
    const bool open = s.faces == 1, joined = s.faces == 2 && s.up != UINT32_MAX && s.down != UINT32_MAX;
    if (!open && !joined) ++wrong;
    if (open) {
      rim[e.first].push_back(e.second);
      rim[e.second].push_back(e.first);
    }
    parent[root(e.first)] = root(e.second);
  }
  CHECK(wrong == 0);
  int pieces = 0, loops = 0, forks = 0;
  for (uint32_t v = 0; v < parent.size(); ++v) pieces += root(v) == v;
  CHECK(pieces == 1);
  std::vector<char> seen(m.points.size(), 0);
  for (uint32_t v = 0; v < rim.size(); ++v) {
    if (!rim[v].empty() && rim[v].size() != 2) ++forks;
    if (rim[v].empty() || seen[v]) continue;
    ++loops;
    std::vector<uint32_t> stack{v};
    seen[v] = 1;
    while (!stack.empty()) {
      const uint32_t u = stack.back();
      stack.pop_back();
      for (const uint32_t w : rim[u])
        if (!seen[w]) seen[w] = 1, stack.push_back(w);
    }
  }
  CHECK(forks == 0);
  CHECK(loops == rims);
  const long euler =
      static_cast<long>(m.points.size()) - static_cast<long>(edges.size()) + static_cast<long>(m.faces.size());
  CHECK(euler == 2 - rims);
}

// 6 times the volume under the mesh; positive if a closed one is wound outwards.
double volume6(const ArchMesh &m) {
  double v = 0;
  for (const auto &t : m.faces) v += dot(m.points[t[0]], cross(m.points[t[1]], m.points[t[2]]));
  return v;
}

}  // namespace

TEST_CASE("an arch is an open shell with one rim") {
  for (const uint32_t jaw : {TSA_JAW_UPPER, TSA_JAW_LOWER}) {
    CAPTURE(jaw);
    const ArchMesh &m = plainArch(jaw, 20000);
    checkShell(m, 1);
    // Every crown lies outside-out around its own middle.
    for (uint32_t k = 1; k <= m.fdi.size(); ++k) {
      Point c{0, 0, 0};
      double n = 0, flux = 0;
      for (size_t f = 0; f < m.faces.size(); ++f)
        if (m.labels[f] == k)
          for (const uint32_t v : m.faces[f]) c = c - (Point{0, 0, 0} - m.points[v]), ++n;
      c = {c.x / n, c.y / n, c.z / n};
      for (size_t f = 0; f < m.faces.size(); ++f)
        if (m.labels[f] == k) flux += dot(m.normal(f), m.points[m.faces[f][0]] - c);
      CHECK(flux > 0);
    }
  }
}

TEST_CASE("a base closes it, flat and outwards") {
  tsa_options o = archOptions(TSA_JAW_LOWER, 20000);
  o.base = 1;
  const ArchMesh m = make(o);
  checkShell(m, 0);
  CHECK(volume6(m) / 6 > 8000);  // mm^3
  double bottom = 1e9, flat = 0;
  for (const Point &p : m.points) bottom = std::min(bottom, p.z);
  for (size_t f = 0; f < m.faces.size(); ++f) {
    const Point n = m.normal(f);
    if (m.points[m.faces[f][0]].z < bottom + 0.05 && n.z < -0.99 * norm(n)) flat += 0.5 * norm(n);
  }
  CHECK(flat > 800);  // mm^2
}

TEST_CASE("the number of triangles is near the one asked for") {
  for (const uint32_t wanted : {5000u, 10000u, 40000u}) {
    const ArchMesh &m = plainArch(TSA_JAW_UPPER, wanted);
    CHECK(std::abs(static_cast<double>(m.faces.size()) / wanted - 1) < 0.05);
  }
}

TEST_CASE("triangles are those of a scan: irregular, few slivers") {
  const ArchMesh &m = plainArch(TSA_JAW_UPPER, 40000);
  int slivers = 0;
  for (size_t f = 0; f < m.faces.size(); ++f) {
    double squares = 0;
    for (int i = 0; i < 3; ++i) {
      const Point d = m.points[m.faces[f][i]] - m.points[m.faces[f][(i + 1) % 3]];
      squares += dot(d, d);
    }
    // 1 for an equilateral triangle, 0 for a needle.
    slivers += 2 * std::sqrt(3.0) * norm(m.normal(f)) / squares < 0.3;
  }
  CHECK(slivers < 0.002 * static_cast<double>(m.faces.size()));
  std::vector<int> valence(m.points.size(), 0);
  for (const auto &t : m.faces)
    for (const uint32_t v : t) ++valence[v];
  const auto six = std::count(valence.begin(), valence.end(), 6);
  CHECK(static_cast<double>(six) < 0.6 * static_cast<double>(valence.size()));
}

#ifdef TS_SANITIZED
constexpr uint64_t kSeeds = 1;  // five times as slow
#else
constexpr uint64_t kSeeds = 2;
#endif

TEST_CASE("every crowding is a valid arch with all its teeth" * doctest::test_suite("many arches")) {
  for (const uint32_t jaw : {TSA_JAW_UPPER, TSA_JAW_LOWER})
    for (const double crowding : {0.35, 0.65, 1.0})
      for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
        CAPTURE(jaw);
        CAPTURE(crowding);
        CAPTURE(seed);
        tsa_options o = archOptions(jaw, 10000);
        o.crowding = crowding;
        o.seed = seed;
        const ArchMesh m = make(o);
        checkShell(m, 1);
        CHECK(m.fdi.size() == 14);
        const auto area = m.areas();
        CHECK(*std::min_element(area.begin() + 1, area.end()) > 20);
      }
}

TEST_CASE("noise has the strength asked for") {
  tsa_options o = archOptions(TSA_JAW_LOWER, 10000);
  const ArchMesh clean = make(o);
  o.noise = 0.2;
  const ArchMesh along = make(o);
  o.noise_kind = TSA_NOISE_ISOTROPIC;
  const ArchMesh around = make(o);
  REQUIRE(along.faces == clean.faces);
  REQUIRE(around.faces == clean.faces);
  REQUIRE(along.labels == clean.labels);
  double a = 0, b = 0;
  for (size_t v = 0; v < clean.points.size(); ++v) {
    const Point d = along.points[v] - clean.points[v], e = around.points[v] - clean.points[v];
    a += dot(d, d);
    b += dot(e, e);
  }
  const double n = static_cast<double>(clean.points.size()), edge = clean.meanEdge();
  CHECK(std::sqrt(a / n) == doctest::Approx(0.2 * edge).epsilon(0.03));
  CHECK(std::sqrt(b / (3 * n)) == doctest::Approx(0.2 * edge).epsilon(0.03));
}

TEST_CASE("the same options give the same bytes, another seed another arch") {
  tsa_options o = archOptions(TSA_JAW_UPPER, 10000);
  o.crowding = 0.5;
  o.noise = 0.1;
  const ArchMesh a = make(o), b = make(o);
  REQUIRE(a.points.size() == b.points.size());
  bool same = a.faces == b.faces && a.labels == b.labels;
  for (size_t v = 0; v < a.points.size(); ++v)
    same = same && a.points[v].x == b.points[v].x && a.points[v].y == b.points[v].y && a.points[v].z == b.points[v].z;
  CHECK(same);
  o.seed = 2;
  CHECK(make(o).faces != a.faces);
}
