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
  const auto here = std::find(p.live.begin(), p.live.end(), pick.target);
  if (here != p.live.begin()) pick.neighbour = *(here - 1);
  if (here + 1 != p.live.end()) (pick.neighbour == mesh::none ? pick.neighbour : pick.other) = *(here + 1);
  if (pick.other != mesh::none &&
      towards(p, pick.target, pick.other, click) > towards(p, pick.target, pick.neighbour, click))
    std::swap(pick.neighbour, pick.other);
}

// Calls reach(vertex, distance) for the vertices around a click in the order of distance, until it returns false.
void search(const Prepared &p, const mesh::SurfacePoint &at, const auto &reach) {
  const mesh::Surface &s = *p.surface;
  geometry::PathStart starts[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const Index v = s.triangle[at.face][k];
    starts[k] = {v, (s.position[v] - at.position).norm(), 0};
  }
  p.space()->paths.search(
      starts, [&](Index e) { return p.relief->click_cost[e]; }, [&](Index v, double d, Index) { return reach(v, d); });
}

}  // namespace

Pick pick(const Prepared &p, const mesh::SurfacePoint &at) {
  Pick pick;
  const bool plain = p.options.click_concavity <= 0;
  search(p, at, [&](Index v, double d) {
    const Index g = p.group_at[v];
    if (g == mesh::none || g == pick.target) return true;
    if (pick.target != mesh::none) {
      pick.neighbour = g;
      return false;
    }
    pick.target = g;
    pick.target_distance = d;
    return plain && p.live.size() > 1;
  });
  if (!plain && pick.target != mesh::none) beside(p, at.position, pick);
  return pick;
}

Pick pick_group(const Prepared &p, const mesh::SurfacePoint &at, Index group) {
  Pick pick;
  pick.target = group;
  pick.target_distance = distance_to(p, at, group);
  beside(p, at.position, pick);
  return pick;
}

double distance_to(const Prepared &p, const mesh::SurfacePoint &at, Index group) {
  double found = std::numeric_limits<double>::quiet_NaN();
  if (group == mesh::none) return found;
  found = HUGE_VAL;
  search(p, at, [&](Index v, double d) {
    if (p.group_at[v] != group) return true;
    found = d;
    return false;
  });
  return found;
}

void settle(Pick &pick, std::span<const Index> separated) {
  const auto done = [&](Index g) { return std::ranges::find(separated, g) != separated.end(); };
  if (pick.other == mesh::none || !done(pick.neighbour) || done(pick.other)) return;
  std::swap(pick.neighbour, pick.other);
}

}  // namespace ts::tooth
