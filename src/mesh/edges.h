// The half-edges of a triangle list, brought together edge by edge, one vertex at a time.
#pragma once

#include <algorithm>
#include <span>

#include "mesh/surface.h"

namespace ts::mesh {

// The edges that go up from a vertex: those of which it is the end with the smaller index. Going through the vertices
// in order gives all edges in lexicographic order of their ends; different vertices may be asked at the same time, of
// gatherers of their own. A hub costs n log n.
class EdgesUp {
 public:
  using Side = std::array<Index, 2>;  // upper end, half-edge

  // visit(upper end, sides) for each edge up from v, sides ascending. `faces`: those around v.
  void operator()(std::span<const Triangle> triangle, Index v, std::span<const Index> faces, const auto &visit) {
    side_.clear();
    for (const Index f : faces) {
      const Triangle &t = triangle[f];
      const Index k = t[0] == v ? 0 : t[1] == v ? 1 : 2, before = k == 0 ? 2 : k - 1;
      const Index next = t[k == 2 ? 0 : k + 1], last = t[before];
      if (next > v) side_.push_back({next, 3 * f + k});
      if (last > v) side_.push_back({last, 3 * f + before});
    }
    std::sort(side_.begin(), side_.end(), [](const Side &a, const Side &b) { return key(a) < key(b); });
    for (std::size_t i = 0, j = 0; i < side_.size(); i = j) {
      while (j < side_.size() && side_[j][0] == side_[i][0]) ++j;
      visit(side_[i][0], std::span<const Side>(side_.data() + i, j - i));
    }
  }

 private:
  static std::uint64_t key(const Side &s) { return std::uint64_t{s[0]} << 32 | s[1]; }

  Vec<Side> side_;
};

}  // namespace ts::mesh
