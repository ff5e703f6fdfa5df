// Segmentation by the shape diameter function, as CGAL has it (ref. 13 of the paper and its successors).
#pragma once

#include "bench/rival_segmentation.h"

namespace ts::bench {

// The settings of the grid whose number of segments besides the gingiva fits `wanted` best. Throws std::runtime_error
// where the program was built without CGAL.
Outcome sdf_teeth(const Surface &surface, unsigned wanted);

}  // namespace ts::bench
