// The faces of a tooth: the level of its field that it is cut at, and the minimum cut near there.
#pragma once

#include <limits>

#include "tooth/fields.h"

namespace ts::tooth {

struct Region {
  double iso = std::numeric_limits<double>::quiet_NaN();  // of u; NaN if there is no contour
  Vec<Index> faces;                                       // ascending
};

// The faces that hang together with the seeds of `group` below 0, their border moved to the seams beside it
// (cut/refine.h), holes filled. `phi`: about -1 deep in the tooth and 1 on the background.
Vec<Index> faces_below_zero(const Prepared &prepared, Index group, cut::Values phi);

// On a tooth's own field. Of the levels' regions that is taken whose border is cheapest for its size, or of those that
// are about as cheap the one whose level is best (tooth/level.h).
Region own_region(const Prepared &prepared, const Pick &pick, Fields &fields, bool of_target);
// The same of the target, the levels looked at in two tasks, each half of them.
Region own_region_in_halves(const Prepared &prepared, const Pick &pick, Fields &fields);

}  // namespace ts::tooth
