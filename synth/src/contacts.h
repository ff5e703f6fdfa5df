// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dentition.h"

namespace tsa {

// Crowns are solid: however crowded, they stand behind, before and against each other, never in each other. Neighbours
// that do are moved apart in plan until no more is left than contacts that wear has flattened. Teeth in the order of
// the arch.
void moveApart(std::vector<PlacedTooth> &teeth);

}  // namespace tsa
