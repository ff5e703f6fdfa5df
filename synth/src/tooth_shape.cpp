// SPDX-License-Identifier: Apache-2.0
#include "tooth_shape.h"

#include <algorithm>

namespace tsa {

Profile::Profile(const std::vector<double> &at, const std::vector<double> &value) {
  const int n = static_cast<int>(at.size());
  const auto tangent = [&](int i) {
    const int a = i > 0 ? i - 1 : 0, b = i + 1 < n ? i + 1 : n - 1;
    return (value[b] - value[a]) / (at[b] - at[a]);
  };
  for (int s = 0; s <= kSteps; ++s) {
    const double tau = -1.2 + 2.4 * s / kSteps;
    int i = 0;
    while (i + 2 < n && tau > at[i + 1]) ++i;
    const double h = at[i + 1] - at[i], t = clamp01((tau - at[i]) / h);
    const double t2 = t * t, t3 = t2 * t;
    table_[s] = (2 * t3 - 3 * t2 + 1) * value[i] + (t3 - 2 * t2 + t) * h * tangent(i) +
                (3 * t2 - 2 * t3) * value[i + 1] + (t3 - t2) * h * tangent(i + 1);
  }
}

namespace {

// Of the free gingiva, mm: thickness at its edge, what that gains down to the neck, height of what goes straight on,
// depth of the neck below the edge, rounding of the edge; and how much the edge falls outwards from a right angle to
// the crown, mm a mm. They bring what bench_concavity finds towards two real scans of 0.3 mm edges: there the gum line
// is the valley (median concavity 1.9 to 3.3 a mm by kind of tooth and side, here 1.2 to 2.1: still the shallower) and
// the gingiva 0.8 to 2 mm below it is hardly concave (medians 0.01 to 0.03, here 0.00 to 0.03).
constexpr double kMarginThickness = 0.75, kThickening = 0.4, kFreeGingiva = 0.8, kNeck = 4.5, kMarginRounding = 0.8;
constexpr double kMarginFall = 0.4;

double elementHeight(const CapElement &e, double u, double v) {
  constexpr double kTipRadius = 0.35;
  const double du = e.u1 - e.u0, dv = e.v1 - e.v0, ll = du * du + dv * dv;
  const double t = ll > 0 ? clamp01(((u - e.u0) * du + (v - e.v0) * dv) / ll) : 0;
  const double x = u - e.u0 - t * du, y = v - e.v0 - t * dv;
  return e.h0 + t * (e.h1 - e.h0) - e.slope * (std::sqrt(x * x + y * y + kTipRadius * kTipRadius) - kTipRadius);
}

// The gauge g of the outline g^4 = X^4 + 2 k X^2 Y^2 + Y^4, g = 1: an ellipse for k = 1, nearly a rectangle for k = 0.
struct Outline {
  double gauge, distance;  // signed, to first order
};

Outline outline(double x, double y, double a, double b, double k) {
  const double xx = x * x, yy = y * y;
  const double g2 = std::sqrt(xx * xx + 2 * k * xx * yy + yy * yy);
  if (g2 < 1e-6) return {1e-3, -std::fmin(a, b)};
  const double g = std::sqrt(g2), g3 = g * g2;
  const double gx = x * (xx + k * yy) / (a * g3), gy = y * (yy + k * xx) / (b * g3);
  return {g, (g - 1) / std::sqrt(gx * gx + gy * gy)};
}

}  // namespace

double ToothShape::top(double u, double v) const {
  constexpr double kWarp = 0.38, kCell = 1.5;  // mm
  const Vec3 at = {u / kCell, v / kCell, 0.5};
  u += kWarp * smoothNoise(at, warpSeed);
  v += kWarp * smoothNoise(at, warpSeed + 1);
  double first = -1e3, second = -1e3, firstGroove = 0, secondGroove = 0;
  for (const CapElement &e : cap) {
    const double h = elementHeight(e, u, v);
    if (h > first) {
      second = first, secondGroove = firstGroove;
      first = h, firstGroove = e.groove;
    } else if (h > second) {
      second = h, secondGroove = e.groove;
    }
  }
  const double c = (first - second) / 0.4;
  return first - fissureDepth * firstGroove * secondGroove * std::exp(-c * c);
}

ToothShape::Plan ToothShape::plan(double u, double v, double tau) const {
  const double a = halfWidth(tau), vf = facial(tau), vl = lingual(tau);
  const double b = 0.5 * (vf + vl), y = (v - 0.5 * (vf - vl)) / b;
  const double x = (u - shear * v) / (a * (1 + taper * std::clamp(y, -1.2, 1.2)));
  const Outline o = outline(x, y, a, b, roundness(tau));
  return {x, y, o.gauge, o.distance};
}

bool ToothShape::isNear(double u, double v, double w) const {
  return w <= height + kReach && std::abs(u) <= 0.6 * md + kReach + 1 && std::abs(v) <= 0.62 * fl + kReach + 1.5;
}

double ToothShape::crown(double u, double v, double w, const Plan &plan) const {
  const double tau = w / height, y = plan.y;
  double side = plan.distance;
  if (fossaDepth > 0 && y < 0.2) {
    const double q = u / fossaWidth;
    side += fossaDepth * std::exp(-q * q * q * q) * smoothstep(0.2, -0.5, y) * smoothstep(0.3, 0.62, tau);
  }
  for (const SideGroove &g : grooves) {
    if (g.side * y <= 0) continue;
    const double q = (u - g.u) / g.width;
    if (q * q < 9)
      side += g.depth * std::exp(-q * q) * smoothstep(g.from, g.from + 0.45, tau) * smoothstep(0, 0.5, g.side * y);
  }
  if (tau <= 0.3 || side >= 1.5) return side;
  constexpr double kCapScale = 0.87;  // 1 / sqrt(1 + slope^2) at the usual cuspal incline
  return smoothMax(side, kCapScale * (w - top(u, v)), capBlend);
}

double ToothShape::crown(double u, double v, double w) const {
  if (!isNear(u, v, w)) return kFar;
  const Plan plan = this->plan(u, v, w / height);
  return plan.distance > kReach ? kFar : crown(u, v, w, plan);
}

ToothSample ToothShape::sample(double u, double v, double w) const {
  if (!isNear(u, v, w)) return {};
  const Plan plan = this->plan(u, v, w / height);
  if (plan.distance > kReach) return {};
  ToothSample s;
  s.crown = crown(u, v, w, plan);
  // The margin is the same all the way out from a place of the outline.
  const double xc = std::fmin(std::abs(plan.x) / plan.gauge, 1.25), yo = plan.y / plan.gauge;
  const double mid = gumLingual + (gumFacial - gumLingual) * smoothstep(-0.6, 0.6, yo);
  const double edge =
      mid + ((u > 0 ? papillaDistal : papillaMesial) - mid) * std::fmin(xc * xc * (0.6 + 0.4 * xc), 1.15);
  // The margin stands off the crown at the same angle whatever the slope of the crown there, and the free gingiva below
  // it goes straight on; only further down does it follow the narrower neck.
  const double below = edge - w, thickness = kMarginThickness + kThickening * smoothstep(0, kNeck, below);
  double contour = plan.distance, fall = kMarginFall;
  if (below > -3 && below < kNeck) {  // outside, what follows is without effect
    constexpr double kStep = 0.06;
    const double margin = this->plan(u, v, edge / height).distance;
    const double slope = (this->plan(u, v, edge / height + kStep).distance - margin) / (kStep * height);
    if (below > 0) contour = margin + (plan.distance - margin) * smoothstep(kFreeGingiva, kNeck, below);
    fall -= std::clamp(slope, -0.6, 1.5);
  }
  const double top = (fall * std::fmin(contour, 1.5) - below) / std::sqrt(1 + fall * fall);
  s.gum = smoothMax(contour - thickness, 0.9 * top, kMarginRounding);
  return s;
}

}  // namespace tsa
