#include "mesh/surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/edge_table.h"
#include "mesh/rows.h"

namespace ts::mesh {
namespace {

void link_edges(Surface &s) {
  const EdgeTable table(s.vertices(), s.triangle);
  s.twin.assign(3 * s.faces(), none);
  s.edge_of.resize(3 * s.faces());
  s.edge.reserve(s.faces() + s.faces() / 2 + s.vertices() / 16);
  table.each_edge([&](Index low, Index high, std::span<const EdgeTable::Entry> sides) {
    for (const auto &[end, h] : sides) s.edge_of[h] = static_cast<Index>(s.edge.size());
    s.edge.push_back({low, high});
    if (sides.size() != 2 || s.from(sides[0][1]) == s.from(sides[1][1])) return;
    s.twin[sides[0][1]] = sides[1][1];
    s.twin[sides[1][1]] = sides[0][1];
  });
}

void measure(Surface &s) {
  s.face_area.resize(s.faces());
  s.face_normal.resize(s.faces());
  s.vertex_area.assign(s.vertices(), 0);
  for (std::size_t f = 0; f < s.faces(); ++f) {
    const auto [a, b, c] = s.triangle[f];
    const Vec3 n = (s.position[b] - s.position[a]).cross(s.position[c] - s.position[a]);
    const double twice = n.norm();
    s.face_area[f] = twice / 2;
    s.face_normal[f] = twice > 0 ? Vec3(n / twice) : Vec3(0, 0, 0);
    for (const Index v : s.triangle[f]) s.vertex_area[v] += twice / 6;
    s.area += twice / 2;
  }
  for (Index e = 0; e < s.edge.size(); ++e) s.mean_edge += s.edge_length(e);
  if (!s.edge.empty()) s.mean_edge /= static_cast<double>(s.edge.size());
  if (!s.position.empty()) {
    Vec3 low = s.position[0], high = low;
    for (const Vec3 &p : s.position) low = low.cwiseMin(p), high = high.cwiseMax(p);
    s.diagonal = (high - low).norm();
  }
}

void find_components(Surface &s) {
  s.component.assign(s.faces(), none);
  Vec<double> area;
  Vec<Index> stack;
  for (Index f = 0; f < s.faces(); ++f) {
    if (s.component[f] != none) continue;
    const Index c = static_cast<Index>(area.size());
    area.push_back(0);
    s.component[f] = c;
    stack.push_back(f);
    while (!stack.empty()) {
      const Index g = stack.back();
      stack.pop_back();
      area[c] += s.face_area[g];
      for (Index k = 0; k < 3; ++k) {
        const Index t = s.twin[3 * g + k];
        if (t == none || s.component[face_of(t)] != none) continue;
        s.component[face_of(t)] = c;
        stack.push_back(face_of(t));
      }
    }
  }
  Vec<Index> order(area.size()), rank(area.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return area[a] > area[b]; });
  for (Index i = 0; i < order.size(); ++i) rank[order[i]] = i;
  s.vertex_component.assign(s.vertices(), none);
  for (Index f = 0; f < s.faces(); ++f) {
    s.component[f] = rank[s.component[f]];
    for (const Index v : s.triangle[f]) s.vertex_component[v] = s.component[f];
  }
  s.components = static_cast<Index>(area.size());
}

void trace_boundaries(Surface &s) {
  s.on_boundary.assign(s.vertices(), 0);
  // On a manifold mesh each boundary vertex starts exactly one boundary half-edge.
  Vec<Index> leaving(s.vertices(), none);
  for (Index h = 0; h < s.twin.size(); ++h) {
    if (s.twin[h] != none) continue;
    leaving[s.from(h)] = h;
    s.on_boundary[s.from(h)] = s.on_boundary[s.to(h)] = 1;
  }
  Vec<Vec<Index>> loops;
  Vec<double> lengths;
  for (Index v = 0; v < s.vertices(); ++v) {
    Vec<Index> loop;
    double length = 0;
    for (Index w = v; leaving[w] != none;) {
      const Index h = leaving[w];
      leaving[w] = none;
      loop.push_back(w);
      length += s.edge_length(s.edge_of[h]);
      w = s.to(h);
    }
    if (loop.empty()) continue;
    loops.push_back(std::move(loop));
    lengths.push_back(length);
  }
  Vec<Index> order(loops.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return lengths[a] > lengths[b]; });
  s.boundary.start.push_back(0);
  for (const Index i : order) {
    s.boundary.item.insert(s.boundary.item.end(), loops[i].begin(), loops[i].end());
    s.boundary.start.push_back(static_cast<Index>(s.boundary.item.size()));
    s.boundary_length.push_back(lengths[i]);
  }
}

}  // namespace

Surface make_surface(Vec<Vec3> position, Vec<Triangle> triangle) {
  Surface s;
  s.position = std::move(position);
  s.triangle = std::move(triangle);
  link_edges(s);
  s.vertex_faces = rows_by(s.vertices(), s.faces(), [&](std::size_t f, const auto &add) {
    for (const Index v : s.triangle[f]) add(v);
  });
  s.vertex_edges = rows_by(s.vertices(), s.edge.size(), [&](std::size_t e, const auto &add) {
    add(s.edge[e][0]);
    add(s.edge[e][1]);
  });
  measure(s);
  find_components(s);
  trace_boundaries(s);
  return s;
}

}  // namespace ts::mesh
