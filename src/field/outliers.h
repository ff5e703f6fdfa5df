// Feature points that the field contradicts.
#pragma once

#include "field/solver.h"

namespace ts::field {

// 1 for the nodes to be left free, in two cases:
// - another tooth has more than half of the node's conductance to all others, and more than its own tooth, and no seam
//   stands between. (Not the gingiva: it borders on every cusp.)
// - the point lies on gingiva: it is flat for a feature (`convexity` of its point; 0 = set by hand, never in this case)
//   and no seam stands between it and the gingiva.
// The worst is freed first and the rest looked at again without it, for one wrong point makes its right neighbours look
// wrong. The last node of a tooth stays. `convexity`: of each of Sites::point.
Vec<std::uint8_t> find_outliers(const Solver &solver, const Nodes &nodes, std::span<const double> convexity);

}  // namespace ts::field
