// From boundary lines one vertex wide to teeth.
#pragma once

#include "bench/rival_segmentation.h"

namespace ts::bench {

struct RegionOptions {
  double least_tooth = 25;   // mm^2 of surface; smaller ones belong to a neighbour
  double most_tooth = 450;   // mm^2; larger ones are gingiva, or not separated
  double stands = 3.0;       // mm: a tooth's top is not further under the highest point around
  double border_share = 0.3; // of its outline on the scan's border, above which a region is gingiva
};

// The regions between the lines; the faces on both sides of a line meet on it.
Teeth teeth_between(const Surface &surface, const Mask &line, const Vec<double> &concavity, const Heights &heights,
                    const RegionOptions &options);

}  // namespace ts::bench
