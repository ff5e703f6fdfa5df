#include "field/nodes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/paths.h"

namespace ts::field {
namespace {

// A rim longer than this is the edge of the scan, not a hole in it; what of it is at least kRimClearance from every
// feature is gingiva, base or cheek also on scans trimmed close to the teeth. mm.
constexpr double kRimLength = 60, kRimClearance = 6;
// Scans trimmed so close that nearly nothing is beyond gingiva_distance: the distance is lowered by this factor once.
constexpr double kLeastShare = 0.01, kCloser = 10.0 / 13.0;

Vec<geometry::PathStart> starts_at(const Sites &sites) {
  Vec<geometry::PathStart> starts;
  for (Index i = 0; i < sites.point.size(); ++i) starts.push_back({sites.point[i], 0, i});
  return starts;
}

double area_beyond(const mesh::Surface &surface, const Vec<double> &distance, double limit) {
  double area = 0;
  for (Index v = 0; v < surface.vertices(); ++v)
    if (std::isfinite(distance[v]) && distance[v] > limit) area += surface.vertex_area[v];
  return area;
}

// Paths end a little beyond `limit`: which vertices are further away is all that is asked. Those get the largest
// number, those that no path leads to infinity.
Vec<double> distances_up_to(const mesh::Surface &surface, const Sites &sites, double limit) {
  Vec<double> distance = geometry::edge_distances(surface, starts_at(sites), limit * (1 + 1e-9));
  Vec<std::uint8_t> reached(surface.components, 0);
  for (const Index v : sites.point)
    if (surface.vertex_component[v] != mesh::none) reached[surface.vertex_component[v]] = 1;
  for (Index v = 0; v < surface.vertices(); ++v)
    if (const Index c = surface.vertex_component[v]; !std::isfinite(distance[v]) && c != mesh::none && reached[c])
      distance[v] = std::numeric_limits<double>::max();
  return distance;
}

Vec<std::uint8_t> certain_gingiva(const mesh::Surface &surface, const Sites &sites, double limit, double lengthened) {
  Vec<double> distance = distances_up_to(surface, sites, std::max(limit, kRimClearance) * lengthened);
  for (double &d : distance) d /= lengthened;
  if (area_beyond(surface, distance, limit) < kLeastShare * surface.area) limit *= kCloser;
  Vec<std::uint8_t> gingiva(surface.vertices(), 0);
  for (Index v = 0; v < surface.vertices(); ++v) gingiva[v] = std::isfinite(distance[v]) && distance[v] > limit;
  for (Index loop = 0; loop < surface.boundary.size(); ++loop) {
    if (surface.boundary_length[loop] <= kRimLength * lengthened) break;  // longest first
    for (const Index v : surface.boundary[loop])
      if (std::isfinite(distance[v]) && distance[v] > kRimClearance) gingiva[v] = 1;
  }
  return gingiva;
}

}  // namespace

Nodes make_nodes(const mesh::Surface &surface, const Sites &sites, const NodeOptions &options) {
  Nodes nodes;
  nodes.groups = sites.groups;
  nodes.of_vertex.assign(surface.vertices(), mesh::none);
  Vec<Index> node_of_point(sites.point.size(), mesh::none);
  for (Index i = 0; i < sites.point.size(); ++i) {
    Index &at = nodes.of_vertex[sites.point[i]];
    if (at != mesh::none) continue;
    at = node_of_point[i] = static_cast<Index>(nodes.group.size());
    nodes.group.push_back(sites.group[i]);
    nodes.point.push_back(i);
  }
  if (options.seed_radius > 0) {
    geometry::PathFinder(surface).search(
        starts_at(sites), [&](Index e) { return surface.edge_length(e); },
        [&](Index v, double d, Index point) {
          if (d > options.seed_radius * options.lengthened) return false;
          if (nodes.of_vertex[v] == mesh::none) nodes.of_vertex[v] = node_of_point[point];
          return true;
        });
  }
  if (options.gingiva) {
    const Vec<std::uint8_t> gingiva = certain_gingiva(surface, sites, options.gingiva_distance, options.lengthened);
    for (Index v = 0; v < surface.vertices(); ++v) {
      if (!gingiva[v] || nodes.of_vertex[v] != mesh::none) continue;
      if (nodes.gingiva == mesh::none) {
        nodes.gingiva = static_cast<Index>(nodes.group.size());
        nodes.group.push_back(gingiva_group);
        nodes.point.push_back(mesh::none);
      }
      nodes.of_vertex[v] = nodes.gingiva;
    }
  }
  nodes.vertices.start.assign(nodes.size() + 1, 0);
  for (const Index n : nodes.of_vertex)
    if (n != mesh::none) ++nodes.vertices.start[n + 1];
  std::partial_sum(nodes.vertices.start.begin(), nodes.vertices.start.end(), nodes.vertices.start.begin());
  nodes.vertices.item.resize(nodes.vertices.start.back());
  Vec<Index> fill(nodes.vertices.start.begin(), nodes.vertices.start.end() - 1);
  for (Index v = 0; v < surface.vertices(); ++v)
    if (const Index n = nodes.of_vertex[v]; n != mesh::none) nodes.vertices.item[fill[n]++] = v;
  return nodes;
}

}  // namespace ts::field
