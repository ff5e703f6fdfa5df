#include "bench/scan_variants.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <random>
#include <set>

namespace ts::bench {
namespace {

using mesh::Vec3;

// Keeps the faces of which `keep` says yes to the centroid; teeth that lose more than a tenth of their area lose their
// label, being no whole teeth any more (negative: neither tooth nor gingiva).
ScanFolder cut(const ScanFolder &scan, const auto &keep) {
  ScanFolder result;
  result.name = scan.name;
  std::map<int, std::pair<double, double>> area;
  Vec<mesh::Index> index(scan.surface.vertices(), mesh::none);
  Vec<Vec3> position;
  Vec<mesh::Triangle> triangle;
  for (std::size_t f = 0; f < scan.surface.faces(); ++f) {
    const mesh::Triangle t = scan.surface.triangle[f];
    const Vec3 c = (scan.surface.position[t[0]] + scan.surface.position[t[1]] + scan.surface.position[t[2]]) / 3;
    auto &[all, kept] = area[scan.label[f]];
    all += scan.surface.face_area[f];
    if (!keep(c)) continue;
    kept += scan.surface.face_area[f];
    mesh::Triangle n{};
    for (int k = 0; k < 3; ++k) {
      if (index[t[k]] == mesh::none)
        index[t[k]] = static_cast<mesh::Index>(position.size()), position.push_back(scan.surface.position[t[k]]);
      n[k] = index[t[k]];
    }
    triangle.push_back(n);
    result.label.push_back(scan.label[f]);
  }
  for (int &label : result.label)
    if (label > 0 && area[label].second < 0.9 * area[label].first) label = -label;
  result.surface = mesh::make_surface(std::move(position), std::move(triangle));
  return result;
}

// Of the labelled teeth: middle, and directions to the left, the front, and up.
struct Frame {
  Vec3 middle = Vec3::Zero(), left, front, up = Vec3::Zero();
};

Frame frame_of(const ScanFolder &scan) {
  Frame f;
  double weight = 0;
  std::map<int, std::pair<double, Vec3>> tooth;
  for (std::size_t k = 0; k < scan.surface.faces(); ++k) {
    if (!scan.label[k]) continue;
    const mesh::Triangle t = scan.surface.triangle[k];
    const double a = scan.surface.face_area[k];
    const Vec3 c = a * (scan.surface.position[t[0]] + scan.surface.position[t[1]] + scan.surface.position[t[2]]) / 3;
    f.up += a * scan.surface.face_normal[k];
    f.middle += c;
    weight += a;
    auto &[w, sum] = tooth.try_emplace(scan.label[k], 0, Vec3::Zero()).first->second;
    w += a, sum += c;
  }
  f.up.normalize();
  f.middle /= weight;
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
  for (const auto &[label, t] : tooth) {
    Vec3 q = t.second / t.first - f.middle;
    q -= q.dot(f.up) * f.up;
    moment += q * q.transpose();
  }
  // The front is where the middle of the teeth lies off the middle of their extremes: the skew of the arch.
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moment);
  double skew[2] = {0, 0};
  for (int k = 0; k < 2; ++k)
    for (const auto &[label, t] : tooth)
      skew[k] += std::pow((t.second / t.first - f.middle).dot(solver.eigenvectors().col(k + 1)), 3);
  const int k = std::abs(skew[0]) > std::abs(skew[1]) ? 0 : 1;
  f.front = solver.eigenvectors().col(k + 1) * (skew[k] < 0 ? 1 : -1);
  f.left = f.up.cross(f.front);
  return f;
}

ScanFolder rebuilt(const ScanFolder &scan, Vec<Vec3> position, bool flip) {
  ScanFolder result;
  result.name = scan.name;
  result.label = scan.label;
  Vec<mesh::Triangle> triangle = scan.surface.triangle;
  if (flip)
    for (mesh::Triangle &t : triangle) std::swap(t[1], t[2]);
  result.surface = mesh::make_surface(std::move(position), std::move(triangle));
  return result;
}

}  // namespace

const char *name_of(Variant v) {
  constexpr const char *names[] = {"as is",     "posed",      "mirrored", "inside out", "noise 0.05", "noise 0.10",
                                   "left half", "right half", "front",    "quadrant",   "shuffled"};
  return names[static_cast<int>(v)];
}

ScanFolder make_variant(const ScanFolder &scan, Variant variant, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Vec<Vec3> position = scan.surface.position;
  switch (variant) {
    case Variant::posed: {
      const Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
      for (Vec3 &p : position) p = q.normalized() * p + Vec3(31, -17, 5);
      return rebuilt(scan, position, false);
    }
    case Variant::mirrored:
      for (Vec3 &p : position) p.x() = -p.x();
      return rebuilt(scan, position, true);
    case Variant::inside_out: return rebuilt(scan, position, true);
    case Variant::noise_05:
    case Variant::noise_10:
      for (Vec3 &p : position)
        for (int k = 0; k < 3; ++k) p[k] += (variant == Variant::noise_05 ? 0.05 : 0.10) * normal(random);
      return rebuilt(scan, position, false);
    case Variant::left_half:
    case Variant::right_half: {
      const Frame f = frame_of(scan);
      const double side = variant == Variant::left_half ? 1 : -1;
      return cut(scan, [&](const Vec3 &p) { return side * (p - f.middle).dot(f.left) > -1; });
    }
    case Variant::front: {
      const Frame f = frame_of(scan);
      return cut(scan, [&](const Vec3 &p) { return (p - f.middle).dot(f.front) > 2; });
    }
    case Variant::quadrant: {
      const Frame f = frame_of(scan);
      return cut(scan,
                 [&](const Vec3 &p) { return (p - f.middle).dot(f.left) > 0 && (p - f.middle).dot(f.front) < 6; });
    }
    case Variant::shuffled: {
      ScanFolder result;
      result.name = scan.name;
      Vec<mesh::Index> order(scan.surface.faces());
      for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<mesh::Index>(i);
      std::shuffle(order.begin(), order.end(), random);
      Vec<mesh::Triangle> triangle;
      for (const mesh::Index f : order)
        triangle.push_back(scan.surface.triangle[f]), result.label.push_back(scan.label[f]);
      result.surface = mesh::make_surface(std::move(position), std::move(triangle));
      return result;
    }
    default: return rebuilt(scan, position, false);
  }
}

}  // namespace ts::bench
