// The fewest clicks that cover every group.
#pragma once

#include "tooth/pick.h"

namespace ts::tooth {

// Along the arch, two teeth a click where a point on one of them takes the other for its neighbour.
Vec<Vec3> propose_clicks(const Prepared &prepared);

}  // namespace ts::tooth
