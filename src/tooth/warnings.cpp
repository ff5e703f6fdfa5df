#include "tooth/warnings.h"

#include <algorithm>
#include <limits>

namespace ts::tooth {
namespace {

// Extent of a crown along the arch, mm and over its stretch of the arch. Of 475 crowns with an IoU of .9 or more (the
// 15 labelled scans with both presets, 16 synthetic arches up to severe crowding) the extents are 5.2 to 13.8 and .86
// to 1.82 of the stretch (turned and overlapping teeth). It tells fields that ran away: with the paper's preset 32 of
// 37 teeth under an IoU of .5 lie outside these limits, and 9 of 33 from there to .75.
constexpr double kNarrow = 4, kWide = 16, kLeastOfStretch = 0.65, kMostOfStretch = 2.1;

// Share of what faces the other jaw (to 60 degrees from the mean direction of its highest 2 mm) that lies in that
// direction to 10 degrees: at most .40 on 238 teeth of the 18 real scans, .17 on 223 of synthetic arches; at least .83
// on cylinders 5 mm wide and 8 high, grown together with the gum of such arches in place of a missing tooth.
constexpr double kTop = 2, kFacing = 0.7, kSlope = 0.5, kPlane = 0.985, kMostPlane = 0.58;

// Where the arch is `s` mm from its beginning, seen along the occlusal direction.
Vec3 arch_point(const features::Features &f, double s) {
  Vec3 at = f.arch.front();
  for (std::size_t i = 1; i < f.arch.size() && s > 0; ++i) {
    const Vec3 step = f.arch[i] - f.arch[i - 1];
    const double length = (step - step.dot(f.occlusal) * f.occlusal).norm();
    at = f.arch[i - 1] + (length > s ? s / length : 1) * step;
    s -= length;
  }
  return at;
}

}  // namespace

Vec<Vec3> along_the_arch(const features::Features &features) {
  Vec<Vec3> along;
  for (const features::Group &g : features.groups) {
    Vec3 way = Vec3::Zero();
    if (g.to > g.from && !features.arch.empty()) {
      way = arch_point(features, g.to) - arch_point(features, g.from);
      way -= way.dot(features.occlusal) * features.occlusal;
    }
    along.push_back(way.norm() > 0 ? way.normalized() : Vec3::Zero());
  }
  return along;
}

std::uint32_t warnings_of_place(const Prepared &p, Index group, std::span<const Index> vertices) {
  std::uint32_t warnings = 0;
  const Vec3 &along = p.along[group];
  if (!vertices.empty() && !along.isZero()) {
    const auto [first, last] =
        std::ranges::minmax(vertices, {}, [&](Index v) { return p.surface->position[v].dot(along); });
    const double extent = (p.surface->position[last] - p.surface->position[first]).dot(along);
    if (extent < std::max(kNarrow, kLeastOfStretch * p.width[group]) ||
        extent > std::min(kWide, kMostOfStretch * p.width[group]))
      warnings |= Warning::width;
  }
  // Also a point that was freed: it stood for a tooth that this one may have swallowed. None lies on any of the 198
  // teeth of the labelled scans.
  for (std::size_t i = 0; i < p.sites.point.size(); ++i)
    if (p.sites.group[i] != group && std::ranges::binary_search(vertices, p.sites.point[i]))
      warnings |= Warning::two_groups;
  return warnings;
}

std::uint32_t warnings_of_shape(const mesh::Surface &surface, std::span<const Index> faces, const Vec3 &occlusal,
                                bool inside_out) {
  const double side = inside_out ? -1 : 1;
  double highest = -std::numeric_limits<double>::infinity();
  for (const Index f : faces)
    for (const Index v : surface.triangle[f]) highest = std::max(highest, surface.position[v].dot(occlusal));
  Vec3 up = Vec3::Zero();  // of the top itself, which may be tilted
  for (const Index f : faces) {
    const auto &t = surface.triangle[f];
    const double height = (surface.position[t[0]] + surface.position[t[1]] + surface.position[t[2]]).dot(occlusal) / 3;
    const Vec3 normal = side * surface.face_normal[f];
    if (height > highest - kTop && normal.dot(occlusal) > kFacing) up += surface.face_area[f] * normal;
  }
  up.normalize();
  double top = 0, plane = 0;
  for (const Index f : faces) {
    const double facing = side * surface.face_normal[f].dot(up);
    if (facing > kSlope) top += surface.face_area[f];
    if (facing > kPlane) plane += surface.face_area[f];
  }
  return plane > kMostPlane * top ? Warning::flat_top : 0u;
}

}  // namespace ts::tooth
