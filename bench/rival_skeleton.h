// Tooth segmentation by the morphologic skeleton of a thresholded curvature field, the family of refs. 23, 24, 26 and
// 28 of the paper.
#pragma once

#include "bench/rival_segmentation.h"

namespace ts::bench {

// `threshold` 0: searched, so that the number of teeth fits `wanted` best.
Outcome skeleton_teeth(const Surface &surface, unsigned wanted, double threshold, const Executor &executor);

}  // namespace ts::bench
