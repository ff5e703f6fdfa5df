// What the strip says for teeth, gaps and the cuts between teeth, as numbers to be weighed.
#pragma once

#include <array>

#include "features/strip.h"

namespace ts::features {

// Of a slanted line across the strip, how much it looks like an interstice. Each is used twice: anterior teeth (narrow
// occlusal table) and posterior teeth weigh it differently.
struct CutMeasure {
  enum : int { bias, area_mean, area_least, notch, ridge, fine_ridge, valley, curvature, slant, count };
};
// Of a slice, how much it looks like a tooth rather than a gap or the gums behind the last tooth.
struct SliceMeasure {
  enum : int { bias, roughness, peak, fine_peak, drop, relief, hole, count };
};

inline constexpr int cut_terms = 2 * CutMeasure::count;
inline constexpr int slice_terms = SliceMeasure::count;
using CutTerms = std::array<float, cut_terms>;
using SliceTerms = std::array<float, slice_terms>;

struct Slants {
  static constexpr int count = 11;
  static constexpr double degrees(int k) { return 10 * (k - 5); }
};

struct Evidence {
  int slices = 0;
  Vec<CutTerms> cut;      // [slice * Slants::count + slant]
  Vec<SliceTerms> slice;  // summed from 0 to before this slice: slices + 1 entries, in mm
  Vec<float> table;       // a slice: width of the occlusal table, mm
};

Evidence gather(const Strip &strip, const Executor &executor);

}  // namespace ts::features
