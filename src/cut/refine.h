// Moves the border of a region, within a band, to the cheapest line along the seams: a minimum cut on faces.
#pragma once

#include "cut/region.h"

namespace ts::cut {

struct RefineOptions {
  double band = 1.5;  // mm, either side
};

// A face keeps to its side with 0.1 |phi| area (phi the mean of its corners, about -1 deep inside to 1 far outside); an
// edge between faces of different sides costs |e| (0.02 + 0.98 / (1 + (c / 0.1)^2)), c the concavity of its ends.
// `fixed` (a vertex): 1 = its faces must be inside, 2 = outside, 0 = free.
void refine(const Surface &surface, std::span<const double> phi, std::span<const double> concavity,
            std::span<const std::uint8_t> fixed, const RefineOptions &options, Mask &inside);

}  // namespace ts::cut
