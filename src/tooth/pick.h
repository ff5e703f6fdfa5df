// From a click to the two groups it is about (paper, "User interface").
#pragma once

#include "tooth/prepared.h"

namespace ts::tooth {

struct Pick {
  Index target = mesh::none, neighbour = mesh::none;
  double target_distance = 0, neighbour_distance = 0;  // NaN without a neighbour
};

// The closest group along the surface, in the metric of the options, and its neighbour: the closer of the two next to
// it along the arch. With the paper's plain metric (click_concavity 0) the neighbour is the next closest group, as
// written.
Pick pick(const Prepared &prepared, const mesh::SurfacePoint &at);

}  // namespace ts::tooth
