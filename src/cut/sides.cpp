#include "cut/sides.h"

#include <algorithm>

namespace ts::cut {
namespace {

Index edge_between(const Surface &s, Index a, Index b) {
  for (const Index e : s.vertex_edges[a])
    if (s.other_end(e, a) == b) return e;
  return mesh::none;
}

}  // namespace

CrossedEdges::CrossedEdges(const Surface &s, std::span<const Polyline *const> lines) {
  for (Index line = 0; line < lines.size(); ++line)
    for (Index i = 0; i < lines[line]->points.size(); ++i) {
      const EdgePoint &p = lines[line]->points[i];
      all_.push_back({edge_between(s, p.a, p.b), line, i, p});
    }
  std::ranges::sort(all_, {}, &CrossedEdge::edge);
}

const CrossedEdge *CrossedEdges::find(Index edge) const {
  const auto at = std::ranges::lower_bound(all_, edge, {}, &CrossedEdge::edge);
  return at != all_.end() && at->edge == edge ? &*at : nullptr;
}

void mark_sides(const Surface &s, std::span<const Polyline *const> lines, Space &space) {
  SparseArray<std::uint8_t> &marks = space.marks;
  Vec<Index> stack;
  const auto enter = [&](Index v) {
    if (marks[v]) return;
    marks.set(v, kWithin);
    stack.push_back(v);
  };
  // The half-edge that a line leaves a face's inside by begins within it; that by which an open one ends, outside.
  const auto sides = [&](const EdgePoint &p, Index face, bool last) {
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      Index in = s.from(h), out = s.to(h);
      if ((in != p.a && in != p.b) || (out != p.a && out != p.b)) continue;
      if (last) std::swap(in, out);
      if (!marks[out]) marks.set(out, kBeside);
      enter(in);
    }
  };
  for (const Polyline *line : lines)
    for (std::size_t i = 0; i < line->points.size(); ++i) {
      const bool last = i == line->faces.size();
      sides(line->points[i], line->faces[last ? i - 1 : i], last);
    }
  while (!stack.empty()) {
    const Index v = stack.back();
    stack.pop_back();
    for (const Index e : s.vertex_edges[v]) enter(s.other_end(e, v));
  }
}

double share_within(const Surface &s, Index face, FunctionRef<bool(Index)> within, const CrossedEdges &crossed) {
  int in = 0;
  for (const Index v : s.triangle[face]) in += within(v);
  if (in == 0 || in == 3) return in == 3 ? 1 : 0;
  double share = 1;  // of the corner that is alone on its side
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Index v = s.from(h), w = s.to(h);
    if (within(v) == within(w)) continue;
    const CrossedEdge *c = crossed.find(s.edge_of[h]);
    const double from_a = c ? c->point.t : 0.5;
    const Index alone = within(v) == (in == 1) ? v : w;
    share *= s.edge[s.edge_of[h]][0] == alone ? from_a : 1 - from_a;
  }
  return in == 1 ? share : 1 - share;
}

void take_within(const Surface &s, const CrossedEdges &crossed, Space &space) {
  const auto within = [&](Index v) { return (space.marks[v] & kWithin) != 0; };
  for (const Index v : space.marks.touched()) {
    if (!within(v)) continue;
    for (const Index f : s.vertex_faces[v])
      if (!space.inside[f] && share_within(s, f, within, crossed) > 0.5) space.inside.set(f, 1);
  }
}

}  // namespace ts::cut
