// The half-edges of a triangle list, brought together edge by edge.
#pragma once

#include <algorithm>
#include <numeric>
#include <span>

#include "mesh/surface.h"

namespace ts::mesh {

struct EdgeTable {
  using Entry = std::array<Index, 2>;  // upper end, half-edge
  Vec<Index> start;                    // by lower end
  Vec<Entry> entry;

  // Buckets by the lower end and sorts the few entries of each: linear but for hubs, where a sort of all would not be.
  EdgeTable(std::size_t vertices, std::span<const Triangle> triangle) {
    start.assign(vertices + 1, 0);
    for (const auto &[a, b, c] : triangle)
      ++start[std::min(a, b) + 1], ++start[std::min(b, c) + 1], ++start[std::min(c, a) + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    entry.resize(start.back());
    Vec<Index> fill(start.begin(), start.end() - 1);
    for (Index f = 0; f < triangle.size(); ++f)
      for (Index k = 0; k < 3; ++k) {
        const Index a = triangle[f][k], b = triangle[f][k == 2 ? 0 : k + 1];
        entry[fill[std::min(a, b)]++] = {std::max(a, b), 3 * f + k};
      }
    for (std::size_t v = 0; v < vertices; ++v) std::sort(entry.begin() + start[v], entry.begin() + start[v + 1]);
  }

  // visit(low, high, entries) for each edge, in lexicographic order of its ends.
  void each_edge(const auto &visit) const {
    for (Index low = 0; low + 1 < start.size(); ++low)
      for (Index i = start[low]; i < start[low + 1];) {
        Index j = i;
        while (j < start[low + 1] && entry[j][0] == entry[i][0]) ++j;
        visit(low, entry[i][0], std::span<const Entry>(entry.data() + i, j - i));
        i = j;
      }
  }
};

}  // namespace ts::mesh
