// A row of blunt teeth on a flat gum, with known labels and features.
#pragma once

#include <algorithm>
#include <cmath>

#include "../geometry/forms.h"
#include "base/error.h"
#include "base/executor.h"
#include "features/features.h"
#include "mesh/surface_point.h"

namespace made_up {

using namespace ts;
using mesh::Index;
using mesh::Vec3;

inline const Executor one(1);

Fault fault_of(const auto &call) {
  try {
    call();
  } catch (const Error &e) {
    return e.fault();
  }
  return Fault::internal;  // no error
}

struct Row {
  mesh::Surface surface;
  features::Features features;
  Vec<Index> label;  // a face: tooth + 1, 0 on the gum
  Index teeth = 0;

  Index vertex_at(double x, double y) const {
    Index best = 0;
    for (Index v = 0; v < surface.vertices(); ++v) {
      const auto away = [&](Index w) { return std::hypot(surface.position[w].x() - x, surface.position[w].y() - y); };
      if (away(v) < away(best)) best = v;
    }
    return best;
  }
  mesh::SurfacePoint at(double x, double y) const {
    mesh::SurfacePoint p;
    const Index v = vertex_at(x, y);
    p.face = surface.vertex_faces[v].front();
    p.position = surface.position[v];
    for (int k = 0; k < 3; ++k) p.barycentric[k] = surface.triangle[p.face][std::size_t(k)] == v;
    return p;
  }
};

constexpr double kPitch = 7, kHalfWidth = 3.4, kHalfDepth = 3.2, kHeight = 4, kMargin = 14;

inline double centre_x(Index tooth) {
  return kMargin + kPitch * (tooth + 0.5);
}
inline constexpr double centre_y = kMargin + kHalfDepth;

// rho < 1: on the tooth
inline double rho(double x, double y, Index tooth) {
  return std::pow(std::pow((x - centre_x(tooth)) / kHalfWidth, 4) + std::pow((y - centre_y) / kHalfDepth, 4), 0.25);
}

inline Row row(Index teeth, double step = 0.3) {
  Row r;
  r.teeth = teeth;
  const double width = 2 * kMargin + kPitch * teeth, depth = 2 * centre_y;
  const auto nearest = [&](double x) {
    return Index(std::clamp(std::floor((x - kMargin) / kPitch), 0.0, double(teeth - 1)));
  };
  r.surface = forms::terrain(width, depth, Index(width / step), Index(depth / step), [&](double x, double y) {
    return kHeight * (1 - std::pow(std::min(1.0, rho(x, y, nearest(x))), 2.5));
  });
  for (const auto &t : r.surface.triangle) {
    const Vec3 c = (r.surface.position[t[0]] + r.surface.position[t[1]] + r.surface.position[t[2]]) / 3;
    r.label.push_back(rho(c.x(), c.y(), nearest(c.x())) < 1 ? nearest(c.x()) + 1 : 0);
  }
  r.features.occlusal = {0, 0, 1};
  for (Index k = 0; k < teeth; ++k) {
    features::Group g;
    for (const double dx : {-1.5, 1.5})
      for (const double dy : {-1.4, 1.4}) {
        const Index v = r.vertex_at(centre_x(k) + dx, centre_y + dy);
        g.points.push_back({v, r.surface.position[v], 0.3});
      }
    r.features.groups.push_back(g);
  }
  return r;
}

inline double iou(const Row &r, const Vec<Index> &faces, Index tooth) {
  double common = 0, found = 0, wanted = 0;
  for (const Index f : faces) {
    found += r.surface.face_area[f];
    if (r.label[f] == tooth + 1) common += r.surface.face_area[f];
  }
  for (Index f = 0; f < r.label.size(); ++f)
    if (r.label[f] == tooth + 1) wanted += r.surface.face_area[f];
  return common / (found + wanted - common);
}

}  // namespace made_up
