// From boundary lines one vertex wide to teeth.
#pragma once

#include "bench/rival_segmentation.h"

namespace ts::bench {

struct RegionOptions {
  unsigned wanted = 14;       // teeth: what is more is joined
  double least_tooth = 20;    // mm^2 of surface; smaller ones belong to a neighbour. The least incisors have some 60.
  double most_tooth = 320;    // mm^2; larger ones are gingiva, or not separated. Large molars have some 250.
  double stands = 3.5;        // mm: a tooth's top is not further under the highest point around
  double border_share = 0.4;  // of its outline on the scan's border, above which a region is gingiva
};

// The regions between the lines; the faces on both sides of a line meet on it.
Teeth teeth_between(const Surface &surface, const Mask &line, const Vec<double> &concavity, const Heights &heights,
                    const RegionOptions &options);

}  // namespace ts::bench
