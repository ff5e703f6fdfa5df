#include "tooth/pick.h"

#include <algorithm>
#include <cmath>

#include "geometry/paths.h"

namespace ts::tooth {

namespace {

Vec3 centre_of(const Prepared &p, Index group) {
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (const Index v : p.sites.point)
    if (p.group_at[v] == group) sum += p.surface->position[v], ++count;
  return sum / std::max(1.0, count);
}

Index neighbour_on_side(const Prepared &p, Index target, const Vec3 &click) {
  const auto here = std::lower_bound(p.live.begin(), p.live.end(), target);
  const Vec3 centre = centre_of(p, target);
  Index best = mesh::none;
  double most = 0;
  const auto offer = [&](Index group) {
    const Vec3 way = centre_of(p, group) - centre;
    const double side = (click - centre).dot(way) / std::max(way.norm(), 1e-9);
    if (best == mesh::none || side > most) best = group, most = side;
  };
  if (here != p.live.begin()) offer(*(here - 1));
  if (here + 1 != p.live.end()) offer(*(here + 1));
  return best;
}

}  // namespace

Pick pick(const Prepared &p, const mesh::SurfacePoint &at) {
  const mesh::Surface &s = *p.surface;
  Pick pick;
  pick.target_distance = pick.neighbour_distance = std::numeric_limits<double>::quiet_NaN();
  geometry::PathStart starts[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const Index v = s.triangle[at.face][k];
    starts[k] = {v, (s.position[v] - at.position).norm(), 0};
  }
  const bool plain = p.options.click_concavity <= 0;
  geometry::PathFinder(s).search(
      starts, [&](Index e) { return p.click_cost[e]; },
      [&](Index v, double d, Index) {
        const Index g = p.group_at[v];
        if (g == mesh::none) return true;
        if (pick.target == mesh::none) {
          pick.target = g;
          pick.target_distance = d;
          if (!plain) pick.neighbour = neighbour_on_side(p, g, at.position);
          return p.live.size() > 1;
        }
        if (g == pick.target || (!plain && g != pick.neighbour)) return true;
        pick.neighbour = g;
        pick.neighbour_distance = d;
        return false;
      });
  if (pick.neighbour != mesh::none && std::isnan(pick.neighbour_distance)) {
    // No way along the surface: on another piece of it.
    pick.neighbour_distance = std::numeric_limits<double>::infinity();
  }
  return pick;
}

}  // namespace ts::tooth
