// The component rule: at which level of a tooth's field it is best cut.
#pragma once

#include <span>

#include "cut/space.h"
#include "tooth/prepared.h"

namespace ts::tooth {

// Levels of 1 - the tooth's own field that are tried.
std::span<const double> own_levels();
// Sampled iso-values of the field of a pair below `limit`.
Vec<double> sampled_levels(const Options &options, double limit);

// Of each level the component of `rising` (0 on the tooth's seeds) below it that holds the seeds, holes filled. Its
// value is the concavity of its border x sqrt(harmonic mean gradient) x how plausible its area is; -1 if it has no
// border. `levels` rise.
Vec<double> level_values(const Prepared &prepared, Index group, cut::Values rising, std::span<const double> levels);
// The one with the largest value; NaN if none has a border.
double best_level(const Prepared &prepared, Index group, cut::Values rising, std::span<const double> levels);

}  // namespace ts::tooth
