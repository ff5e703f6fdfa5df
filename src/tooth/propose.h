// The fewest clicks that cover every group.
#pragma once

#include <span>

#include "tooth/pick.h"

namespace ts::tooth {

// Along the arch, two teeth a click, on the side of the one that faces the other; groups in `separated` are left out.
Vec<Vec3> propose_clicks(const Prepared &prepared, std::span<const Index> separated);

}  // namespace ts::tooth
