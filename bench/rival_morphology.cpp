#include "bench/rival_morphology.h"

#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace ts::bench {
namespace {

using Entry = std::pair<double, Index>;
using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;

// The neighbours of v in their order around it, `closed` unless v is on the scan's border.
struct Ring {
  std::vector<Index> neighbour;
  bool closed = false;

  void walk(const Surface &s, Index v) {
    neighbour.clear();
    closed = false;
    if (s.vertex_faces[v].empty()) return;
    const Index f = s.vertex_faces[v].front();
    Index first = 3 * f;
    while (s.from(first) != v) ++first;
    // Back to the border, where there is one.
    for (Index h = first; s.twin[h] != mesh::none;) {
      h = mesh::next_in_face(s.twin[h]);
      if (h == first) {
        closed = true;
        break;
      }
      if (s.twin[h] == mesh::none) first = h;
    }
    for (Index h = first;;) {
      neighbour.push_back(s.to(h));
      const Index back = mesh::next_in_face(mesh::next_in_face(h));
      if (s.twin[back] == mesh::none) {
        neighbour.push_back(s.from(back));
        return;
      }
      h = s.twin[back];
      if (h == first) return;
    }
  }
};

// Whether the set keeps its shape without v: what is left of it around v hangs together, and so does the rest.
bool is_simple(const Ring &ring, const Mask &mask) {
  if (ring.neighbour.empty()) return false;
  int changes = 0;
  std::uint8_t last = ring.closed ? mask[ring.neighbour.back()] : 1;  // beyond the border: in the set
  for (const Index w : ring.neighbour) {
    changes += mask[w] != last;
    last = mask[w];
  }
  if (!ring.closed) changes += last != 1;
  return changes == 2;
}

}  // namespace

Vec<double> distance_to(const Surface &surface, const Mask &mask, double reach) {
  Vec<double> distance(surface.vertices(), std::numeric_limits<double>::infinity());
  Queue queue;
  for (Index v = 0; v < surface.vertices(); ++v) {
    if (!mask[v]) continue;
    distance[v] = 0;
    queue.push({0, v});
  }
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance[v]) continue;
    for (const Index e : surface.vertex_edges[v]) {
      const Index w = surface.other_end(e, v);
      const double to = d + surface.edge_length(e);
      if (to > reach || to >= distance[w]) continue;
      distance[w] = to;
      queue.push({to, w});
    }
  }
  return distance;
}

Mask dilated(const Surface &surface, const Mask &mask, double radius) {
  const Vec<double> distance = distance_to(surface, mask, radius);
  Mask out(mask.size());
  for (Index v = 0; v < out.size(); ++v) out[v] = distance[v] <= radius;
  return out;
}

Mask closed(const Surface &surface, const Mask &mask, double radius) {
  Mask rest = dilated(surface, mask, radius);
  for (std::uint8_t &x : rest) x = !x;
  rest = dilated(surface, rest, radius);
  for (Index v = 0; v < rest.size(); ++v) rest[v] = !rest[v] || mask[v];
  return rest;
}

void drop_small_pieces(const Surface &surface, Mask &mask, std::uint8_t of, double area) {
  Mask seen(surface.vertices(), 0);
  std::vector<Index> piece;
  for (Index start = 0; start < surface.vertices(); ++start) {
    if (seen[start] || mask[start] != of) continue;
    piece.assign(1, start);
    seen[start] = 1;
    double sum = 0;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      sum += surface.vertex_area[piece[i]];
      for (const Index e : surface.vertex_edges[piece[i]]) {
        const Index w = surface.other_end(e, piece[i]);
        if (seen[w] || mask[w] != of) continue;
        seen[w] = 1;
        piece.push_back(w);
      }
    }
    if (sum < area)
      for (const Index v : piece) mask[v] = !of;
  }
}

void thin(const Surface &surface, Mask &mask, const Vec<double> &priority) {
  Queue queue;
  Mask queued(surface.vertices(), 0);
  Ring ring;
  const auto touched = [&](Index v) {
    if (mask[v] && !queued[v]) {
      queued[v] = 1;
      queue.push({priority[v], v});
    }
  };
  for (Index v = 0; v < surface.vertices(); ++v) {
    if (mask[v]) continue;
    for (const Index e : surface.vertex_edges[v]) touched(surface.other_end(e, v));
  }
  while (!queue.empty()) {
    const Index v = queue.top().second;
    queue.pop();
    queued[v] = 0;
    ring.walk(surface, v);
    if (!is_simple(ring, mask)) continue;
    mask[v] = 0;
    for (const Index w : ring.neighbour) touched(w);
  }
  // A piece that separates nothing has shrunk to a vertex (at the border: to one that leans on it).
  for (Index v = 0; v < surface.vertices(); ++v) {
    if (!mask[v]) continue;
    bool alone = true;
    for (const Index e : surface.vertex_edges[v]) alone = alone && !mask[surface.other_end(e, v)];
    if (alone) mask[v] = 0;
  }
}

}  // namespace ts::bench
