// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>
#include <toothseg_arch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

struct Point {
  double x, y, z;
};
inline Point operator-(Point a, Point b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline double dot(Point a, Point b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Point cross(Point a, Point b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(Point a) {
  return std::sqrt(dot(a, a));
}

// An arch as a caller of the C interface sees it.
struct ArchMesh {
  std::vector<Point> points;
  std::vector<std::array<uint32_t, 3>> faces;
  std::vector<uint32_t> labels, fdi;
  std::vector<tsa_feature> features;

  Point normal(size_t f) const {  // of twice the area's length
    return cross(points[faces[f][1]] - points[faces[f][0]], points[faces[f][2]] - points[faces[f][0]]);
  }
  std::vector<double> areas() const {
    std::vector<double> a(fdi.size() + 1, 0);
    for (size_t f = 0; f < faces.size(); ++f) a[labels[f]] += 0.5 * norm(normal(f));
    return a;
  }
  double meanEdge() const {
    double sum = 0;
    for (const auto &t : faces)
      for (int i = 0; i < 3; ++i) sum += norm(points[t[i]] - points[t[(i + 1) % 3]]);
    return sum / (3.0 * static_cast<double>(faces.size()));
  }
  // The faces on both sides of each edge, by its vertices in ascending order; UINT32_MAX where there is none.
  // The first runs along the edge upwards, the second downwards.
  struct Sides {
    uint32_t up = UINT32_MAX, down = UINT32_MAX;
    int faces = 0;
  };
  std::map<std::pair<uint32_t, uint32_t>, Sides> edges() const {
    std::map<std::pair<uint32_t, uint32_t>, Sides> out;
    for (uint32_t f = 0; f < faces.size(); ++f)
      for (int i = 0; i < 3; ++i) {
        const uint32_t a = faces[f][i], b = faces[f][(i + 1) % 3];
        Sides &s = out[{std::min(a, b), std::max(a, b)}];
        (a < b ? s.up : s.down) = f;
        ++s.faces;
      }
    return out;
  }
};

inline tsa_options archOptions(uint32_t jaw, uint32_t triangles) {
  tsa_options o;
  REQUIRE(tsa_options_init(&o, sizeof o) == TSA_OK);
  o.jaw = jaw;
  o.triangles = triangles;
  return o;
}

inline ArchMesh make(const tsa_options &options) {
  tsa_arch *arch = nullptr;
  REQUIRE(tsa_create(&options, &arch) == TSA_OK);
  ArchMesh m;
  uint32_t n = 0;
  REQUIRE(tsa_get_positions(arch, nullptr, 0, &n) == TSA_OK);
  m.points.resize(n);
  REQUIRE(tsa_get_positions(arch, &m.points[0].x, n, &n) == TSA_OK);
  REQUIRE(tsa_get_triangles(arch, nullptr, 0, &n) == TSA_OK);
  m.faces.resize(n);
  m.labels.resize(n);
  REQUIRE(tsa_get_triangles(arch, m.faces[0].data(), n, &n) == TSA_OK);
  REQUIRE(tsa_get_labels(arch, m.labels.data(), n, &n) == TSA_OK);
  REQUIRE(tsa_get_teeth(arch, nullptr, 0, &n) == TSA_OK);
  m.fdi.resize(n);
  REQUIRE(tsa_get_teeth(arch, m.fdi.data(), n, &n) == TSA_OK);
  REQUIRE(tsa_get_features(arch, nullptr, 0, &n) == TSA_OK);
  m.features.resize(n);
  REQUIRE(tsa_get_features(arch, m.features.data(), n, &n) == TSA_OK);
  tsa_destroy(arch);
  return m;
}

// The arch of default options, made once however many cases look at it.
inline const ArchMesh &plainArch(uint32_t jaw, uint32_t triangles) {
  static std::map<std::pair<uint32_t, uint32_t>, std::unique_ptr<const ArchMesh>> made;
  auto &arch = made[{jaw, triangles}];
  if (!arch) arch = std::make_unique<const ArchMesh>(make(archOptions(jaw, triangles)));
  return *arch;
}
