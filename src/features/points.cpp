#include "features/points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ts::features {
namespace {

// mm and dimensionless; findings, section 2.7.
constexpr double apart = 1.8;                                // radius of a local maximum
constexpr double convexity_in_mm = 4;                        // of height that convexity counts for
constexpr double least_convexity = 0.15, least_share = 0.5;  // absolute, and of the tooth's largest
constexpr double below_top = 3.5;
constexpr double from_rim = 1.5, from_cut = 0.8;
constexpr unsigned least_points = 3;

struct Candidate {
  int slice, j;
  float height, convexity;
  Vec2 at;
  double value() const { return height + convexity_in_mm * convexity; }
};

bool near_rim(const Strip &strip, int slice, int j) {
  constexpr int r = static_cast<int>(from_rim / Strip::step);
  for (int k = 0; k < 8; ++k) {
    const double a = k * std::numbers::pi / 4;
    const int i = slice + static_cast<int>(std::lround(r * std::cos(a))),
              l = j + static_cast<int>(std::lround(r * std::sin(a)));
    if (i < 0 || i >= strip.slices || l < 0 || l >= Strip::across || std::isnan(strip.height[strip.at(i, l)]))
      return true;
  }
  return false;
}

// Cells of the span, off its cuts, off the rims, high and convex enough.
Vec<Candidate> candidates(const Strip &strip, const ToothSpan &tooth, const Ridge *ridge) {
  Vec<Candidate> all;
  for (const std::size_t c : span_cells(strip, tooth, from_cut)) {
    const int i = static_cast<int>(c / Strip::across), j = static_cast<int>(c % Strip::across);
    if (strip.convexity[c] > 0.5 * least_convexity && (!ridge || ridge->has(c)) && !near_rim(strip, i, j))
      all.push_back({i, j, strip.height[c], strip.convexity[c], strip.plan_point(i, Strip::t(j))});
  }
  if (all.empty()) return all;
  // The crown lies near the curve: what is higher further out (a neighbour's leg, cheek) is not its top.
  float top = -1e9f, most = 0;
  for (const Candidate &c : all) {
    if (std::abs(Strip::t(c.j)) > 6) continue;
    top = std::max(top, c.height);
    most = std::max(most, c.convexity);
  }
  const double enough = std::max(least_convexity, least_share * most);
  std::erase_if(all, [&](const Candidate &c) { return c.convexity < enough || c.height < top - below_top; });
  return all;
}

Vec<Candidate> choose(const Vec<Candidate> &all, unsigned most) {
  Vec<Candidate> chosen;
  // Local maxima, highest first: what has a higher cell beside it is none, which settles nearly all of them at once.
  Vec<std::size_t> order(all.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return all[a].value() > all[b].value(); });
  int first = 1 << 30, last = 0;
  for (const Candidate &c : all) first = std::min(first, c.slice), last = std::max(last, c.slice);
  if (all.empty()) return chosen;
  constexpr std::size_t row = Strip::across + 2;
  Vec<std::uint8_t> seen(row * static_cast<std::size_t>(last - first + 3), 0);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Candidate &c = all[order[k]];
    const std::size_t at = static_cast<std::size_t>(c.slice - first + 1) * row + c.j + 1;
    bool below = false;
    for (std::size_t i = 0; i < 3 && !below; ++i)
      for (std::size_t j = 0; j < 3; ++j) below |= seen[at - row - 1 + i * row + j] != 0;
    seen[at] = 1;
    for (std::size_t h = 0; h < k && !below; ++h) below = (all[order[h]].at - c.at).squaredNorm() <= apart * apart;
    if (!below) chosen.push_back(c);
  }
  if (chosen.size() > most) chosen.resize(most);
  // An incisal edge is one long maximum: its far ends join.
  while (!chosen.empty() && chosen.size() < std::min(least_points, most)) {
    const Candidate *best = nullptr;
    double farthest = apart / 2;
    for (const Candidate &c : all) {
      double nearest = 1e9;
      for (const Candidate &o : chosen) nearest = std::min(nearest, (o.at - c.at).norm());
      if (nearest > farthest) farthest = nearest, best = &c;
    }
    if (!best) break;
    chosen.push_back(*best);
  }
  return chosen;
}

}  // namespace

Vec<Point> tooth_points(const mesh::Surface &surface, const Strip &strip, const TopView &view, const Plan &plan,
                        const ToothSpan &tooth, unsigned most, const Ridge *ridge) {
  Vec<Point> points;
  for (const Candidate &c : choose(candidates(strip, tooth, ridge), most)) {
    const Index face = view.face(c.at);
    if (face == mesh::none) continue;
    Point p;
    p.position = plan.back({c.at.x(), c.at.y(), c.height});
    double nearest = 0;
    for (const Index v : surface.triangle[face])
      if (const double d = (surface.position[v] - p.position).squaredNorm(); p.vertex == mesh::none || d < nearest)
        nearest = d, p.vertex = v;
    p.convexity = c.convexity;
    points.push_back(p);
  }
  return points;
}

}  // namespace ts::features
