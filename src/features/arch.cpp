#include "features/arch.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/error.h"

namespace ts::features {
namespace {

constexpr double cell = 1.0;    // of the roughness map, mm
constexpr double blur = 2.5;    // of the map, mm: about half a tooth
constexpr double level = 0.04;  // |cv| of plain gingiva
constexpr int degrees = 360;
constexpr double least_radius = 6, radius_step = 0.5;
constexpr int radii = 109;                           // 6 to 60 mm
constexpr double smoothing = 4;                      // of the curve, mm
constexpr double extension = 6;                      // at each end, mm
constexpr double least_jaw = 16, greatest_jaw = 45;  // radii of arches, mm
constexpr double present = 0.12;                     // of the map's own maximum: where the curve ends

void blur_rows(Vec<double> &map, int width, int height, double sigma) {
  const int reach = static_cast<int>(std::ceil(3 * sigma));
  Vec<double> kernel(reach + 1), row(width);
  double sum = 0;
  for (int k = 0; k <= reach; ++k) sum += (k ? 2 : 1) * (kernel[k] = std::exp(-k * k / (2 * sigma * sigma)));
  for (double &k : kernel) k /= sum;
  for (int y = 0; y < height; ++y) {
    double *const line = map.data() + static_cast<std::size_t>(y) * width;
    for (int x = 0; x < width; ++x) {
      double value = 0;
      for (int k = std::max(-reach, -x); k <= std::min(reach, width - 1 - x); ++k)
        value += kernel[std::abs(k)] * line[x + k];
      row[x] = value;
    }
    std::copy(row.begin(), row.end(), line);
  }
}

struct Map {
  int width = 0, height = 0;
  Vec2 low;
  Vec<double> value;  // row by row

  double at(const Vec2 &p) const {
    const Vec2 q = (p - low) / cell - Vec2(0.5, 0.5);
    if (!(q.x() >= 0 && q.y() >= 0 && q.x() < width - 1 && q.y() < height - 1)) return 0;
    const int x = static_cast<int>(q.x()), y = static_cast<int>(q.y());
    const double a = q.x() - x, b = q.y() - y;
    const double *v = value.data() + static_cast<std::size_t>(y) * width + x;
    return (1 - b) * ((1 - a) * v[0] + a * v[1]) + b * ((1 - a) * v[width] + a * v[width + 1]);
  }
  Vec2 centre(int x, int y) const { return low + cell * Vec2(x + 0.5, y + 0.5); }
};

Map roughness_map(std::span<const geometry::Sample> samples, std::span<const double> convexity, double side,
                  const Plan &plan) {
  constexpr double margin = 4 * blur;
  constexpr double widest = 2000;  // cells; a surface of more than 2 m is no jaw
  Map map;
  Vec2 high;
  bool first = true;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (side * samples[i].normal.dot(plan.d) <= 0 || std::abs(convexity[i]) <= level) continue;
    const Vec2 p = plan.of(samples[i].position).head<2>();
    map.low = first ? p : Vec2(map.low.cwiseMin(p));
    high = first ? p : Vec2(high.cwiseMax(p));
    first = false;
  }
  if (first) throw Error(Fault::no_teeth, "nothing on the occlusal side is rough enough for a tooth");
  // A little more than the margin, so that the outermost samples, which make it, lie within a cell, not where two meet.
  map.low.array() -= margin + 1e-6 * cell;
  const Vec2 size = (high - map.low).array() + margin;
  if (size.maxCoeff() / cell > widest)
    throw Error(Fault::no_teeth, "the rough parts of the surface lie too far apart for a jaw");
  map.width = static_cast<int>(size.x() / cell) + 1;
  map.height = static_cast<int>(size.y() / cell) + 1;
  map.value.assign(static_cast<std::size_t>(map.width) * map.height, 0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double facing = side * samples[i].normal.dot(plan.d), excess = std::abs(convexity[i]) - level;
    if (facing <= 0 || excess <= 0) continue;
    const Vec2 q = (plan.of(samples[i].position).head<2>() - map.low) / cell;
    map.value[static_cast<std::size_t>(q.y()) * map.width + static_cast<std::size_t>(q.x())] +=
        samples[i].area * excess * facing;
  }
  blur_rows(map.value, map.width, map.height, blur / cell);
  Vec<double> turned(map.value.size());
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      turned[static_cast<std::size_t>(x) * map.height + y] = map.value[static_cast<std::size_t>(y) * map.width + x];
  blur_rows(turned, map.height, map.width, blur / cell);
  double most = 0;
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      most = std::max(most, map.value[static_cast<std::size_t>(y) * map.width + x] =
                                turned[static_cast<std::size_t>(x) * map.height + y]);
  for (double &v : map.value) v /= most;
  return map;
}

struct Circle {
  Vec2 centre;
  double radius;
};

// Weighted algebraic circle fit, and circles of a jaw's radius on either side of the row of teeth: a piece of an arch
// says too little about its centre.
Vec<Circle> circles(const Map &map) {
  double w = 0;
  Vec2 mean = Vec2::Zero();
  const auto each = [&](auto &&visit) {
    for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x)
        if (const double v = map.value[static_cast<std::size_t>(y) * map.width + x]; v > 2 * present)
          visit(map.centre(x, y), v * v);
  };
  each([&](const Vec2 &p, double v) { w += v, mean += v * p; });
  mean /= w;
  Eigen::Matrix2d moment = Eigen::Matrix2d::Zero();
  Vec2 third = Vec2::Zero();
  each([&](const Vec2 &p, double v) {
    const Vec2 q = p - mean;
    moment += v * q * q.transpose();
    third += v * q.squaredNorm() * q;
  });
  moment /= w;
  third /= w;
  Vec<Circle> result;
  const Vec2 offset = (moment + Eigen::Matrix2d::Identity()).inverse() * third / 2;
  const double radius = std::sqrt(offset.squaredNorm() + moment.trace());
  if (radius > least_jaw && radius < greatest_jaw) result.push_back({mean + offset, radius});
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>().computeDirect(moment);
  for (const double r : {22.0, 35.0})
    for (const double side : {1.0, -1.0}) {
      const double away = std::sqrt(std::max(0.0, r * r - moment.trace()));
      result.push_back({mean + side * away * axes.eigenvectors().col(0), r});
    }
  return result;
}

