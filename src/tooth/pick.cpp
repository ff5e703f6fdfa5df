#include "tooth/pick.h"

#include <algorithm>
#include <cmath>

#include "geometry/paths.h"

namespace ts::tooth {

Vec3 centre_of(const Prepared &p, Index group) {
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (const Index v : p.sites.point)
    if (p.group_at[v] == group) sum += p.surface->position[v], ++count;
  return sum / std::max(1.0, count);
}

namespace {

// How far `click` lies from the target's centre towards `group`'s, mm.
double towards(const Prepared &p, Index target, Index group, const Vec3 &click) {
  const Vec3 centre = centre_of(p, target), way = centre_of(p, group) - centre;
  return (click - centre).dot(way) / std::max(way.norm(), 1e-9);
}

// The two beside the target along the arch, the one that the click faces first.
void beside(const Prepared &p, const Vec3 &click, Pick &pick) {
  const auto here = std::lower_bound(p.live.begin(), p.live.end(), pick.target);
  if (here != p.live.begin()) pick.neighbour = *(here - 1);
  if (here + 1 != p.live.end()) (pick.neighbour == mesh::none ? pick.neighbour : pick.other) = *(here + 1);
  if (pick.other != mesh::none &&
      towards(p, pick.target, pick.other, click) > towards(p, pick.target, pick.neighbour, click))
    std::swap(pick.neighbour, pick.other);
}

}  // namespace

Pick pick(const Prepared &p, const mesh::SurfacePoint &at) {
  const mesh::Surface &s = *p.surface;
  Pick pick;
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  pick.target_distance = pick.neighbour_distance = pick.other_distance = unknown;
  geometry::PathStart starts[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const Index v = s.triangle[at.face][k];
    starts[k] = {v, (s.position[v] - at.position).norm(), 0};
  }
  const bool plain = p.options.click_concavity <= 0;
  const auto missing = [](Index group, double distance) { return group != mesh::none && std::isnan(distance); };
  geometry::PathFinder(s).search(
      starts, [&](Index e) { return p.click_cost[e]; },
      [&](Index v, double d, Index) {
        const Index g = p.group_at[v];
        if (g == mesh::none || g == pick.target) return true;
        if (pick.target == mesh::none) {
          pick.target = g;
          pick.target_distance = d;
          if (!plain) beside(p, at.position, pick);
          return p.live.size() > 1;
        }
        if (plain) pick.neighbour = g;
        if (g == pick.neighbour && missing(g, pick.neighbour_distance)) pick.neighbour_distance = d;
        if (g == pick.other && missing(g, pick.other_distance)) pick.other_distance = d;
        return missing(pick.neighbour, pick.neighbour_distance) || missing(pick.other, pick.other_distance);
      });
  // No way along the surface: on another piece of it.
  if (missing(pick.neighbour, pick.neighbour_distance)) pick.neighbour_distance = HUGE_VAL;
  if (missing(pick.other, pick.other_distance)) pick.other_distance = HUGE_VAL;
  return pick;
}

void settle(Pick &pick, std::span<const Index> separated) {
  const auto done = [&](Index g) { return std::ranges::find(separated, g) != separated.end(); };
  if (pick.other == mesh::none || !done(pick.neighbour) || done(pick.other)) return;
  std::swap(pick.neighbour, pick.other);
  std::swap(pick.neighbour_distance, pick.other_distance);
}

}  // namespace ts::tooth
