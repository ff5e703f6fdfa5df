#include "mesh/weld.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "base/stop.h"
#include "mesh/rows.h"

namespace ts::mesh {
namespace {

bool before(const Vec3 &a, const Vec3 &b) {
  return a.x() != b.x() ? a.x() < b.x() : a.y() != b.y() ? a.y() < b.y() : a.z() < b.z();
}

std::uint64_t mix(std::uint64_t h) {
  h ^= h >> 32;
  h *= 0x9e3779b97f4a7c15u;
  h ^= h >> 29;
  h *= 0xd1342543de82ef95u;
  return h ^ (h >> 32);
}

std::uint64_t hash(const Vec3 &p) {
  std::uint64_t h = 0;
  for (int k = 0; k < 3; ++k) h = mix(h + std::bit_cast<std::uint64_t>(p[k] + 0.0));  // + 0.0: -0 equals 0
  return h;
}

// Buckets of equal hash, sorted inside: no choice of coordinates makes this worse than n log n.
Vec<Index> weld_equal(std::span<const Vec3> position, const Executor &executor) {
  const std::size_t n = position.size();
  const int bits = std::max(1, static_cast<int>(std::bit_width(n)));
  Vec<Index> bucket(n), kept(n);
  executor.ranges(n, 1 << 15, [&](std::size_t b, std::size_t e) {
    for (std::size_t v = b; v < e; ++v) bucket[v] = static_cast<Index>(hash(position[v]) >> (64 - bits));
  });
  Rows rows = rows_by(std::size_t{1} << bits, n, [&](std::size_t v, const auto &add) { add(bucket[v]); });
  executor.ranges(rows.size(), 1 << 15, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      const auto first = rows.item.begin() + rows.start[r], last = rows.item.begin() + rows.start[r + 1];
      const auto is_first = [&](Index v) { return position[v] == position[*first]; };
      if (!std::all_of(first, last, is_first))
        std::sort(first, last, [&](Index a, Index b) {
          return before(position[a], position[b]) || (!before(position[b], position[a]) && a < b);
        });
      for (auto i = first, group = first; i != last; ++i) {
        if (position[*i] != position[*group]) group = i;
        kept[*i] = *group;
      }
    }
  });
  return kept;
}

// The kept vertices in cubes of the tolerance's size, found again by hash; at most a handful share a cube.
class Grid {
 public:
  Grid(std::span<const Vec3> position, double size)
      : position_(position),
        size_(size),
        mask_(std::bit_ceil(2 * position.size() + 1) - 1),
        head_(mask_ + 1, none),
        next_(position.size(), none) {}

  void add(Index v) {
    Index &head = head_[slot(cell(position_[v]))];
    next_[v] = head;
    head = v;
  }

  // The nearest kept vertex closer than the tolerance; of equally near ones the first in order of position.
  Index nearest(const Vec3 &p) const {
    Index best = none;
    double least = size_ * size_;
    const Vec3 home = cell(p);
    for (int i = 0; i < 27; ++i) {
      const Eigen::Vector3i step(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      for (Index v = head_[slot(home + step.cast<double>())]; v != none; v = next_[v]) {
        const double d = (position_[v] - p).squaredNorm();
        if (d > least || (best == none && d == least)) continue;
        if (d < least || before(position_[v], position_[best])) best = v, least = d;
      }
    }
    return best;
  }

 private:
  Vec3 cell(const Vec3 &p) const {
    return Vec3(std::floor(p.x() / size_), std::floor(p.y() / size_), std::floor(p.z() / size_));
  }
  std::size_t slot(const Vec3 &c) const { return hash(c) & mask_; }

  std::span<const Vec3> position_;
  double size_;
  std::size_t mask_;
  Vec<Index> head_, next_;
};

}  // namespace

Vec<Index> weld(std::span<const Vec3> position, double tolerance, const Executor &executor) {
  Vec<Index> kept = weld_equal(position, executor);
  // Below this no two different coordinates of a scan are that close, and the division would overflow.
  if (!(tolerance > 1e-100)) return kept;
  Vec<Index> order;
  for (Index v = 0; v < kept.size(); ++v)
    if (kept[v] == v) order.push_back(v);
  StopNowAndThen stop(1 << 16);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    stop();
    return before(position[a], position[b]);
  });
  stop = StopNowAndThen(1 << 12);
  Grid grid(position, tolerance);
  Vec<Index> leader(kept.size(), none);
  for (const Index v : order) {
    stop();
    const Index near = grid.nearest(position[v]);
    leader[v] = near == none ? v : near;
    if (near == none) grid.add(v);
  }
  for (Index &v : kept) v = leader[v];
  return kept;
}

}  // namespace ts::mesh
