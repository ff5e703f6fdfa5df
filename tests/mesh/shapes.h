// Meshes for the tests, and what must hold of any surface that intake lets through.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <random>
#include <set>
#include <string>

#include "mesh/intake.h"

namespace shapes {

using namespace ts::mesh;
using ts::Vec;

inline RawMesh triangles(std::initializer_list<Vec3> position, std::initializer_list<Triangle> faces) {
  RawMesh raw;
  raw.position.assign(position);
  for (const Triangle &t : faces) raw.corner.insert(raw.corner.end(), t.begin(), t.end());
  return raw;
}

inline RawMesh polygons(std::initializer_list<Vec3> position,
                        std::initializer_list<std::initializer_list<Index>> faces) {
  RawMesh raw;
  raw.position.assign(position);
  raw.face_start.push_back(0);
  for (const auto &f : faces) {
    raw.corner.insert(raw.corner.end(), f);
    raw.face_start.push_back(static_cast<Index>(raw.corner.size()));
  }
  return raw;
}

// n x n squares of side 1 mm in two triangles each, on z = height(x, y); seen from above.
template <class Height>
RawMesh terrain(Index n, const Height &height) {
  RawMesh raw;
  for (Index j = 0; j <= n; ++j)
    for (Index i = 0; i <= n; ++i) raw.position.push_back({double(i), double(j), height(double(i), double(j))});
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      for (const Index v : {a, b, d, a, d, c}) raw.corner.push_back(v);
    }
  return raw;
}

inline RawMesh plane(Index n) {
  return terrain(n, [](double, double) { return 0.0; });
}

inline RawMesh hills(Index n) {
  return terrain(n, [](double x, double y) { return std::sin(x * 0.7) * 2 + std::cos(y * 0.9 + x * 0.1); });
}

// A cube of 12 triangles, outwards, from `low` with side `size`.
inline RawMesh cube(const Vec3 &low, double size) {
  RawMesh raw;
  for (int i = 0; i < 8; ++i) raw.position.push_back(low + size * Vec3(i & 1, i >> 1 & 1, i >> 2 & 1));
  raw.corner = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  return raw;
}

inline RawMesh both(const RawMesh &a, const RawMesh &b) {
  RawMesh raw = a;
  const Index n = static_cast<Index>(a.position.size());
  raw.position.insert(raw.position.end(), b.position.begin(), b.position.end());
  for (const Index v : b.corner) raw.corner.push_back(v + n);
  return raw;
}

inline RawMesh soup(const RawMesh &raw) {
  RawMesh s;
  for (const Index v : raw.corner) {
    s.corner.push_back(static_cast<Index>(s.position.size()));
    s.position.push_back(raw.position[v]);
  }
  return s;
}

// The same triangles with vertices, faces and first corners shuffled.
inline RawMesh shuffled(const RawMesh &raw, unsigned seed) {
  std::mt19937 random(seed);
  Vec<Index> place(raw.position.size());
  for (Index i = 0; i < place.size(); ++i) place[i] = i;
  std::shuffle(place.begin(), place.end(), random);
  Vec<Triangle> faces;
  for (std::size_t f = 0; f < raw.faces(); ++f) {
    Triangle t = {place[raw.corner[3 * f]], place[raw.corner[3 * f + 1]], place[raw.corner[3 * f + 2]]};
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    faces.push_back(t);
  }
  std::shuffle(faces.begin(), faces.end(), random);
  RawMesh s;
  s.position.resize(raw.position.size());
  for (std::size_t i = 0; i < place.size(); ++i) s.position[place[i]] = raw.position[i];
  for (const Triangle &t : faces) s.corner.insert(s.corner.end(), t.begin(), t.end());
  return s;
}

inline void turn_round(RawMesh &raw, std::size_t face) {
  std::swap(raw.corner[3 * face], raw.corner[3 * face + 1]);
}

inline Model model_of(RawMesh raw, IntakeOptions options = {Unit::mm, 0}) {
  return make_model(std::move(raw), options, ts::Executor(1), {});
}

// Throws away the numbering: faces as sorted lists of corner positions, each from its smallest corner on.
inline std::multiset<std::array<std::array<double, 3>, 3>> geometry(const Surface &s) {
  std::multiset<std::array<std::array<double, 3>, 3>> all;
  for (const Triangle &t : s.triangle) {
    std::array<std::array<double, 3>, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = {s.position[t[k]].x(), s.position[t[k]].y(), s.position[t[k]].z()};
    std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
    all.insert(p);
  }
  return all;
}

// What surface.h promises, found the slow way.
inline void check_promises(const Model &m) {
  const Surface &s = m.surface;
  std::map<Edge, std::vector<bool>> ways;
  std::set<std::set<Index>> corners;
  std::vector<std::vector<Edge>> spokes(s.vertices());
  for (const Triangle &t : s.triangle) {
    REQUIRE(std::max({t[0], t[1], t[2]}) < s.vertices());
    CHECK(corners.insert({t[0], t[1], t[2]}).second);
    CHECK((s.position[t[1]] - s.position[t[0]]).cross(s.position[t[2]] - s.position[t[0]]).norm() > 0);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
      ways[{std::min(a, b), std::max(a, b)}].push_back(a < b);
      spokes[a].push_back({b, c});
    }
  }
  for (const auto &[ends, up] : ways) {
    CHECK(up.size() <= 2);
    if (up.size() == 2) CHECK(up[0] != up[1]);
  }
  for (const auto &around : spokes) {  // one fan: the spokes form one chain or one ring
    REQUIRE(!around.empty());
    std::map<Index, Index> next;
    std::set<Index> reached;
    for (const Edge &e : around) {
      CHECK(next.emplace(e[0], e[1]).second);
      reached.insert(e[1]);
    }
    Index at = around[0][0];
    for (const Edge &e : around)
      if (!reached.count(e[0])) at = e[0];
    std::size_t steps = 0;
    for (; steps < around.size() && next.count(at); ++steps) at = next[at];
    CHECK(steps == around.size());
  }
  CHECK(m.report.vertices == s.vertices());
  CHECK(m.report.faces == s.faces());
  CHECK(m.face_source.size() == s.faces());
  CHECK(m.label_source.size() == m.report.input_faces);
  CHECK(m.vertex_map.size() == m.report.input_vertices);
  for (const Index f : m.face_source) CHECK(f < m.report.input_faces);
  for (const Index v : m.vertex_map) CHECK((v == none || v < s.vertices()));
  for (const Index f : m.label_source) CHECK((f == none || f < s.faces()));
  for (Index f = 0; f < s.faces(); ++f) CHECK(m.label_source[m.face_source[f]] <= f);
}

template <class Call>
void check_fault(ts::Fault fault, const std::string &part_of_message, const Call &call) {
  try {
    call();
    FAIL_CHECK("no error; expected: " << part_of_message);
  } catch (const ts::Error &e) {
    CHECK_MESSAGE(e.fault() == fault, std::string(e.what()));
    CHECK_MESSAGE(std::string(e.what()).find(part_of_message) != std::string::npos, std::string(e.what()));
  }
}

}  // namespace shapes
