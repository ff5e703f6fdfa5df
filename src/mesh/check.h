// What a raw mesh must be before anything is done with it.
#pragma once

#include "mesh/intake.h"

namespace ts::mesh {

// Throws unless there are faces, all coordinates are finite and all corners name vertices.
void check_elements(const RawMesh &raw, const Executor &executor);

// Turns the coordinates into millimetres; throws if they are beyond 1e9, or if `unit` asks for a check and the size of
// what the faces use is not that of a scan.
void to_millimetres(RawMesh &raw, Unit unit, const Executor &executor);

}  // namespace ts::mesh
