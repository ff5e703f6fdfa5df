#include "tooth/arch_row.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.h"
#include "base/shown.h"

namespace ts::tooth {
namespace {

using Vec2 = Eigen::Vector2d;

// A right-handed plan seen from where the other jaw is: x to the right where y is up.
struct View {
  Vec3 x, y;

  explicit View(const Vec3 &occlusal) {
    int least = 0;
    for (int k = 1; k < 3; ++k)
      if (std::abs(occlusal[k]) < std::abs(occlusal[least])) least = k;
    x = Vec3::Unit(least).cross(occlusal).normalized();
    y = occlusal.cross(x);
  }
  Vec2 of(const Vec3 &p) const { return {p.dot(x), p.dot(y)}; }
};

double cross(const Vec2 &a, const Vec2 &b) {
  return a.x() * b.y() - a.y() * b.x();
}

// A line in plan, by length from its beginning.
class Curve {
 public:
  explicit Curve(Vec<Vec2> points) : point_(std::move(points)) {
    at_.assign(point_.size(), 0);
    for (std::size_t i = 1; i < point_.size(); ++i) at_[i] = at_[i - 1] + (point_[i] - point_[i - 1]).norm();
  }

  double length() const { return at_.back(); }

  // The first and the last piece go on for ever.
  Vec2 point(double s) const {
    if (point_.size() < 2) return point_.front() + Vec2(s, 0);
    const auto next = std::upper_bound(at_.begin() + 1, at_.end() - 1, s) - at_.begin();
    const auto i = static_cast<std::size_t>(next);
    const double piece = at_[i] - at_[i - 1];
    return piece > 0 ? Vec2(point_[i - 1] + (s - at_[i - 1]) / piece * (point_[i] - point_[i - 1])) : point_[i];
  }
  // Over a stretch as long as a tooth, which the unevenness of the curve does not turn.
  Vec2 tangent(double s) const {
    constexpr double half = 4;
    const Vec2 way = point(s + half) - point(s - half);
    return way.norm() > 0 ? Vec2(way.normalized()) : Vec2(1, 0);
  }
  double nearest(const Vec2 &q) const {
    double best = 0, least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < point_.size(); ++i) {
      const Vec2 way = point_[i] - point_[i - 1];
      double t = way.squaredNorm() > 0 ? (q - point_[i - 1]).dot(way) / way.squaredNorm() : 0;
      t = std::clamp(t, i == 1 ? -1e3 : 0.0, i + 1 == point_.size() ? 1e3 : 1.0);
      const double away = (point_[i - 1] + t * way - q).squaredNorm();
      if (away < least) least = away, best = at_[i - 1] + t * (at_[i] - at_[i - 1]);
    }
    return best;
  }

  // Seen from above, + to the left. An arc of a sixth of its length deep has .11; a line of teeth that is straight to a
  // twentieth of that tells nothing.
  Turn turn() const {
    double area = 0;
    for (std::size_t i = 1; i < point_.size(); ++i) area += cross(point_[i - 1] - point_[0], point_[i] - point_[0]) / 2;
    const double bend = area / (length() * length());
    return !(std::abs(bend) > 0.01) ? Turn::unknown : bend > 0 ? Turn::left : Turn::right;
  }

