// SPDX-License-Identifier: Apache-2.0
#include "contacts.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tsa {
namespace {

// How deep two crowns may share: the most that neighbours do in an arch without crowding.
constexpr double kDeepest = 0.1;
constexpr double kProbe = 0.3;
constexpr int kRounds = 40;

// How deep the point of both crowns that is deepest lies in the shallower, and the direction in plan out of the first
// into the second there.
struct Overlap {
  double depth = 0;
  Vec3 direction{0, 0, 0};
};

double depthIn(const PlacedTooth &t, Vec3 p) {
  const Vec3 q = t.local(p);
  if (q.z < 0 || q.z > 1.1 * t.shape.height || std::abs(q.x) > 0.6 * t.shape.md) return -1;
  return -t.shape.crown(q.x, q.y, q.z);
}

std::vector<double> probes(double from, double to) {
  std::vector<double> at;
  while (from <= to) at.push_back(from), from += kProbe;
  return at;
}

Overlap overlap(const PlacedTooth &a, const PlacedTooth &b) {
  Overlap found;
  Vec3 at{0, 0, 0};
  const double u = 0.6 * a.shape.md, v = 0.7 * a.shape.fl;
  const std::vector<double> xs = probes(-u, u), ys = probes(-v, v), zs = probes(0, a.shape.height);
  for (const double z : zs)
    for (const double y : ys)
      for (const double x : xs) {
        const Vec3 p = a.world(x, y, z);
        const double inB = depthIn(b, p);
        if (inB <= found.depth) continue;
        if (const double both = std::min(inB, depthIn(a, p)); both > found.depth) found.depth = both, at = p;
      }
  if (found.depth <= 0) return found;
  const auto rise = [&](Vec3 d) {
    return depthIn(b, at + d) - depthIn(b, at - d) - depthIn(a, at + d) + depthIn(a, at - d);
  };
  const Vec3 out{rise({kProbe, 0, 0}), rise({0, kProbe, 0}), 0};
  if (const double length = std::sqrt(dot(out, out)); length > 0) found.direction = (1 / length) * out;
  return found;
}

}  // namespace

void moveApart(std::vector<PlacedTooth> &teeth) {
  constexpr size_t kNear = 2;  // places between which crowns may meet
  std::vector<int> moves(teeth.size(), 0);
  // By the first tooth and how far on the second is: how often the two had moved when they were found apart.
  std::vector<std::array<int, kNear>> apart(teeth.size(), {-1, -1});
  for (int round = 0; round < kRounds; ++round) {
    bool moved = false;
    for (size_t i = 0; i + 1 < teeth.size(); ++i)
      for (size_t j = i + 1; j < std::min(i + 1 + kNear, teeth.size()); ++j) {
        int &known = apart[i][j - i - 1];
        if (known == moves[i] + moves[j]) continue;
        const Overlap o = overlap(teeth[i], teeth[j]);
        if (o.depth <= kDeepest) {
          known = moves[i] + moves[j];
          continue;
        }
        const Vec3 step = (o.depth - 0.8 * kDeepest) * o.direction;
        teeth[i].origin = teeth[i].origin - step;
        teeth[j].origin = teeth[j].origin + step;
        ++moves[i], ++moves[j];
        moved = true;
      }
    if (!moved) return;
  }
}

}  // namespace tsa
