#include "tooth/propose.h"

#include <algorithm>

namespace ts::tooth {
namespace {

// The point of `group` that lies furthest towards `other`: a click there faces it.
Vec3 point_towards(const Prepared &p, Index group, Index other) {
  const Vec3 towards = centre_of(p, other) - centre_of(p, group);
  Index best = mesh::none;
  for (const Index v : p.sites.point)
    if (p.group_at[v] == group &&
        (best == mesh::none || towards.dot(p.surface->position[v]) > towards.dot(p.surface->position[best])))
      best = v;
  return p.surface->position[best];
}

}  // namespace

Vec<Vec3> propose_clicks(const Prepared &p, std::span<const Index> separated) {
  const auto open = [&](std::size_t i) { return std::ranges::find(separated, p.live[i]) == separated.end(); };
  Vec<Vec3> clicks;
  for (std::size_t i = 0; i < p.live.size(); ++i) {
    if (!open(i)) continue;
    const bool pair = i + 1 < p.live.size() && open(i + 1);
    const std::size_t other = pair || i == 0 ? i + 1 : i - 1;
    clicks.push_back(point_towards(p, p.live[i], p.live[other < p.live.size() ? other : i]));
    if (pair) ++i;  // both covered
  }
  return clicks;
}

}  // namespace ts::tooth
