#include "tooth/propose.h"

#include <algorithm>

namespace ts::tooth {
namespace {

mesh::SurfacePoint at_vertex(const mesh::Surface &s, Index v) {
  mesh::SurfacePoint at;
  at.face = s.vertex_faces[v].front();
  at.position = s.position[v];
  for (int k = 0; k < 3; ++k) at.barycentric[k] = s.triangle[at.face][static_cast<std::size_t>(k)] == v ? 1 : 0;
  return at;
}

// The points of a group, those nearest to the points of another first.
Vec<Index> points_towards(const Prepared &p, Index group, Index other) {
  Vec3 centre = Vec3::Zero();
  double count = 0;
  Vec<Index> own;
  for (Index i = 0; i < p.sites.point.size(); ++i) {
    const Index v = p.sites.point[i], g = p.group_at[v];
    if (g == other) centre += p.surface->position[v], ++count;
    if (g == group) own.push_back(v);
  }
  if (count > 0) centre /= count;
  std::stable_sort(own.begin(), own.end(), [&](Index a, Index b) {
    return (p.surface->position[a] - centre).squaredNorm() < (p.surface->position[b] - centre).squaredNorm();
  });
  return own;
}

// A vertex of `group` whose click takes `other` along; none if there is no such point.
Index vertex_for(const Prepared &p, Index group, Index other) {
  for (const Index v : points_towards(p, group, other)) {
    const Pick got = pick(p, at_vertex(*p.surface, v));
    if (got.target == group && got.neighbour == other) return v;
  }
  return mesh::none;
}

}  // namespace

Vec<Vec3> propose_clicks(const Prepared &p) {
  Vec<Vec3> clicks;
  for (std::size_t i = 0; i < p.live.size(); ++i) {
    const Index here = p.live[i];
    Index v = mesh::none;
    if (i + 1 < p.live.size()) {
      v = vertex_for(p, here, p.live[i + 1]);
      if (v == mesh::none) v = vertex_for(p, p.live[i + 1], here);
      if (v != mesh::none) ++i;  // both covered
    }
    if (v == mesh::none) v = points_towards(p, here, here).front();
    clicks.push_back(p.surface->position[v]);
  }
  return clicks;
}

}  // namespace ts::tooth
