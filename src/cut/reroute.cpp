#include "cut/reroute.h"

#include <algorithm>
#include <limits>

#include "base/error.h"

namespace ts::cut {
namespace {

Index halfedge_from_to(const Surface &s, Index a, Index b) {
  for (const Index f : s.vertex_faces[a])
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      if (s.from(h) == a && s.to(h) == b) return h;
  return mesh::none;
}

}  // namespace

Reroute::Reroute(const Surface &surface, Space &space) : s_(surface), space_(space) {
  for (const Index f : space.inside.touched())
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      if (is_border(h)) {
        border_.push_back(h);
        for (const Index v : {s_.from(h), s_.to(h)}) space.marks.set(v, space.marks[v] | kBorder);
      }
}

bool Reroute::is_border(Index h) const {
  return space_.inside[mesh::face_of(h)] && s_.twin[h] != mesh::none && !space_.inside[mesh::face_of(s_.twin[h])];
}

Index Reroute::nearest(const EdgePoint &at, std::span<const double> length, double reach) const {
  const geometry::PathStart starts[] = {{at.a, (s_.position[at.a] - at.position).norm()},
                                        {at.b, (s_.position[at.b] - at.position).norm()}};
  Index found = mesh::none;
  space_.paths.search(
      starts, [&](Index e) { return length[e]; },
      [&](Index v, double distance, Index) {
        if (distance > reach) return false;
        if (on_border(v)) found = v;
        return found == mesh::none;
      });
  return found;
}

void Reroute::free_stretch(Index from, Index to, std::span<const double> length, double reach) {
  Vec<Index> best;
  double least = reach;
  // Where the border touches itself at `from`, several begin there.
  for (const Index f : s_.vertex_faces[from])
    for (Index first = 3 * f; first < 3 * f + 3; ++first) {
      if (s_.from(first) != from || !is_border(first)) continue;
      Vec<Index> stretch;
      double sum = 0;
      for (Index h = first; h != mesh::none && sum <= least;) {
        stretch.push_back(h);
        sum += length[s_.edge_of[h]];
        if (s_.to(h) == to) break;
        for (h = mesh::next_in_face(h); h != mesh::none && !is_border(h);)
          h = s_.twin[h] == mesh::none ? mesh::none : mesh::next_in_face(s_.twin[h]);
        if (h == first) break;
      }
      if (s_.to(stretch.back()) != to || sum > least) continue;
      least = sum;
      best = std::move(stretch);
    }
  if (best.empty())
    throw Error(Fault::edit_crossing, "the border of the tooth is too folded there to be led another way");
  for (const Index h : best) freed_.push_back(s_.from(h));
  freed_.push_back(to);
  std::ranges::sort(best);
  std::erase_if(border_, [&](Index h) { return std::ranges::binary_search(best, h); });
  for (const Index v : freed_) space_.marks.set(v, space_.marks[v] & static_cast<std::uint8_t>(~kBorder));
  for (const Index h : border_)
    for (const Index v : {s_.from(h), s_.to(h)}) space_.marks.set(v, space_.marks[v] | kBorder);
}

void Reroute::leave(double far, std::span<const double> length) {
  Vec<geometry::PathStart> starts;
  for (const Index v : freed_) starts.push_back({v});
  for (const Index v : space_.paths.within(
           starts, [&](Index e) { return length[e]; }, far))
    space_.marks.set(v, space_.marks[v] | kLeft);
}

Vec<Index> Reroute::cheapest(Index from, Index to, FunctionRef<double(Index)> cost) {
  constexpr double kBarred = std::numeric_limits<double>::infinity();
  const auto open = [&](Index v) { return v == from || v == to || !barred(v); };
  const auto price = [&](Index e) { return open(s_.edge[e][0]) && open(s_.edge[e][1]) ? cost(e) : kBarred; };
  SparseArray<Index> &order = space_.place;
  Index count = 0;
  bool there = false;
  const geometry::PathStart start[] = {{from}};
  space_.paths.search(start, price, [&](Index v, double distance, Index) {
    if (!(distance < kBarred)) return false;
    order.set(v, count++);
    there = v == to;
    return !there;
  });
  Vec<Index> way;
  if (there) {
    way.push_back(to);
    while (way.back() != from) {
      const Index v = way.back();
      Index before = mesh::none;
      for (const Index e : s_.vertex_edges[v]) {
        const Index w = s_.other_end(e, v);
        if (order[w] < order[v] && space_.paths.distance(w) + price(e) == space_.paths.distance(v) &&
            (before == mesh::none || order[w] < order[before]))
          before = w;
      }
      if (before == mesh::none) throw Error(Fault::internal, "a path has no beginning");
      way.push_back(before);
    }
    std::ranges::reverse(way);
  }
  order.clear();
  return way;
}

void Reroute::take(std::span<const Index> way, std::span<const Index> seeds) {
  constexpr std::uint8_t kIn = 1, kOut = 2;
  Vec<Index> bar;  // edges of the new border
  Vec<Index> left;
  Mask &side = space_.faces;
  const auto set_bar = [&](Index h, Index back, bool fresh) {
    bar.push_back(s_.edge_of[h != mesh::none ? h : back]);
    if (back != mesh::none) side.set(mesh::face_of(back), kOut);
    if (h != mesh::none && fresh) left.push_back(mesh::face_of(h));
  };
  for (const Index h : border_) set_bar(h, s_.twin[h], false);
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    const Index h = halfedge_from_to(s_, way[i], way[i + 1]), back = halfedge_from_to(s_, way[i + 1], way[i]);
    set_bar(h, back, true);
    for (const Index v : {way[i], way[i + 1]}) bolt(v);
  }
  std::ranges::sort(bar);
  const auto refuse = [] {
    throw Error(Fault::edit_crossing,
                "the new line would cross the rest of the cut, or part feature points of the tooth from it");
  };
  Vec<Index> stack;
  const auto enter = [&](Index f) {
    if (side[f] == kIn) return;
    if (side[f] == kOut) refuse();
    side.set(f, kIn);
    stack.push_back(f);
  };
  for (const Index v : seeds)
    for (const Index f : s_.vertex_faces[v])
      if (!barred(v) || (space_.inside[f] && side[f] != kOut)) enter(f);
  while (!stack.empty()) {
    const Index f = stack.back();
    stack.pop_back();
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      if (s_.twin[h] == mesh::none) continue;
      const Index e = s_.edge_of[h];
      const bool may_bar = barred(s_.edge[e][0]) && barred(s_.edge[e][1]);
      if (!may_bar || !std::ranges::binary_search(bar, e)) enter(mesh::face_of(s_.twin[h]));
    }
  }
  for (const Index f : left)
    if (side[f] != kIn) refuse();
  for (const Index f : side.touched())
    if (side[f] == kOut) side.set(f, 0);
}

}  // namespace ts::cut
