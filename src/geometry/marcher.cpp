#include "geometry/marcher.h"

#include <cmath>

namespace ts::geometry {
namespace {

// The distance at c of a straight front with da at a and db at b; infinite where it does not come through the triangle.
double across(const Vec3 &c, const Vec3 &a, double da, const Vec3 &b, double db) {
  const Vec3 p = a - c, q = b - c;
  const double pp = p.dot(p), pq = p.dot(q), qq = q.dot(q), det = pp * qq - pq * pq;
  constexpr double kNone = std::numeric_limits<double>::infinity();
  if (!(det > 0) || pq < 0) return kNone;
  // |grad| = 1: one t^2 - 2 mixed t + two - 1 = 0 with the inverse of the Gram matrix of p and q.
  const double one = (qq - 2 * pq + pp) / det;
  const double mixed = (da * (qq - pq) + db * (pp - pq)) / det;
  const double two = (da * da * qq - 2 * da * db * pq + db * db * pp) / det;
  const double root = mixed * mixed - one * (two - 1);
  if (!(root >= 0)) return kNone;
  const double t = (mixed + std::sqrt(root)) / one;
  const double from_a = qq * (da - t) - pq * (db - t), from_b = pp * (db - t) - pq * (da - t);
  return from_a <= 0 && from_b <= 0 ? t : kNone;
}

// The same of a round one: the distance from where circles of da around a and of db around b meet beyond the edge.
double around(const Vec3 &c, const Vec3 &a, double da, const Vec3 &b, double db) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const double l = (b - a).norm();
  if (!(l > 0)) return kNone;
  const double x = (da * da - db * db + l * l) / (2 * l), y = std::sqrt(std::max(0.0, da * da - x * x));
  const double cx = (c - a).dot(b - a) / l, cy = std::sqrt(std::max(0.0, (c - a).squaredNorm() - cx * cx));
  if (!(y + cy > 0)) return kNone;
  const double through = x + (cx - x) * y / (y + cy), d = std::hypot(cx - x, cy + y);
  return through >= 0 && through <= l && d >= std::max(da, db) ? d : kNone;
}

}  // namespace

void Marcher::begin(Front front) {
  front_ = front;
  if (stamp_.empty()) {
    distance_.resize(surface_->vertices());
    stamp_.assign(surface_->vertices(), 0);
  }
  if (open_ >= UINT32_MAX - 3) std::fill(stamp_.begin(), stamp_.end(), 0), open_ = 0;
  open_ += 2;
  heap_.clear();
}

void Marcher::offer(Index v, double d) {
  if (settled(v) || (stamp_[v] == open_ && !(d < distance_[v]))) return;
  stamp_[v] = open_;
  distance_[v] = d;
  heap_.push_back({d, v});
  std::push_heap(heap_.begin(), heap_.end());
}

void Marcher::spread(Index v) {
  const Surface &s = *surface_;
  for (const Index e : s.vertex_edges[v])
    if (const Index w = s.other_end(e, v); !settled(w)) offer(w, distance_[v] + s.edge_length(e));
  for (const Index f : s.vertex_faces[v])
    for (const Index w : s.triangle[f]) {
      if (w == v || settled(w)) continue;
      const auto &t = s.triangle[f];
      const Index third = t[0] != v && t[0] != w ? t[0] : t[1] != v && t[1] != w ? t[1] : t[2];
      if (!settled(third)) continue;
      const double d = (front_ == Front::round ? around : across)(s.position[w], s.position[v], distance_[v],
                                                                  s.position[third], distance_[third]);
      if (d < std::numeric_limits<double>::infinity()) offer(w, d);
    }
}

}  // namespace ts::geometry
