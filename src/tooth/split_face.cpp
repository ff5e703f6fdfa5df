#include "tooth/split_face.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace ts::tooth {
namespace {

// In barycentric coordinates, where the face has the area 1/2: nearer to a chord than this is on it.
constexpr double kOn = 1e-7;

struct Corner {
  Index id;
  Vec3 weight;
  Vec<Index> on;  // chords, of a point inside the face
};

class Splitter {
 public:
  Splitter(std::span<const RingPoint> ring, std::span<const Chord> chords, FunctionRef<Index(const Vec3 &)> add)
      : chords_(chords), add_(add), ring_(static_cast<Index>(ring.size())) {
    polygons_.emplace_back();
    for (const RingPoint &p : ring) {
      polygons_[0].push_back(static_cast<Index>(corner_.size()));
      corner_.push_back({p.id, p.weight, {}});
    }
    for (const Chord &c : chords) ends_.push_back({place_of(c.from), place_of(c.to)});
    for (Index c = 0; c < chords.size(); ++c) cut(c);
  }

  void give(Vec<Vec<Index>> &pieces, Vec<Mark> &marks) const {
    for (const Vec<Index> &polygon : polygons_) {
      Vec<Index> ids;
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Index a = polygon[k], b = polygon[(k + 1) % polygon.size()];
        ids.push_back(corner_[a].id);
        for (Index c = 0; c < chords_.size(); ++c) {
          if (!is_on(a, c) || !is_on(b, c)) continue;
          const bool forward = along(c).dot(corner_[b].weight - corner_[a].weight) > 0;
          marks.push_back({corner_[forward ? a : b].id, corner_[forward ? b : a].id, chords_[c].line});
        }
      }
      pieces.push_back(std::move(ids));
    }
  }

 private:
  Index place_of(Index id) const {
    Index k = 0;
    while (corner_[k].id != id) ++k;
    return k;
  }

  Vec3 along(Index c) const { return corner_[ends_[c].second].weight - corner_[ends_[c].first].weight; }

  bool is_on(Index p, Index c) const {
    if (p < ring_) return p == ends_[c].first || p == ends_[c].second;
    return std::ranges::find(corner_[p].on, c) != corner_[p].on.end();
  }

  // Twice the area of the triangle of a chord and a point.
  double offset(Index p, Index c) const {
    const Vec3 d = along(c), q = corner_[p].weight - corner_[ends_[c].first].weight;
    return d[1] * q[2] - d[2] * q[1];
  }

  // 1 left of the chord, -1 right of it, 0 on it.
  int side(Index p, Index c) {
    if (is_on(p, c)) return 0;
    if (p < ring_) {
      const auto [i, j] = ends_[c];
      const bool between = i < j ? p > i && p < j : p > i || p < j;
      return between ? -1 : 1;
    }
    const double off = offset(p, c);
    if (std::abs(off) < kOn) {
      corner_[p].on.push_back(c);
      return 0;
    }
    return off > 0 ? 1 : -1;
  }

  // Where the chord crosses the side of two polygons, the same point for both.
  Index crossing(Index a, Index b, Index c) {
    if (a > b) std::swap(a, b);
    const auto [at, fresh] = crossings_.try_emplace({a, b, c}, static_cast<Index>(corner_.size()));
    if (!fresh) return at->second;
    const double da = std::abs(offset(a, c)), db = std::abs(offset(b, c));
    const double t = da + db > 0 ? da / (da + db) : 0.5;
    const Vec3 weight = (1 - t) * corner_[a].weight + t * corner_[b].weight;
    Vec<Index> on = {c};
    for (Index other = 0; other < chords_.size(); ++other)
      if (other != c && is_on(a, other) && is_on(b, other)) on.push_back(other);
    corner_.push_back({add_(weight), weight, std::move(on)});
    return at->second;
  }

  void cut(Index c) {
    const std::size_t count = polygons_.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Vec<Index> polygon = polygons_[i];
      Vec<int> sides;
      for (const Index p : polygon) sides.push_back(side(p, c));
      int changes = 0, last = 0, first = 0;
      for (const int s : sides) {
        if (s == 0) continue;
        changes += last != 0 && s != last;
        if (first == 0) first = s;
        last = s;
      }
      changes += last != first;
      if (changes != 2) continue;
      Vec<Index> left, right;
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const std::size_t next = (k + 1) % polygon.size();
        if (sides[k] >= 0) left.push_back(polygon[k]);
        if (sides[k] <= 0) right.push_back(polygon[k]);
        if (sides[k] * sides[next] >= 0) continue;
        const Index p = crossing(polygon[k], polygon[next], c);
        left.push_back(p);
        right.push_back(p);
      }
      polygons_[i] = std::move(left);
      polygons_.push_back(std::move(right));
    }
  }

  std::span<const Chord> chords_;
  FunctionRef<Index(const Vec3 &)> add_;
  Index ring_;
  Vec<Corner> corner_;  // those of the ring first, in its order
  Vec<std::pair<Index, Index>> ends_;
  Vec<Vec<Index>> polygons_;
  std::map<std::array<Index, 3>, Index> crossings_;
};

}  // namespace

void split_face(std::span<const RingPoint> ring, std::span<const Chord> chords, FunctionRef<Index(const Vec3 &)> add,
                Vec<Vec<Index>> &pieces, Vec<Mark> &marks) {
  Splitter(ring, chords, add).give(pieces, marks);
}

void triangulate_convex(std::span<const Vec3> position, std::span<const Index> polygon, Vec<Triangle> &out) {
  const std::size_t n = polygon.size();
  if (n == 3) {
    out.push_back({polygon[0], polygon[1], polygon[2]});
    return;
  }
  const auto badness = [&](std::size_t i, std::size_t j, std::size_t k) {
    const Vec3 &a = position[polygon[i]], &b = position[polygon[j]], &c = position[polygon[k]];
    const double area = (b - a).cross(c - a).norm();
    const double sides = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
    return area > 1e-12 * sides ? sides / area : std::numeric_limits<double>::max();
  };
  // Of the part of the polygon from i to j, closed by that diagonal.
  Vec<double> cost(n * n, 0);
  Vec<std::size_t> middle(n * n, 0);
  for (std::size_t gap = 2; gap < n; ++gap)
    for (std::size_t i = 0; i + gap < n; ++i) {
      const std::size_t j = i + gap;
      double best = std::numeric_limits<double>::infinity();
      for (std::size_t k = i + 1; k < j; ++k) {
        const double worst = std::max({cost[i * n + k], cost[k * n + j], badness(i, k, j)});
        if (worst < best) best = worst, middle[i * n + j] = k;
      }
      cost[i * n + j] = best;
    }
  Vec<std::pair<std::size_t, std::size_t>> stack = {{0, n - 1}};
  while (!stack.empty()) {
    const auto [i, j] = stack.back();
    stack.pop_back();
    if (j < i + 2) continue;
    const std::size_t k = middle[i * n + j];
    out.push_back({polygon[i], polygon[k], polygon[j]});
    stack.push_back({i, k});
    stack.push_back({k, j});
  }
}

}  // namespace ts::tooth
