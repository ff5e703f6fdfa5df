#include "tooth/crossings.h"

#include <algorithm>
#include <numeric>

#include "base/stop.h"

namespace ts::tooth {
namespace {

// Above which side of a plane: 0 on it, as far as rounding tells.
constexpr double kFlat = 1e-14;
int orient(const Vec3 &a, const Vec3 &b, const Vec3 &c, const Vec3 &d) {
  const Vec3 u = a - d, v = b - d, w = c - d;
  const double volume = u.dot(v.cross(w)), least = kFlat * u.norm() * v.norm() * w.norm();
  return volume > least ? 1 : volume < -least ? -1 : 0;
}

// Whether the segment from p to q goes through the triangle, or ends on it.
bool pierces(const Vec3 &p, const Vec3 &q, const Vec3 &a, const Vec3 &b, const Vec3 &c) {
  const int from = orient(a, b, c, p), to = orient(a, b, c, q);
  if (from == to || from * to > 0) return false;  // an end that lies on it counts
  const int u = orient(p, q, a, b), v = orient(p, q, b, c), w = orient(p, q, c, a);
  return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

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
  // A side of the first that has no corner in common with the second goes through it.
  bool through(const Triangle &sides, const Triangle &b) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index p = sides[k], q = sides[(k + 1) % 3];
      if (std::ranges::find(b, p) != b.end() || std::ranges::find(b, q) != b.end()) continue;
      if (pierces(position_[p], position_[q], position_[b[0]], position_[b[1]], position_[b[2]])) return true;
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
  struct Box {
    Vec3 low, high;
    Index triangle;
  };
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
  Eigen::Index axis = 0;
  (whole.high - whole.low).maxCoeff(&axis);
  std::sort(boxes.begin(), boxes.end(), [&](const Box &a, const Box &b) {
    stop();
    return std::pair{a.low[axis], a.triangle} < std::pair{b.low[axis], b.triangle};
  });
  const TrianglePairs pairs(position, triangle);
  Vec<std::size_t> open;  // boxes that the sweep is in
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    stop();
    const Box &b = boxes[i];
    std::erase_if(open, [&](std::size_t k) { return boxes[k].high[axis] < b.low[axis]; });
    for (const std::size_t k : open) {
      stop();
      const Box &a = boxes[k];
      if (a.triangle < first && b.triangle < first) continue;
      if ((a.low.array() > b.high.array()).any() || (a.high.array() < b.low.array()).any()) continue;
      if (pairs.cross(a.triangle, b.triangle))
        found.push_back({std::min(a.triangle, b.triangle), std::max(a.triangle, b.triangle)});
    }
    open.push_back(i);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace ts::tooth
