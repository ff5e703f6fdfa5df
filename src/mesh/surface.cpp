#include "mesh/surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/stop.h"
#include "mesh/edges.h"
#include "mesh/rows.h"

namespace ts::mesh {
namespace {

constexpr std::size_t kSurfaceGrain = 1 << 13;

// visit(v) for each vertex, with a workspace of the range's own.
template <class Space>
void each_vertex(const Surface &s, const Executor &executor, const auto &visit) {
  executor.ranges(s.vertices(), kSurfaceGrain, [&](std::size_t begin, std::size_t end) {
    Space space{};
    for (Index v = static_cast<Index>(begin); v < end; ++v) visit(space, v);
  });
}

void find_twins(Surface &s, const Executor &executor) {
  s.twin.assign(3 * s.faces(), none);
  each_vertex<EdgesUp>(s, executor, [&](EdgesUp &up, Index v) {
    up(s.triangle, v, s.vertex_faces[v], [&](Index, std::span<const EdgesUp::Side> sides) {
      if (sides.size() != 2 || s.from(sides[0][1]) == s.from(sides[1][1])) return;
      s.twin[sides[0][1]] = sides[1][1];
      s.twin[sides[1][1]] = sides[0][1];
    });
  });
}

// The edges of a surface whose half-edges without a twin are each on an edge of its own: no need to bring the two sides
// of an edge together, so that one of them speaks for both.
void number_joined_edges(Surface &s, const Executor &executor) {
  // visit(half-edge, upper end) for the edges up from v.
  const auto up_from = [&](Index v, const auto &visit) {
    for (const Index f : s.vertex_faces[v]) {
      const Triangle &t = s.triangle[f];
      const Index k = t[0] == v ? 0 : t[1] == v ? 1 : 2, before = k == 0 ? 2 : k - 1;
      const Index next = t[k == 2 ? 0 : k + 1], last = t[before], out = 3 * f + k, in = 3 * f + before;
      if (next > v && out < s.twin[out]) visit(out, next);  // none is more than any
      if (last > v && in < s.twin[in]) visit(in, last);
    }
  };
  Vec<Index> first(s.vertices() + 1, 0);  // of the edges up from a vertex
  each_vertex<int>(s, executor, [&](int, Index v) { up_from(v, [&](Index, Index) { ++first[v + 1]; }); });
  std::partial_sum(first.begin(), first.end(), first.begin());
  s.edge.resize(first.back());
  s.edge_of.resize(3 * s.faces());
  each_vertex<Vec<EdgesUp::Side>>(s, executor, [&](Vec<EdgesUp::Side> &up, Index v) {
    up.clear();
    up_from(v, [&](Index h, Index high) { up.push_back({high, h}); });
    std::sort(up.begin(), up.end(), [](const auto &a, const auto &b) { return a[0] < b[0]; });
    for (Index i = 0, e = first[v]; i < up.size(); ++i, ++e) {
      const auto &[high, h] = up[i];
      s.edge[e] = {v, high};
      s.edge_of[h] = e;
      if (s.twin[h] != none) s.edge_of[s.twin[h]] = e;
    }
  });
}

void number_edges(Surface &s, const Executor &executor) {
  Vec<Index> first(s.vertices() + 1, 0);
  each_vertex<EdgesUp>(s, executor, [&](EdgesUp &up, Index v) {
    up(s.triangle, v, s.vertex_faces[v], [&](Index, std::span<const EdgesUp::Side>) { ++first[v + 1]; });
  });
  std::partial_sum(first.begin(), first.end(), first.begin());
  s.edge.resize(first.back());
  s.edge_of.resize(3 * s.faces());
  each_vertex<EdgesUp>(s, executor, [&](EdgesUp &up, Index v) {
    Index e = first[v];
    up(s.triangle, v, s.vertex_faces[v], [&](Index high, std::span<const EdgesUp::Side> sides) {
      s.edge[e] = {v, high};
      for (const auto &[end, h] : sides) s.edge_of[h] = e;
      ++e;
    });
  });
}

void measure_faces(Surface &s, const Executor &executor) {
  s.face_area.resize(s.faces());
  s.face_normal.resize(s.faces());
  executor.ranges(s.faces(), kSurfaceGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const auto [a, b, c] = s.triangle[f];
      const Vec3 n = (s.position[b] - s.position[a]).cross(s.position[c] - s.position[a]);
      const double twice = n.norm();
      s.face_area[f] = twice / 2;
      s.face_normal[f] = twice > 0 ? Vec3(n / twice) : Vec3(0, 0, 0);
    }
  });
  s.vertex_area.resize(s.vertices());
  executor.ranges(s.vertices(), kSurfaceGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      double area = 0;
      for (const Index f : s.vertex_faces[v]) area += 2 * s.face_area[f] / 6;
      s.vertex_area[v] = area;
    }
  });
}

