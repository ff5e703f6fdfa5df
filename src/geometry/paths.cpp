#include "geometry/paths.h"

namespace ts::geometry {

Vec<double> edge_distances(const Surface &surface, std::span<const PathStart> starts, double limit) {
  Vec<double> distance(surface.vertices(), std::numeric_limits<double>::infinity());
  PathFinder(surface).search(
      starts, [&](Index e) { return surface.edge_length(e); },
      [&](Index v, double d, Index) {
        if (d > limit) return false;
        distance[v] = d;
        return true;
      });
  return distance;
}

}  // namespace ts::geometry
