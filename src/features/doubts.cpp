#include "features/doubts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ts::features {
namespace {

constexpr double kPlain = 0.04;    // |cv| of plain gingiva
constexpr double kSideways = 0.3;  // n . d of what faces neither way
constexpr double kNear = 14;       // mm from the curve

// Between what was measured on the 18 real scans, and on nine pairs of them and of synthetic arches put into one file.
// One jaw: at most .324 (a print model whose base has sharp rims; the next .043). Two in occlusion: at least .520.
constexpr double kMostOpposed = 0.41;
// One jaw: at least .904 (a study model on a base; the next .990). Side by side: at most .848.
constexpr double kLeastCovered = 0.88;
// mm. One jaw: at most 178 (the same study model; the next 154). Back to back, where the curve runs round both: 234.
constexpr double kLongest = 205;

}  // namespace

Looks looks_of(std::span<const geometry::Sample> samples, std::span<const double> convexity,
               const Orientation &orientation, const ArchCurve &curve, const Plan &plan) {
  const double side = orientation.inside_out ? -1 : 1;
  const std::size_t stride = static_cast<std::size_t>(1 / curve.step);  // of the curve's points: one a mm
  double with = 0, against = 0, all = 0, near = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double rough = samples[i].area * (std::abs(convexity[i]) - kPlain);
    if (!(rough > 0)) continue;
    const double facing = side * samples[i].normal.dot(plan.d);
    if (facing > kSideways) with += rough;
    if (facing < -kSideways) against += rough;
    if (!(facing > 0)) continue;  // the curve is the ridge of what faces the other jaw
    const Vec2 p = plan.of(samples[i].position).head<2>();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < curve.point.size(); k += stride)
      least = std::min(least, (curve.point[k] - p).squaredNorm());
    all += rough * facing;
    if (least < kNear * kNear) near += rough * facing;
  }
  Looks looks;
  looks.opposed = against > with ? 1 : with > 0 ? against / with : 0;
  looks.coverage = all > 0 ? near / all : 1;
  looks.length = curve.step * static_cast<double>(curve.point.size() - 1);
  if (orientation.inside_out) looks.warnings |= Doubt::inside_out;
  if (looks.opposed > kMostOpposed) looks.warnings |= Doubt::opposed;
  if (looks.coverage < kLeastCovered || looks.length > kLongest) looks.warnings |= Doubt::several_arches;
  return looks;
}

}  // namespace ts::features
