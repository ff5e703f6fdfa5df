// Surfaces whose curvatures, distances and harmonic functions are known.
#pragma once

#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "mesh/surface.h"

namespace forms {

using namespace ts::mesh;
using std::numbers::pi;
using ts::Vec;

// at(i / nu, j / nv) for a grid of nu x nv squares; wrapped rows close up.
template <class At>
Surface grid(Index nu, Index nv, bool wrap_u, bool wrap_v, const At &at) {
  const Index columns = wrap_u ? nu : nu + 1, rows = wrap_v ? nv : nv + 1;
  Vec<Vec3> position;
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) position.push_back(at(double(i) / nu, double(j) / nv));
  Vec<Triangle> triangle;
  for (Index j = 0; j < nv; ++j)
    for (Index i = 0; i < nu; ++i) {
      const Index i1 = (i + 1) % columns, j1 = (j + 1) % rows;
      const Index a = j * columns + i, b = j * columns + i1, c = j1 * columns + i, d = j1 * columns + i1;
      // Diagonals alternate, so that no direction is preferred.
      if ((i + j) % 2) {
        triangle.push_back({a, b, d});
        triangle.push_back({a, d, c});
      } else {
        triangle.push_back({a, b, c});
        triangle.push_back({b, d, c});
      }
    }
  return make_surface(std::move(position), std::move(triangle));
}

// z = height(x, y) over [0, width] x [0, depth]; normals up.
template <class Height>
Surface terrain(double width, double depth, Index nu, Index nv, const Height &height) {
  return grid(nu, nv, false, false, [&](double u, double v) {
    const double x = u * width, y = v * depth;
    return Vec3(x, y, height(x, y));
  });
}

inline Surface plane(double width, double depth, Index nu, Index nv) {
  return terrain(width, depth, nu, nv, [](double, double) { return 0.0; });
}

// Open tube around z, normals outwards.
inline Surface tube(double radius, double length, Index around, Index along) {
  return grid(around, along, true, false, [&](double u, double v) {
    return Vec3(radius * std::cos(2 * pi * u), radius * std::sin(2 * pi * u), v * length);
  });
}

// Major radius R, minor r; normals outwards. v = 0 is the outer equator, v = 1/2 the inner one.
inline Surface torus(double major, double minor, Index around, Index across) {
  return grid(around, across, true, true, [&](double u, double v) {
    const double rho = major + minor * std::cos(2 * pi * v);
    return Vec3(rho * std::cos(2 * pi * u), rho * std::sin(2 * pi * u), minor * std::sin(2 * pi * v));
  });
}

// An icosahedron, its faces divided `times` times.
inline Surface sphere(double radius, int times) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  Vec<Vec3> p = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                 {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  Vec<Triangle> t = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int k = 0; k < times; ++k) {
    std::map<Edge, Index> middle;
    const auto half = [&](Index a, Index b) {
      const auto [at, fresh] = middle.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<Index>(p.size()));
      if (fresh) p.push_back((p[a] + p[b]) / 2);
      return at->second;
    };
    Vec<Triangle> finer;
    for (const auto &[a, b, c] : t) {
      const Index ab = half(a, b), bc = half(b, c), ca = half(c, a);
      for (const Triangle &f : {Triangle{a, ab, ca}, Triangle{ab, b, bc}, Triangle{ca, bc, c}, Triangle{ab, bc, ca}})
        finer.push_back(f);
    }
    t = finer;
  }
  for (Vec3 &q : p) q *= radius / q.norm();
  return make_surface(std::move(p), std::move(t));
}

inline Vec<Index> every_face(const Surface &s) {
  Vec<Index> faces(s.faces());
  std::iota(faces.begin(), faces.end(), 0);
  return faces;
}

}  // namespace forms
