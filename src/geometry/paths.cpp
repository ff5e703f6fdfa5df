#include "geometry/paths.h"

namespace ts::geometry {

Vec<double> edge_distances(const Surface &surface, std::span<const PathStart> starts, double limit) {
  Vec<double> distance(surface.vertices(), std::numeric_limits<double>::infinity());
  PathFinder finder(surface);
  for (const Index v : finder.within(
           starts, [&](Index e) { return surface.edge_length(e); }, limit))
    distance[v] = finder.distance(v);
  return distance;
}

}  // namespace ts::geometry
