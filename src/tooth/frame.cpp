#include "tooth/frame.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

namespace ts::tooth {
namespace {

Vec3 flat(const Vec3 &v, const Vec3 &occlusal) {
  return v - v.dot(occlusal) * occlusal;
}

// The direction of the arch over this length, mm: about half a tooth, over which the digitised curve may waver.
constexpr double kStretch = 3;

struct Place {
  double at = 0, length = 0;  // along the arch, and of all of it, seen along the occlusal direction
  Vec3 along = Vec3::Zero();
};

Place place_on(std::span<const Vec3> arch, const Vec3 &p, const Vec3 &occlusal) {
  Place place;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < arch.size(); ++i) {
    const Vec3 step = flat(arch[i + 1] - arch[i], occlusal), to = flat(p - arch[i], occlusal);
    const double length = step.norm();
    const double t = length > 0 ? std::clamp(to.dot(step) / (length * length), 0.0, 1.0) : 0;
    if (const double away = (to - t * step).squaredNorm(); away < least)
      least = away, place.at = place.length + t * length;
    place.length += length;
  }
  double s = 0;
  for (std::size_t i = 0; i + 1 < arch.size(); ++i) {
    const Vec3 step = flat(arch[i + 1] - arch[i], occlusal);
    const double length = step.norm(), from = std::max(s, place.at - kStretch);
    const double to = std::min(s + length, place.at + kStretch);
    if (to > from && length > 0) place.along += (to - from) / length * step;
    s += length;
  }
  return place;
}

Vec3 widest(const mesh::Surface &s, const Tooth &tooth, const Vec3 &centre, const Vec3 &occlusal) {
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Index v : tooth.vertices) {
    const Vec3 d = flat(s.position[v] - centre, occlusal);
    spread += s.vertex_area[v] * d * d.transpose();
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(2);
}

}  // namespace

ToothFrame frame_of(const mesh::Surface &s, const Tooth &tooth, const Vec3 &occlusal, std::span<const Vec3> arch) {
  ToothFrame f;
  double area = 0;
  for (const Index t : tooth.faces) {
    const auto &[a, b, c] = s.triangle[t];
    f.centre += s.face_area[t] * (s.position[a] + s.position[b] + s.position[c]) / 3;
    area += s.face_area[t];
  }
  if (area > 0) f.centre /= area;
  f.occlusal = occlusal;
  if (arch.size() > 1) {
    const Place place = place_on(arch, f.centre, occlusal);
    const Vec3 mesial = place.at < place.length / 2 ? place.along : Vec3(-place.along);
    f.from_arch = mesial.norm() > 0;
    if (f.from_arch) f.mesial = mesial.normalized();
  }
  if (!f.from_arch) f.mesial = flat(widest(s, tooth, f.centre, occlusal), occlusal).normalized();
  f.buccal = occlusal.cross(f.mesial).normalized();
  if (f.from_arch && f.buccal.dot(f.centre - (arch.front() + arch.back()) / 2) < 0) f.buccal = -f.buccal;
  const auto extent = [&](const Vec3 &axis) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Index v : tooth.vertices) {
      const double x = s.position[v].dot(axis);
      low = std::min(low, x), high = std::max(high, x);
    }
    return tooth.vertices.empty() ? 0 : high - low;
  };
  f.width = extent(f.mesial);
  f.depth = extent(f.buccal);
  f.height = extent(f.occlusal);
  return f;
}

}  // namespace ts::tooth
