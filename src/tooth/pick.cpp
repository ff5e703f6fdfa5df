#include "tooth/pick.h"

#include <algorithm>

#include "geometry/paths.h"

namespace ts::tooth {

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
  Index before = mesh::none, after = mesh::none;
  geometry::PathFinder(s).search(
      starts, [&](Index e) { return p.click_cost[e]; },
      [&](Index v, double d, Index) {
        const Index g = p.group_at[v];
        if (g == mesh::none) return true;
        if (pick.target == mesh::none) {
          pick.target = g;
          pick.target_distance = d;
          const auto here = std::lower_bound(p.live.begin(), p.live.end(), g);
          if (here != p.live.begin()) before = *(here - 1);
          if (here + 1 != p.live.end()) after = *(here + 1);
          return p.live.size() > 1;
        }
        if (g == pick.target || (!plain && g != before && g != after)) return true;
        pick.neighbour = g;
        pick.neighbour_distance = d;
        return false;
      });
  return pick;
}

}  // namespace ts::tooth
