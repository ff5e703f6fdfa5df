// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "random.h"
#include "vec3.h"

namespace tsa {

// A tooth in its own frame: u distal, v facial (labial or buccal), w occlusal along the long axis, w = 0 at the
// cervical line. Its field is negative inside and about the distance in mm near the surface.

// The chewing surface is the upper envelope of these: cones for cusps, ridges for cusp arms, incisal edges and marginal
// ridges. Where two meet they leave a valley, as the lobes of a developing crown leave its grooves.
struct CapElement {
  double u0, v0, h0, u1, v1, h1;
  double slope;
  double groove;  // share of the fissure depth that it cuts towards its neighbours
};

// A vertical groove on the facial (side > 0) or lingual wall.
struct SideGroove {
  double u, side, width, depth, from;
};

struct Tip {
  double u, v;
  uint32_t kind;
};

// A curve over the relative height w / crown height in [-1.2, 1.2].
class Profile {
 public:
  Profile() = default;
  Profile(const std::vector<double> &at, const std::vector<double> &value);
  double operator()(double tau) const {
    const double x = (tau + 1.2) * (kSteps / 2.4);
    if (x <= 0) return table_[0];
    if (x >= kSteps) return table_[kSteps];
    const int i = static_cast<int>(x);
    return table_[i] + (x - i) * (table_[i + 1] - table_[i]);
  }

 private:
  static constexpr int kSteps = 192;
  std::array<double, kSteps + 1> table_{};
};

constexpr double kFar = 1e3;

struct ToothSample {
  double crown = kFar;
  double gum = kFar;  // the gingiva that clings to this tooth
};

struct ToothShape {
  double height = 0, md = 0, fl = 0, flCervix = 0;
  Profile halfWidth, facial, lingual, roundness;
  double taper = 0, shear = 0;
  std::vector<CapElement> cap;
  std::vector<SideGroove> grooves;
  std::vector<Tip> tips;
  double fissureDepth = 0, capBlend = 0.9;
  uint32_t warpSeed = 0;  // makes grooves meander
  double fossaDepth = 0, fossaWidth = 1;
  double gumFacial = 0, gumLingual = 0, papillaMesial = 0, papillaDistal = 0;
  double contactV = 0, contactW = 0;

  double top(double u, double v) const;
  ToothSample sample(double u, double v, double w) const;
  // Of the sample the crown alone.
  double crown(double u, double v, double w) const;
  // Beyond this the sample says kFar: further than any blend reaches.
  static constexpr double kReach = 3.6;

 private:
  // In the section at a relative height: place relative to the half axes, and distance from the outline.
  struct Plan {
    double x, y, gauge, distance;  // gauge: 1 on the outline
  };
  Plan plan(double u, double v, double tau) const;
  bool isNear(double u, double v, double w) const;
  double crown(double u, double v, double w, const Plan &plan) const;
};

// The tooth at `position` 1 to 7 of a quadrant; its size and form vary a little with `random`.
ToothShape makeTooth(bool upper, int position, Random &random);

}  // namespace tsa
