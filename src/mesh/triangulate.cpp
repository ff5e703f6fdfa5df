#include "mesh/triangulate.h"

#include <algorithm>

#include "base/stop.h"

namespace ts::mesh {

bool Triangulator::operator()(std::span<const Vec3> position, std::span<const Index> polygon, Vec<Triangle> &out) {
  vertex_.clear();
  for (const Index v : polygon)
    if (vertex_.empty() || vertex_.back() != v) vertex_.push_back(v);
  while (vertex_.size() > 1 && vertex_.back() == vertex_.front()) vertex_.pop_back();
  if (vertex_.size() < 3 || !flatten(position)) return true;
  if (is_convex()) {
    for (std::size_t i = 1; i + 1 < vertex_.size(); ++i) out.push_back({vertex_[0], vertex_[i], vertex_[i + 1]});
    return true;
  }
  if (vertex_.size() > most_concave_corners) return false;
  clip(out);
  return true;
}

// Newell's normal is the best plane of a polygon that is not quite flat.
bool Triangulator::flatten(std::span<const Vec3> position) {
  const std::size_t n = vertex_.size();
  const Vec3 &origin = position[vertex_[0]];
  Vec3 normal(0, 0, 0);
  double size = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 a = position[vertex_[i]] - origin, b = position[vertex_[(i + 1) % n]] - origin;
    normal += a.cross(b);
    size = std::max(size, a.squaredNorm());
  }
  flat_ = 1e-12 * size;
  if (normal.norm() <= flat_) return false;
  normal.normalize();
  Eigen::Index smallest = 0;
  normal.cwiseAbs().minCoeff(&smallest);
  const Vec3 x = normal.cross(Vec3::Unit(smallest)).normalized(), y = normal.cross(x);
  point_.resize(n);
  before_.resize(n);
  after_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 p = position[vertex_[i]] - origin;
    point_[i] = {p.dot(x), p.dot(y)};
    before_[i] = static_cast<Index>((i + n - 1) % n);
    after_[i] = static_cast<Index>((i + 1) % n);
  }
  return true;
}

// All turns to the left, and going round once only: the direction of the sides passes the x axis twice. A fan needs
// true turns, or it would make triangles without area.
bool Triangulator::is_convex() const {
  int passes = 0;
  for (Index i = 0; i < vertex_.size(); ++i) {
    if (turn(i) <= flat_) return false;
    const Vec2 in = point_[i] - point_[before_[i]], out = point_[after_[i]] - point_[i];
    passes += (in.y() < 0) != (out.y() < 0);
  }
  return passes == 2;
}

double Triangulator::turn(Index i) const {
  const Vec2 a = point_[i] - point_[before_[i]], b = point_[after_[i]] - point_[i];
  return a.x() * b.y() - a.y() * b.x();
}

bool Triangulator::is_ear(Index i) const {
  if (turn(i) <= flat_) return false;
  const Vec2 a = point_[before_[i]], b = point_[i], c = point_[after_[i]];
  const auto left = [](const Vec2 &p, const Vec2 &q, const Vec2 &r) {
    return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x()) >= 0;
  };
  for (Index j = after_[after_[i]]; j != before_[i]; j = after_[j]) {
    const Vec2 &p = point_[j];
    if (p == a || p == b || p == c) continue;  // where a polygon touches itself
    if (left(a, b, p) && left(b, c, p) && left(c, a, p)) return false;
  }
  return true;
}

void Triangulator::clip(Vec<Triangle> &out) {
  Vec<std::uint8_t> ear(vertex_.size());
  StopNowAndThen stop(1 << 6);
  for (Index i = 0; i < vertex_.size(); ++i, stop()) ear[i] = is_ear(i);
  std::size_t left = vertex_.size();
  Index i = 0;
  for (std::size_t tried = 0; left > 3;) {
    // A polygon that crosses itself may have no ear: any true turn serves, and at last any corner.
    const bool take = ear[i] || (tried > left && turn(i) > flat_) || tried > 2 * left;
    if (!take) {
      i = after_[i];
      ++tried;
      continue;
    }
    stop();
    const Index p = before_[i], n = after_[i];
    out.push_back({vertex_[p], vertex_[i], vertex_[n]});
    after_[p] = n;
    before_[n] = p;
    --left;
    tried = 0;
    ear[p] = is_ear(p);
    ear[n] = is_ear(n);
    i = after_[n];  // not the next corner: a fan of slivers would come of it
  }
  out.push_back({vertex_[before_[i]], vertex_[i], vertex_[after_[i]]});
}

}  // namespace ts::mesh
