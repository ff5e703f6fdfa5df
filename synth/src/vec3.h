// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace tsa {

struct Vec3 {
  double x = 0, y = 0, z = 0;
};

inline Vec3 operator+(Vec3 a, Vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(Vec3 a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator*(double k, Vec3 a) {
  return {k * a.x, k * a.y, k * a.z};
}
inline double dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline double norm(Vec3 a) {
  return std::sqrt(dot(a, a));
}
inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vec3 normalised(Vec3 a) {
  const double n = norm(a);
  return n > 0 ? (1 / n) * a : a;
}

inline double clamp01(double x) {
  return x < 0 ? 0 : (x > 1 ? 1 : x);
}
inline double smoothstep(double from, double to, double x) {
  const double t = clamp01((x - from) / (to - from));
  return t * t * (3 - 2 * t);
}

// Quadratic blends: equal to min and max where |a - b| >= k; at a = b off by k / 4. A union blended with k closes
// gaps narrower than k / 2.
inline double smoothMin(double a, double b, double k) {
  const double h = k - std::abs(a - b);
  return std::fmin(a, b) - (h > 0 ? h * h / (4 * k) : 0);
}
inline double smoothMax(double a, double b, double k) {
  return -smoothMin(-a, -b, k);
}

}  // namespace tsa
