// u of Eq. 3 at the vertices that are asked for.
#pragma once

#include <bit>

#include "base/pool.h"
#include "field/factor.h"

namespace ts::field {

// What a right-hand side has on the free unknowns, for the parts that it is not zero on (Border).
struct Source {
  Vec<Index> part;  // ascending
  Vec<std::size_t> start;
  Vec<double> value;

  std::span<const double> operator[](Index p) const {
    const auto at = std::ranges::lower_bound(part, p);
    if (at == part.end() || *at != p) return {};
    const auto i = static_cast<std::size_t>(at - part.begin());
    return {value.data() + start[i], value.data() + start[i + 1]};
  }
};

// A back-substitution that goes as far as it has to: the value at a vertex needs those of its own part and of the parts
// above it, and no others. So a look at one tooth costs the tooth's share of the factor, and every value has the bytes
// that it has when all are worked out. Not for concurrent use: each task asks one of its own.
class Solution {
 public:
  // What a solution works in; n + tiles long, and as long as a factor is used.
  struct Space {
    Vec<double> x;           // by place
    Vec<std::uint8_t> done;  // a tile
    Vec<Index> tiles;        // those done
    Vec<Block> made;
    Vec<double> sums;
    const Factor *factor = nullptr;

    explicit Space(const Factor &factor);
    void clear() noexcept;
  };

  // Pieces of the surface in which nothing is held: 1 a piece, empty if there is none. A part may lie in several
  // pieces, so their values are reckoned with as zeros, not as NaN.
  struct Dark {
    std::span<const Index> piece_of;  // a vertex
    Vec<std::uint8_t> piece;
  };

  // `at_nodes`: a value a node, NaN in dark pieces; `source` may be empty. All are copied.
  Solution(const Factor &factor, Pool<Space> &pool, std::span<const double> at_nodes, Dark dark, Source source = {});

  // NaN on pieces left out, and where nothing held is in reach.
  double operator()(Index vertex) {
    const Index place = factor_->place(vertex);
    if (place == mesh::none || (!dark_.piece.empty() && dark_.piece[dark_.piece_of[vertex]]))
      return std::numeric_limits<double>::quiet_NaN();
    const double value = space_->x[place];
    if (std::bit_cast<std::uint64_t>(value) != kUnset) return value;
    evaluate(factor_->tile_of(place));
    return space_->x[place];
  }

  void evaluate_all();

  std::size_t bytes() const { return bytes_; }           // of the factor read so far
  double milliseconds() const { return milliseconds_; }  // spent on it

 private:
  static constexpr std::uint64_t kUnset = 0x7ff8'7007'0000'0001;  // a NaN that no arithmetic makes

  void evaluate(Index tile);
  void substitute(const Factor::Tile &tile);
  void add_source(const Factor::Record &record);

  const Factor *factor_;
  Pool<Space>::Lease space_;
  Dark dark_;
  Source source_;
  std::size_t bytes_ = 0;
  double milliseconds_ = 0;
};

}  // namespace ts::field
