// Two teeth that the division along the arch took for one: of crowded anterior teeth one stands before the other, and
// no line across the arch parts them.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "features/teeth.h"

namespace ts::features {

// A crown within a span: cells of the strip, as Strip::at gives them, ascending.
struct Ridge {
  Vec<std::size_t> cells;
  int from = 0, to = 0;  // slices

  bool has(std::size_t cell) const { return std::ranges::binary_search(cells, cell); }
};

// The two incisal ridges of a span with two anterior teeth, in the order of the arch: ridges that are connected only
// over cells much less convex than either. Nothing where there is one, and for other teeth. `expected`: how wide the
// formula has a tooth there, mm; `table`: mean width of the span's occlusal table, mm.
std::optional<std::array<Ridge, 2>> two_ridges(const Strip &strip, const ToothSpan &tooth, double expected,
                                               double table);

}  // namespace ts::features
