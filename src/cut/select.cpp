#include "cut/select.h"

#include <algorithm>
#include <cmath>

namespace ts::cut {

Histogram histogram(std::span<const double> u, std::size_t bins) {
  Histogram h;
  h.bins.assign(bins, 0);
  for (const double value : u) {
    if (std::isnan(value)) continue;
    const double place = std::clamp(value, 0.0, 1.0) * static_cast<double>(bins);
    ++h.bins[std::min(bins - 1, static_cast<std::size_t>(place))];
  }
  const auto fullest = std::max_element(h.bins.begin(), h.bins.end()) - h.bins.begin();
  h.v_med = (static_cast<double>(fullest) + 0.5) / static_cast<double>(bins);
  return h;
}

Chosen largest_gradient(std::span<const Score> scores, double v_med) {
  Chosen chosen;
  for (std::size_t k = 0; k < scores.size(); ++k) {
    if (!(scores[k].length > 0)) continue;
    std::size_t &best = iso_value(k, scores.size()) <= v_med ? chosen.target : chosen.neighbour;
    if (best == SIZE_MAX || scores[k].gradient > scores[best].gradient) best = k;
  }
  return chosen;
}

}  // namespace ts::cut
