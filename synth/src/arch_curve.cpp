// SPDX-License-Identifier: Apache-2.0
#include "arch_curve.h"

#include <algorithm>

namespace tsa {
namespace {

constexpr double kStep = 0.01, kMaxX = 40;
constexpr int kGridX = 60, kGridY = 110;
constexpr double kGridTop = 25;

}  // namespace

ArchCurve::ArchCurve(double a, double b) : a_(a), b_(b) {
  const int n = static_cast<int>(kMaxX / kStep);
  length_.assign(n + 2, 0);
  for (int i = 0; i <= n; ++i) {
    const double x = (i + 0.5) * kStep, slope = 2 * a_ * x + 4 * b_ * x * x * x;
    length_[i + 1] = length_[i] + kStep * std::sqrt(1 + slope * slope);
  }
  start_.resize(static_cast<size_t>(kGridX) * kGridY);
  for (int j = 0; j < kGridY; ++j)
    for (int i = 0; i < kGridX; ++i) {
      double best = 1e30, at = 0;
      for (int k = 0; k <= 4 * static_cast<int>(kMaxX); ++k) {
        const double x = 0.25 * k, dx = x - (i + 0.5), dy = -(a_ * x * x + b_ * x * x * x * x) - (kGridTop - (j + 0.5));
        if (dx * dx + dy * dy < best) best = dx * dx + dy * dy, at = x;
      }
      start_[static_cast<size_t>(j) * kGridX + i] = static_cast<float>(at);
    }
}

double ArchCurve::nearest(double px, double py, double x) const {
  for (int k = 0; k < 4; ++k) {
    const double y = -(a_ * x * x + b_ * x * x * x * x), d1 = -(2 * a_ * x + 4 * b_ * x * x * x),
                 d2 = -(2 * a_ + 12 * b_ * x * x);
    const double g = (x - px) + (y - py) * d1, h = 1 + d1 * d1 + (y - py) * d2;
    x = std::clamp(x - std::clamp(g / std::max(h, 0.3), -1.0, 1.0), 0.0, kMaxX);
  }
  return x;
}

ArchCurve::Coordinates ArchCurve::locate(double px, double py) const {
  const double sign = px < 0 ? -1 : 1, ax = std::abs(px);
  const int i = std::clamp(static_cast<int>(ax), 0, kGridX - 1);
  const int j = std::clamp(static_cast<int>(kGridTop - py), 0, kGridY - 1);
  const double x = nearest(ax, py, start_[static_cast<size_t>(j) * kGridX + i]);
  const double y = -(a_ * x * x + b_ * x * x * x * x), slope = 2 * a_ * x + 4 * b_ * x * x * x;
  const double n = 1 / std::sqrt(1 + slope * slope);
  const double across = ((ax - x) * slope + (py - y)) * n, dist = std::hypot(ax - x, py - y);
  const int k = static_cast<int>(x / kStep);
  const double s = length_[k] + (x / kStep - k) * (length_[k + 1] - length_[k]);
  return {sign * s, across < 0 ? -dist : dist};
}

double ArchCurve::parameter(double s) const {
  const auto it = std::upper_bound(length_.begin(), length_.end(), std::abs(s));
  const int k = std::clamp(static_cast<int>(it - length_.begin()) - 1, 0, static_cast<int>(length_.size()) - 2);
  const double x = kStep * (k + (std::abs(s) - length_[k]) / (length_[k + 1] - length_[k]));
  return s < 0 ? -x : x;
}

Vec3 ArchCurve::point(double s) const {
  const double x = parameter(s);
  return {x, -(a_ * x * x + b_ * x * x * x * x), 0};
}

Vec3 ArchCurve::outward(double s) const {
  const double x = parameter(s);
  return normalised({2 * a_ * x + 4 * b_ * x * x * x, 1, 0});
}

}  // namespace tsa
