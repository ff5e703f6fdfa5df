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

using Pair = std::optional<std::array<Ridge, 2>>;

// For each tooth of a division of the lattice the two incisal ridges of it, in the order of the arch, where it is two
// anterior teeth: ridges that are connected only over cells much less convex than either. Nothing where it is one, and
// for other teeth.
Vec<Pair> two_ridges(const Strip &strip, const Division &division, const Lattice &lattice);

}  // namespace ts::features