void measure(Surface &s, const Executor &executor) {
  measure_faces(s, executor);
  for (const double area : s.face_area) s.area += area;
  // Summed in the order of the edges, a block of lengths at a time.
  constexpr std::size_t block = 1 << 16;
  Vec<double> length(std::min(block, s.edge.size()));
  for (std::size_t first = 0; first < s.edge.size(); first += block) {
    const std::size_t n = std::min(block, s.edge.size() - first);
    executor.ranges(n, kSurfaceGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) length[i] = s.edge_length(static_cast<Index>(first + i));
    });
    for (std::size_t i = 0; i < n; ++i) s.mean_edge += length[i];
  }
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
  StopNowAndThen stop(1 << 16);
  for (Index f = 0; f < s.faces(); ++f) {
    if (s.component[f] != none) continue;
    const Index c = static_cast<Index>(area.size());
    area.push_back(0);
    s.component[f] = c;
    stack.push_back(f);
    while (!stack.empty()) {
      stop();
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
    stop();
    s.component[f] = rank[s.component[f]];
    for (const Index v : s.triangle[f]) s.vertex_component[v] = s.component[f];
  }
  s.components = static_cast<Index>(area.size());
}

void trace_boundaries(Surface &s) {
  s.on_boundary.assign(s.vertices(), 0);
  // On a manifold mesh each boundary vertex starts exactly one boundary half-edge.
  Vec<Index> leaving(s.vertices(), none);
  StopNowAndThen stop(1 << 16);
  for (Index h = 0; h < s.twin.size(); ++h) {
    stop();
    if (s.twin[h] != none) continue;
    leaving[s.from(h)] = h;
    s.on_boundary[s.from(h)] = s.on_boundary[s.to(h)] = 1;
  }
  Vec<Vec<Index>> loops;
  Vec<double> lengths;
  for (Index v = 0; v < s.vertices(); ++v) {
    stop();
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

Rows faces_around(std::size_t vertices, std::span<const Triangle> triangle) {
  return rows_by(vertices, triangle.size(), [&](std::size_t f, const auto &add) {
    for (const Index v : triangle[f]) add(v);
  });
}

std::size_t Surface::bytes() const {
  const auto of = [](const auto &...all) { return ((all.size() * sizeof(all[0])) + ...); };
  return of(position, triangle, twin, edge, edge_of, vertex_faces.start, vertex_faces.item, vertex_edges.start,
            vertex_edges.item, face_area, face_normal, vertex_area, component, vertex_component, boundary.start,
            boundary.item, boundary_length, on_boundary);
}

Surface make_surface(Vec<Vec3> position, Vec<Triangle> triangle, const Executor &executor, Links links) {
  Surface s;
  s.position = std::move(position);
  s.triangle = std::move(triangle);
  s.vertex_faces = std::move(links.vertex_faces);
  s.twin = std::move(links.twin);
  if (s.vertex_faces.start.empty()) s.vertex_faces = faces_around(s.vertices(), s.triangle);
  if (s.twin.empty()) {
    find_twins(s, executor);
    number_edges(s, executor);
  } else {
    number_joined_edges(s, executor);
  }
  measure(s, executor);
  // What is left goes from one element to the next and cannot be split, but each part for itself.
  executor.each(3, [&](std::size_t part) {
    if (part == 0)
      s.vertex_edges = rows_by(s.vertices(), s.edge.size(), [&](std::size_t e, const auto &add) {
        add(s.edge[e][0]);
        add(s.edge[e][1]);
      });
    else if (part == 1)
      find_components(s);
    else
      trace_boundaries(s);
  });
  return s;
}

}  // namespace ts::mesh
