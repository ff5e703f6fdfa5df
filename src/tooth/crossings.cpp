#include "tooth/crossings.h"

#include <algorithm>
#include <cmath>

#include "base/stop.h"

namespace ts::tooth {
namespace {

// Above which side of a plane: 0 on it, as far as rounding tells.
constexpr double kFlat = 1e-14;
int orient(const Vec3 &a, const Vec3 &b, const Vec3 &c, const Vec3 &d) {
  const Vec3 u = a - d, v = b - d, w = c - d;
  const double volume = u.dot(v.cross(w));
  if (volume * volume <= kFlat * kFlat * u.squaredNorm() * v.squaredNorm() * w.squaredNorm()) return 0;
  return volume > 0 ? 1 : -1;
}

// Whether the segment from p to q, which are on either side of the triangle's plane or on it, goes through the
// triangle.
bool pierces(const Vec3 &p, const Vec3 &q, const Vec3 &a, const Vec3 &b, const Vec3 &c) {
  const int u = orient(p, q, a, b), v = orient(p, q, b, c), w = orient(p, q, c, a);
  return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

struct Box {
  Vec3 low, high;
  Index triangle;
};

bool apart(const Box &a, const Box &b) {
  for (Eigen::Index k = 0; k < 3; ++k)
    if (a.low[k] > b.high[k] || a.high[k] < b.low[k]) return true;
  return false;
}

// Strips across an axis, as wide as boxes are on average or wider, so that most boxes are in one or two.
class Strips {
 public:
  Strips(std::span<const Box> boxes, const Box &whole, Eigen::Index axis) : axis_(axis), low_(whole.low[axis]) {
    double sum = 0;
    for (const Box &b : boxes) sum += b.high[axis] - b.low[axis];
    const double extent = whole.high[axis] - low_, n = static_cast<double>(boxes.size());
    count_ = static_cast<std::size_t>(std::clamp(extent * n / std::max(sum, kLeast), 1.0, std::sqrt(n)));
    per_mm_ = static_cast<double>(count_) / std::max(extent, kLeast);
  }

  std::size_t count() const { return count_; }
  std::size_t first(const Box &b) const { return at(b.low[axis_]); }
  std::size_t last(const Box &b) const { return at(b.high[axis_]); }

 private:
  static constexpr double kLeast = 1e-300;
  std::size_t at(double x) const {
    return static_cast<std::size_t>(std::clamp((x - low_) * per_mm_, 0.0, static_cast<double>(count_ - 1)));
  }

  Eigen::Index axis_;
  double low_, per_mm_ = 0;
  std::size_t count_ = 1;
};

class TrianglePairs {
 public:
  TrianglePairs(std::span<const Vec3> position, std::span<const Triangle> triangle)
      : position_(position), triangle_(triangle) {}

  bool cross(Index s, Index t) const {
    const Triangle &a = triangle_[s], &b = triangle_[t];
    int shared = 0;
    for (const Index v : a) shared += std::ranges::find(b, v) != b.end();
    if (shared == 3) return true;
    if (shared == 2) return folded(a, b);
    return through(a, b) || through(b, a);
  }

 private:
  // A side of the first that has no corner in common with the second goes through it, or ends on it.
  bool through(const Triangle &sides, const Triangle &b) const {
    const Vec3 &p = position_[b[0]], &q = position_[b[1]], &r = position_[b[2]];
    constexpr int kShared = 2;
    std::array<int, 3> above{};
    for (std::size_t k = 0; k < 3; ++k)
      above[k] = std::ranges::find(b, sides[k]) != b.end() ? kShared : orient(p, q, r, position_[sides[k]]);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (above[k] == kShared || above[next] == kShared) continue;
      if (above[k] == above[next]) continue;  // on one side, or both on the plane
      if (pierces(position_[sides[k]], position_[sides[next]], p, q, r)) return true;
    }
    return false;
  }

  bool folded(const Triangle &a, const Triangle &b) const {
    Index common[2] = {}, apart[2] = {};
    std::size_t n = 0;
    for (const Index v : a)
      if (std::ranges::find(b, v) != b.end())
        common[n++] = v;
      else
        apart[0] = v;
    for (const Index v : b)
      if (std::ranges::find(a, v) == a.end()) apart[1] = v;
    const Vec3 &o = position_[common[0]], side = position_[common[1]] - o;
    const Vec3 m = side.cross(position_[apart[0]] - o), k = side.cross(position_[apart[1]] - o);
    return m.dot(k) > 0 && m.cross(k).norm() < 1e-9 * m.norm() * k.norm();
  }

  std::span<const Vec3> position_;
  std::span<const Triangle> triangle_;
};

}  // namespace

Vec<std::array<Index, 2>> crossings(std::span<const Vec3> position, std::span<const Triangle> triangle, Index first) {
  Vec<std::array<Index, 2>> found;
  if (first >= triangle.size()) return found;
  const auto box_of = [&](Index t) {
    const auto &[a, b, c] = triangle[t];
    return Box{position[a].cwiseMin(position[b]).cwiseMin(position[c]),
               position[a].cwiseMax(position[b]).cwiseMax(position[c]), t};
  };
  StopNowAndThen stop(1 << 13);
  Box whole = box_of(first);
  for (Index t = first; t < triangle.size(); ++t) {
    stop();
    const Box b = box_of(t);
    whole.low = whole.low.cwiseMin(b.low), whole.high = whole.high.cwiseMax(b.high);
  }
  Vec<Box> boxes;
  for (Index t = 0; t < triangle.size(); ++t) {
    stop();
    const Box b = box_of(t);
    if ((b.low.array() <= whole.high.array()).all() && (b.high.array() >= whole.low.array()).all()) boxes.push_back(b);
  }
  const Vec3 extent = whole.high - whole.low;
  Eigen::Index axis = 0;
  extent.maxCoeff(&axis);
  const Strips strips(boxes, whole, extent[(axis + 1) % 3] > extent[(axis + 2) % 3] ? (axis + 1) % 3 : (axis + 2) % 3);
  std::sort(boxes.begin(), boxes.end(), [&](const Box &a, const Box &b) {
    stop();
    return std::pair{a.low[axis], a.triangle} < std::pair{b.low[axis], b.triangle};
  });
  const TrianglePairs pairs(position, triangle);
  // Boxes that the sweep is in, in each strip: of what is from `first` on, and of the others, which are not asked of
  // each other.
  Vec<Vec<Box>> fresh(strips.count()), old(strips.count());
  const auto meet = [&](Vec<Box> &open, const Box &b, std::size_t strip) {
    std::size_t left = 0;
    for (std::size_t i = 0; i < open.size(); ++i) {
      stop();
      if (open[i].high[axis] < b.low[axis]) continue;
      if (left != i) open[left] = open[i];
      const Box &a = open[left++];
      // Two that are in several strips together meet in the first.
      if (apart(a, b) || std::max(strips.first(a), strips.first(b)) != strip) continue;
      if (pairs.cross(a.triangle, b.triangle))
        found.push_back({std::min(a.triangle, b.triangle), std::max(a.triangle, b.triangle)});
    }
    open.resize(left);
  };
  for (const Box &b : boxes) {
    const bool is_fresh = b.triangle >= first;
    for (std::size_t strip = strips.first(b); strip <= strips.last(b); ++strip) {
      stop();
      meet(fresh[strip], b, strip);
      if (is_fresh) meet(old[strip], b, strip);
      (is_fresh ? fresh : old)[strip].push_back(b);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace ts::tooth
