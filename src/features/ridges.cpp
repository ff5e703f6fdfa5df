#include "features/ridges.h"

#include <algorithm>
#include <cmath>

#include "features/formula.h"
#include "features/points.h"

namespace ts::features {
namespace {

// How much less convex than either top the way from one ridge to another is at best: on labelled real scans at most .13
// within an anterior crown, on synthetic ones .26; between two of them, one before the other, .33 to .44.
constexpr float kParted = 0.28f;
constexpr double kSmallest = 6;  // mm^2 of either: less is the end of an edge that is notched
// In a stretch this much wider than the formula has a tooth there, two are likely, and less of a way down parts them.
// Anterior teeth of 18 scans: at most 1.26, with .09; of 1,900 of random crowded arches one tooth at most 1.24, and
// two, where they had one group, 1.37 to 1.63 with .13 to .23. A molar that the formula takes for an incisor has a
// wider table, mm: 9, and those pairs 2.4.
constexpr double kWide = 1.3, kTable = 5, kSmallestIfWide = 1.5;
constexpr float kPartedIfWide = 0.12f;
constexpr double kAlong = 2.0;    // mm along the arch between their middles: cusps of a premolar lie across it
constexpr double kDeepest = 3.0;  // of their tops below the span's, mm: a cingulum lies deeper
constexpr double kBelowTop = 14;  // mm: the way may lead down to the gingiva

bool anterior(int place) {
  return place >= places / 2 - 3 && place < places / 2 + 3;
}

// Cells joined from the most convex down; a set is named by a cell, its most convex one.
class Sets {
 public:
  explicit Sets(std::size_t cells) : up_(cells, kNone) {}
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::size_t find(std::size_t cell) {
    if (up_[cell] == kNone) return kNone;
    while (up_[cell] != cell) cell = up_[cell] = up_[up_[cell]];
    return cell;
  }
  void add(std::size_t cell, std::size_t to) { up_[cell] = to; }

 private:
  Vec<std::size_t> up_;
};

std::optional<std::array<Ridge, 2>> in_order(std::array<Ridge, 2> found) {
  double middle[2] = {0, 0};
  for (int r = 0; r < 2; ++r) {
    Ridge &ridge = found[r];
    std::ranges::sort(ridge.cells);
    ridge.from = static_cast<int>(ridge.cells.front() / Strip::across);
    ridge.to = static_cast<int>(ridge.cells.back() / Strip::across) + 1;
    for (const std::size_t cell : ridge.cells) {
      const std::size_t slice = cell / Strip::across;
      middle[r] += static_cast<double>(slice);
    }
    middle[r] /= static_cast<double>(ridge.cells.size());
  }
  if (std::abs(middle[0] - middle[1]) * Strip::step < kAlong) return {};
  if (middle[0] > middle[1]) std::swap(found[0], found[1]);
  return found;
}

}  // namespace

std::optional<std::array<Ridge, 2>> two_ridges(const Strip &strip, const ToothSpan &tooth, double expected,
                                               double table) {
  if (!anterior(tooth.place)) return {};
  Vec<std::size_t> cells = span_cells(strip, tooth, 0);
  float top = -1e9f;
  for (const std::size_t c : cells)
    if (std::abs(Strip::t(static_cast<int>(c % Strip::across))) <= 6) top = std::max(top, strip.height[c]);
  std::erase_if(cells,
                [&](std::size_t c) { return std::isnan(strip.convexity[c]) || strip.height[c] < top - kBelowTop; });
  if (cells.empty()) return {};
  const std::size_t first = std::ranges::min(cells), last = std::ranges::max(cells);
  const auto above = [&](std::size_t a, std::size_t b) { return strip.convexity[a] > strip.convexity[b]; };
  std::ranges::sort(cells, [&](std::size_t a, std::size_t b) { return above(a, b) || (!above(b, a) && a < b); });

  Sets sets(last - first + 1);
  Vec<std::size_t> area(last - first + 1, 0);
  Vec<float> height(last - first + 1, 0);
  const bool wide = (tooth.to - tooth.from) * Strip::step > kWide * expected && table < kTable;
  float deepest = wide ? kPartedIfWide : kParted;
  std::optional<std::array<Ridge, 2>> parted;
  const auto least_area = static_cast<std::size_t>((wide ? kSmallestIfWide : kSmallest) / (Strip::step * Strip::step));
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const std::size_t c = cells[k], at = c - first;
    const auto j = static_cast<int>(c % Strip::across);
    std::size_t best = Sets::kNone;
    for (std::ptrdiff_t di = -1; di <= 1; ++di)
      for (int dj = -1; dj <= 1; ++dj) {
        if (j + dj < 0 || j + dj >= Strip::across) continue;
        const auto n = static_cast<std::ptrdiff_t>(at) + di * Strip::across + dj;
        if (n < 0 || n > static_cast<std::ptrdiff_t>(last - first)) continue;
        const std::size_t other = sets.find(static_cast<std::size_t>(n));
        if (other == Sets::kNone || other == best) continue;
        if (best == Sets::kNone) {
          best = other;
          continue;
        }
        const bool lower = above(best + first, other + first);
        const std::size_t less = lower ? other : best, more = lower ? best : other;
        const float dip = strip.convexity[less + first] - strip.convexity[c];
        if (dip >= deepest && area[less] >= least_area && area[more] >= least_area &&
            std::min(height[less], height[more]) > top - kDeepest) {
          std::array<Ridge, 2> found;
          for (std::size_t h = 0; h < k; ++h) {
            const std::size_t set = sets.find(cells[h] - first);
            if (set == less || set == more) found[set == more].cells.push_back(cells[h]);
          }
          if (auto ridges = in_order(std::move(found))) parted = std::move(ridges), deepest = std::nextafter(dip, 1.f);
        }
        sets.add(less, more);
        area[more] += area[less];
        height[more] = std::max(height[more], height[less]);
        best = more;
      }
    if (best == Sets::kNone) best = at;
    sets.add(at, best);
    ++area[best];
    height[best] = area[best] == 1 ? strip.height[c] : std::max(height[best], strip.height[c]);
  }
  return parted;
}

}  // namespace ts::features
