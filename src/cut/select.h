// Which contours are the cuts (paper, "Cutting boundary selection").
#pragma once

#include "cut/contour.h"

namespace ts::cut {

struct Histogram {
  Vec<Index> bins;   // vertices a bin over [0, 1] (Fig. 4C)
  double v_med = 0;  // centre of Bin_max, the fullest bin (the lowest of several)
};

Histogram histogram(std::span<const double> u, std::size_t bins);

// The contours with the largest mean gradient in [0, V_med] and (V_med, 1]; SIZE_MAX where there is none.
struct Chosen {
  std::size_t target = SIZE_MAX, neighbour = SIZE_MAX;
};

Chosen largest_gradient(std::span<const Score> scores, double v_med);

}  // namespace ts::cut
