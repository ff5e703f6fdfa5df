// The component rule: at which level of a tooth's field it is best cut.
#pragma once

#include <limits>

#include "cut/space.h"
#include "tooth/prepared.h"

namespace ts::tooth {

// Levels of 1 - the tooth's own field that are tried.
std::span<const double> own_levels();
// Sampled iso-values of the field of a pair below `limit`.
Vec<double> sampled_levels(const Options &options, double limit);

// Of each level the component of `rising` (0 on the tooth's seeds) below it that holds the seeds, holes filled; the
// best is that whose border has the largest concavity x sqrt(harmonic mean gradient), times how plausible its area is.
// `levels` rise.
struct Level {
  double at = std::numeric_limits<double>::quiet_NaN();  // NaN if none has a border
  double value = -1;
};
Level best_level(const Prepared &prepared, Index group, cut::Values rising, std::span<const double> levels);

}  // namespace ts::tooth
