// Area samples of a surface: what is measured on them does not depend on how the surface is cut into triangles.
#pragma once

#include <span>

#include "geometry/frame.h"

namespace ts::geometry {

struct Sample {
  Vec3 position = Vec3::Zero();
  Vec3 normal = Vec3::Zero();  // area-weighted mean, at most 1 long
  double area = 0;             // mm^2 of the surface that it stands for
};

// One sample a cube of edge `spacing` that the surface passes through, in the order of the cubes. Triangles are halved
// at their longest edge until none is longer than the spacing, so that a huge base triangle counts like a fine mesh.
// The cubes stand along the axes of `frame`: the surface's own give a moved surface the moved samples.
Vec<Sample> area_samples(const mesh::Surface &surface, double spacing, const Frame &frame);
inline Vec<Sample> area_samples(const mesh::Surface &surface, double spacing) {
  return area_samples(surface, spacing, principal_frame(surface));
}

// Samples in bins, for the sums over balls.
class SampleBins {
 public:
  SampleBins(std::span<const Sample> samples, double bin);

  // Calls visit(sample, squared distance) for the samples within `radius` of q, in a fixed order.
  template <class Visit>
  void ball(const Vec3 &q, double radius, Visit &&visit) const {
    if (sample_.empty()) return;
    Eigen::Array3i lo, hi;
    for (int k = 0; k < 3; ++k) {
      lo[k] = clamped((q[k] - radius - low_[k]) / bin_, count_[k]);
      hi[k] = clamped((q[k] + radius - low_[k]) / bin_, count_[k]);
    }
    const double limit = radius * radius;
    for (int x = lo[0]; x <= hi[0]; ++x)
      for (int y = lo[1]; y <= hi[1]; ++y) {
        const std::size_t row = (static_cast<std::size_t>(x) * count_[1] + y) * count_[2];
        const std::size_t end = start_[row + hi[2] + 1];  // bins along z lie next to each other
        for (std::size_t i = start_[row + lo[2]]; i < end; ++i) {
          const double d2 = (sample_[i].position - q).squaredNorm();
          if (d2 <= limit) visit(sample_[i], d2);
        }
      }
  }

 private:
  static int clamped(double cell, int count) {
    return cell <= 0 ? 0 : cell >= count - 1 ? count - 1 : static_cast<int>(cell);
  }

  Vec<Sample> sample_;  // sorted by bin
  Vec<mesh::Index> start_;
  Vec3 low_ = Vec3::Zero();
  Eigen::Array3i count_ = Eigen::Array3i::Ones();
  double bin_ = 1;
};

}  // namespace ts::geometry
