// What intake says it did, against the mesh that came of it. SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "check.h"

namespace check {
namespace {

using Index = std::uint32_t;

bool near(double a, double b) {
  return std::abs(a - b) <= 1e-9 * (std::abs(a) + std::abs(b)) + 1e-100;
}

double distance(const double *a, const double *b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double area_of(const double *a, const double *b, const double *c) {
  const double u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}

std::size_t distinct(const std::vector<Index> &values) {
  return std::set<Index>(values.begin(), values.end()).size();
}

// Pieces of a graph whose links are `next`.
class Pieces {
 public:
  explicit Pieces(std::size_t n) : root_(n) { std::iota(root_.begin(), root_.end(), Index{0}); }
  Index of(Index v) {
    while (root_[v] != v) v = root_[v] = root_[root_[v]];
    return v;
  }
  void join(Index a, Index b) { root_[of(a)] = of(b); }

 private:
  std::vector<Index> root_;
};

// What became of the caller's faces and vertices adds up.
void counts(const ts_model *m, const ts_intake_report &r) {
  const auto sources = all<Index>([&](Index *p, Index n, Index *c) { return ts_model_get_face_sources(m, p, n, c); });
  HOLDS(sources.size() == r.faces && std::is_sorted(sources.begin(), sources.end()));
  const std::size_t kept = distinct(sources);
  // A polygon may be kept in part, its other triangles being those of another face.
  HOLDS(kept + r.degenerate_faces <= r.input_faces);
  HOLDS(kept + r.degenerate_faces + r.duplicate_faces >= r.input_faces);
  HOLDS(r.polygons <= r.input_faces && r.flipped_faces <= r.input_faces);
  if (r.polygons == 0) HOLDS(kept == r.faces && kept + r.degenerate_faces + r.duplicate_faces == r.input_faces);

  auto stand_for = all<Index>([&](Index *p, Index n, Index *c) { return ts_model_get_vertex_map(m, p, n, c); });
  HOLDS(stand_for.size() == r.input_vertices);
  const auto none = static_cast<std::size_t>(std::count(stand_for.begin(), stand_for.end(), TS_NONE));
  const std::size_t used = distinct(stand_for) - (none > 0);
  HOLDS(used + r.welded_vertices + r.unreferenced_vertices == r.input_vertices);
  HOLDS(none >= r.unreferenced_vertices);
  HOLDS(r.vertices >= used);
  if (r.non_manifold_edges + r.non_manifold_vertices + r.unorientable_edges == 0) HOLDS(r.vertices == used);
}

}  // namespace

void report(const ts_model *m) {
  ts_intake_report r;
  r.struct_size = sizeof r;
  HOLDS(ts_model_get_report(m, &r) == TS_OK);
  counts(m, r);

  const auto xyz = all<double>([&](double *p, Index n, Index *c) { return ts_model_get_positions(m, p, n, c); }, 3);
  const auto triangles = all<Index>([&](Index *p, Index n, Index *c) { return ts_model_get_triangles(m, p, n, c); }, 3);
  Pieces pieces(r.vertices), rims(r.vertices);
  std::map<std::pair<Index, Index>, int> edges;
  double area = 0, length = 0, low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    area += area_of(&xyz[3 * triangles[t]], &xyz[3 * triangles[t + 1]], &xyz[3 * triangles[t + 2]]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = triangles[t + k], b = triangles[t + (k + 1) % 3];
      pieces.join(a, b);
      ++edges[{std::min(a, b), std::max(a, b)}];
      for (std::size_t d = 0; d < 3; ++d)
        low[d] = std::min(low[d], xyz[3 * a + d]), high[d] = std::max(high[d], xyz[3 * a + d]);
    }
  }
  // On a manifold mesh the edges with one face form closed loops, each vertex in one at most.
  std::set<Index> components, loops, on_rim;
  for (const auto &[edge, faces] : edges) {
    length += distance(&xyz[3 * edge.first], &xyz[3 * edge.second]);
    if (faces > 1) continue;
    rims.join(edge.first, edge.second);
    on_rim.insert({edge.first, edge.second});
  }
  for (Index v = 0; v < r.vertices; ++v) components.insert(pieces.of(v));
  for (const Index v : on_rim) loops.insert(rims.of(v));
  HOLDS(components.size() == r.components && loops.size() == r.boundary_loops);
  HOLDS(near(r.area, area) && near(r.diagonal, distance(low, high)));
  HOLDS(near(r.mean_edge, length / static_cast<double>(edges.size())));
}

}  // namespace check