using Polar = Vec<std::array<double, radii>>;

Vec2 polar_point(const Vec2 &centre, int degree, double radius) {
  const double a = degree * std::numbers::pi / 180;
  return centre + radius * Vec2(std::cos(a), std::sin(a));
}

Polar polar_map(const Map &map, const Vec2 &centre) {
  Polar polar(degrees);
  for (int a = 0; a < degrees; ++a)
    for (int r = 0; r < radii; ++r) polar[a][r] = map.at(polar_point(centre, a, least_radius + radius_step * r));
  return polar;
}

// Middle of the 50 degrees with the least roughness.
int open_side(const Polar &polar) {
  constexpr int window = 50;
  Vec<double> sum(degrees, 0);
  for (int a = 0; a < degrees; ++a)
    for (const double v : polar[a]) sum[a] += v;
  int best = 0;
  double least = 0;
  for (int a = 0; a < degrees; ++a) {
    double total = 0;
    for (int k = 0; k < window; ++k) total += sum[(a + k) % degrees] + 1e-9 * std::abs(k - window / 2);
    if (a == 0 || total < least) least = total, best = a;
  }
  // several empty windows: the middle of the widest empty range
  int run = 0, widest = 0, middle = best + window / 2;
  for (int a = 0; a < 2 * degrees; ++a) {
    run = sum[a % degrees] < 1e-3 ? run + 1 : 0;
    if (run > widest && run <= degrees) widest = run, middle = a - run / 2;
  }
  return (widest > window ? middle : best + window / 2) % degrees;
}

// Best radius for each degree, beginning at the open side: most roughness on the way, few jumps.
Vec<int> ridge(const Polar &polar, int begin) {
  constexpr int jump = 5;
  constexpr double bend = 0.02;
  Polar best(degrees);
  Vec<std::array<signed char, radii>> from(degrees);
  for (int a = 0; a < degrees; ++a)
    for (int r = 0; r < radii; ++r) {
      double most = 0;
      int by = 0;
      if (a > 0) {
        most = -1e300;
        for (int j = -jump; j <= jump; ++j) {
          if (r + j < 0 || r + j >= radii) continue;
          const double s = best[a - 1][r + j] - bend * j * j;
          if (s > most) most = s, by = j;
        }
      }
      best[a][r] = most + polar[(begin + a) % degrees][r];
      from[a][r] = static_cast<signed char>(by);
    }
  Vec<int> path(degrees);
  path[degrees - 1] = static_cast<int>(std::max_element(best[degrees - 1].begin(), best[degrees - 1].end()) -
                                       best[degrees - 1].begin());
  for (int a = degrees - 1; a > 0; --a) path[a - 1] = path[a] + from[a][path[a]];
  return path;
}

Vec<Vec2> resample(const Vec<Vec2> &line, double step) {
  Vec<Vec2> result{line[0]};
  double left = step;
  for (std::size_t i = 1; i < line.size(); ++i) {
    Vec2 a = line[i - 1];
    const Vec2 &b = line[i];
    double length = (b - a).norm();
    while (length >= left) {
      a += (b - a) * (left / length);
      result.push_back(a);
      left = step;
      length = (b - a).norm();
    }
    left -= length;
  }
  return result;
}

