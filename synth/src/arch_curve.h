// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "vec3.h"

namespace tsa {

// The line of contacts in plan: y = -(a x^2 + b x^4), the quartic arch form. s is arc length from the midline, positive
// on the side of +x; t the distance from the line, positive outwards.
class ArchCurve {
 public:
  ArchCurve(double a, double b);

  struct Coordinates {
    double s, t;
  };
  Coordinates locate(double x, double y) const;
  Vec3 point(double s) const;
  Vec3 outward(double s) const;

 private:
  double parameter(double s) const;
  double nearest(double px, double py, double x) const;  // from x on
  double a_, b_;
  std::vector<double> length_;  // arc length at x = i * kStep
  std::vector<float> start_;    // x of the closest point, on a grid over the right half of the plan
};

}  // namespace tsa