 private:
  Vec<Vec2> point_;
  Vec<double> at_;
};

// How symmetric the curve is about each of its points, as log-probabilities: mean squared distance between one side and
// the best mirror image of the other, up to 40 mm from the point.
void add_midlines(const Curve &curve, ArchRow &row) {
  constexpr double reach = 40, least_reach = 15, unevenness = 0.6, unsure = 0.05;
  constexpr int outside = 30;  // an arch of one quadrant has its midline before its beginning or after its end
  // Far more than any jaw has: what a mesh of other units, or a session file, has beyond it would be looked at all the
  // same.
  constexpr double longest = 1000;
  const int length = static_cast<int>(std::min(longest, curve.length()));
  row.midline_from = -outside;
  row.midline.assign(static_cast<std::size_t>(length) + 2 * outside + 1, 0);
  double sum = 0;
  for (int s = 0; s <= length; ++s) {
    const double sides = std::min({reach, static_cast<double>(s), curve.length() - s});
    if (sides < least_reach) continue;
    const int n = static_cast<int>(sides);
    Vec2 before = Vec2::Zero(), after = Vec2::Zero();
    for (int k = 1; k <= n; ++k) before += curve.point(s - k), after += curve.point(s + k);
    before /= n, after /= n;
    double same = 0, turned = 0, size = 0;
    for (int k = 1; k <= n; ++k) {
      const Vec2 a = curve.point(s - k) - before, b = curve.point(s + k) - after;
      same += a.x() * b.x() - a.y() * b.y();
      turned += a.y() * b.x() + a.x() * b.y();
      size += a.squaredNorm() + b.squaredNorm();
    }
    const double off = std::max(0.0, size - 2 * std::hypot(same, turned)) / n;
    sum += row.midline[static_cast<std::size_t>(s) + outside] = std::exp(-off / (2 * unevenness * unevenness));
  }
  const double inside = length + 1;
  for (int i = 0; double &m : row.midline) {
    const bool on = i >= outside && i <= outside + length;
    ++i;
    if (!(sum > 0))
      m = std::log(1.0 / static_cast<double>(row.midline.size()));
    else
      m = on ? std::log((1 - unsure) * m / sum + unsure / inside) : -std::numeric_limits<double>::infinity();
  }
}

// Width and depth of a crown: the sides of the smallest box around it in plan, turned against the arch by as much as
// teeth are.
void measure_crown(const mesh::Surface &surface, const Tooth &tooth, const View &view, const Curve &curve,
                   ArchTooth &t) {
  Vec<Vec2> plan;
  Vec2 centre = Vec2::Zero();
  for (const Index v : tooth.vertices) centre += plan.emplace_back(view.of(surface.position[v]));
  if (plan.empty()) return;
  const Vec2 tangent = curve.tangent(curve.nearest(centre / static_cast<double>(plan.size())));
  double least = std::numeric_limits<double>::infinity();
  for (const int degrees : {0, 5, -5, 10, -10, 15, -15, 20, -20, 25, -25, 30, -30}) {
    const Vec2 along = Eigen::Rotation2Dd(degrees * std::numbers::pi / 180) * tangent, over(-along.y(), along.x());
    Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Vec2 &p : plan) {
      const Vec2 q(p.dot(along), p.dot(over));
      low = low.cwiseMin(q), high = high.cwiseMax(q);
    }
    const Vec2 side = high - low, middle = (low + high) / 2;
    if (side.x() * side.y() >= least) continue;
    least = side.x() * side.y();
    t.width = side.x(), t.depth = side.y();
    t.at = curve.nearest(middle.x() * along + middle.y() * over);
  }
  t.crown = true;
}

void measure_group(const features::Group &group, const View &view, const Curve &curve, ArchTooth &t) {
  Vec2 centre = Vec2::Zero();
  for (const features::Point &p : group.points) centre += view.of(p.position);
  const bool stretch = group.to > group.from;
  if (!group.points.empty()) {
    centre /= static_cast<double>(group.points.size());
    const Vec2 tangent = curve.tangent(curve.nearest(centre)), over(-tangent.y(), tangent.x());
    const auto [low, high] =
        std::ranges::minmax(group.points, {}, [&](const features::Point &p) { return view.of(p.position).dot(over); });
    t.across = (view.of(high.position) - view.of(low.position)).dot(over);
    t.at = curve.nearest(centre);
  }
  if (stretch) t.at = (group.from + group.to) / 2, t.width = group.to - group.from;
}

Vec3 centre_of(const mesh::Surface &surface, const RowTooth &t) {
  Vec3 sum = Vec3::Zero();
  if (t.group && !t.group->points.empty()) {
    for (const features::Point &p : t.group->points) sum += p.position;
    return sum / static_cast<double>(t.group->points.size());
  }
  for (const Index v : t.tooth->vertices) sum += surface.position[v];
  return sum / static_cast<double>(t.tooth->vertices.size());
}

}  // namespace

ArchRow arch_row(const mesh::Surface &surface, const features::Features &features, std::span<const RowTooth> teeth) {
  ArchRow row;
  if (teeth.empty()) return row;
  if (features.occlusal.isZero())
    throw Error(Fault::invalid_argument, "the features have no occlusal direction: set it before the segmentation");
  const View view(features.occlusal);
  Vec<Vec2> line;
  for (const Vec3 &p : features.arch) line.push_back(view.of(p));
  if (line.size() < 2) {
    line.clear();
    for (const RowTooth &t : teeth) line.push_back(view.of(centre_of(surface, t)));
  }
  const Curve curve(std::move(line));
  // It is gone along millimetre by millimetre.
  constexpr double longest = 1000;  // mm: arches are up to 180
  if (!(curve.length() <= longest))
    throw Error(Fault::invalid_argument,
                "the line along the teeth is " + shown(curve.length()) + " mm long: no arch is");
  for (const RowTooth &t : teeth) {
    ArchTooth &own = row.teeth.emplace_back();
    if (t.group) measure_group(*t.group, view, curve, own);
    if (t.tooth) measure_crown(surface, *t.tooth, view, curve, own);
  }
  row.turn = curve.turn();
  add_midlines(curve, row);
  return row;
}

}  // namespace ts::tooth
