// Feature points that the field contradicts.
#pragma once

#include "field/solver.h"

namespace ts::field {

// 1 for the nodes to be left free: another tooth has more than half of the node's conductance to all others, and more
// than its own tooth. (Not the gingiva: it borders on every cusp.) The worst is freed first and the rest looked at
// again without it, for one wrong point makes its right neighbours look wrong. The last node of a tooth stays.
Vec<std::uint8_t> find_outliers(const Solver &solver, const Nodes &nodes);

}  // namespace ts::field