// Along the arch, the ends mirrored at themselves so that they stay where they are.
Vec<Vec2> smooth(const Vec<Vec2> &line, double step) {
  const int n = static_cast<int>(line.size()), reach = static_cast<int>(3 * smoothing / step);
  const auto at = [&](int i) -> Vec2 {
    if (i < 0) return 2 * line[0] - line[std::min(-i, n - 1)];
    if (i >= n) return 2 * line[n - 1] - line[std::max(0, 2 * n - 2 - i)];
    return line[i];
  };
  Vec<Vec2> result(line.size());
  for (int i = 0; i < n; ++i) {
    Vec2 sum = Vec2::Zero();
    double weight = 0;
    for (int k = -reach; k <= reach; ++k) {
      const double w = std::exp(-std::pow(k * step / smoothing, 2) / 2);
      sum += w * at(i + k);
      weight += w;
    }
    result[i] = sum / weight;
  }
  return result;
}

void extend(Vec<Vec2> &line, double step) {
  const std::size_t n = line.size(), back = std::min<std::size_t>(n - 1, static_cast<std::size_t>(4 / step));
  const Vec2 head = (line[0] - line[back]).normalized() * step,
             tail = (line[n - 1] - line[n - 1 - back]).normalized() * step;
  Vec<Vec2> longer;
  const int more = static_cast<int>(extension / step);
  for (int k = more; k > 0; --k) longer.push_back(line[0] + k * head);
  longer.insert(longer.end(), line.begin(), line.end());
  for (int k = 1; k <= more; ++k) longer.push_back(line[n - 1] + k * tail);
  line.swap(longer);
}

// The ridge as seen from around a circle's centre, unsmoothed. Empty if there is none.
Vec<Vec2> trace(const Map &map, const Circle &circle, double step) {
  Vec2 centre = circle.centre;
  Polar polar = polar_map(map, centre);
  // From further back the two legs of the arch part better in angle.
  centre += 0.3 * circle.radius * polar_point(Vec2::Zero(), open_side(polar), 1);
  polar = polar_map(map, centre);
  const int begin = open_side(polar);
  const Vec<int> path = ridge(polar, begin);
  int first = degrees, last = -1;
  for (int a = 0; a < degrees; ++a)
    if (polar[(begin + a) % degrees][path[a]] > present) first = std::min(first, a), last = a;
  Vec<Vec2> line;
  for (int a = first; a <= last; ++a)
    line.push_back(polar_point(centre, begin + a, least_radius + radius_step * path[a]));
  if (line.size() < 3) return {};
  line = resample(line, step);
  if (static_cast<double>(line.size()) * step < 2) return {};
  return line;
}

// Roughness within 5 mm of a curve, each cell counted once, less a price a mm: a curve that doubles back gains nothing.
double worth(const Map &map, const Vec<Vec2> &line, double step) {
  constexpr double band = 5, price = 1;
  Vec<std::uint8_t> seen(map.value.size(), 0);
  double sum = 0;
  constexpr int reach = static_cast<int>(band / cell);
  const std::size_t stride = static_cast<std::size_t>(cell / step);
  for (std::size_t i = 0; i < line.size(); i += stride) {
    const Vec2 q = (line[i] - map.low) / cell;
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx) {
        const int x = static_cast<int>(q.x()) + dx, y = static_cast<int>(q.y()) + dy;
        if (x < 0 || y < 0 || x >= map.width || y >= map.height || dx * dx + dy * dy > reach * reach) continue;
        const std::size_t c = static_cast<std::size_t>(y) * map.width + x;
        if (!seen[c]) sum += map.value[c];
        seen[c] = 1;
      }
  }
  return sum - price * static_cast<double>(line.size()) * step;
}

}  // namespace

ArchCurve arch_curve(std::span<const geometry::Sample> samples, std::span<const double> convexity, bool inside_out,
                     const Plan &plan) {
  const Map map = roughness_map(samples, convexity, inside_out ? -1 : 1, plan);
  ArchCurve curve;
  Vec<Vec2> line;
  double best = 0;
  for (const Circle &circle : circles(map)) {
    Vec<Vec2> candidate = trace(map, circle, curve.step);
    if (candidate.empty()) continue;
    constexpr double clearly = 1.05;  // the first is the fit; others have to be better
    const double value = worth(map, candidate, curve.step);
    if (line.empty() || value > best + (clearly - 1) * std::abs(best)) best = value, line = std::move(candidate);
  }
  if (line.empty()) throw Error(Fault::no_teeth, "no row of teeth in plan view");
  curve.point = smooth(line, curve.step);
  extend(curve.point, curve.step);
  curve.point = resample(curve.point, curve.step);
  const std::size_t n = curve.point.size();
  curve.normal.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 t = (curve.point[std::min(n - 1, i + 1)] - curve.point[i ? i - 1 : 0]).normalized();
    curve.normal[i] = {-t.y(), t.x()};
  }
  return curve;
}

}  // namespace ts::features
