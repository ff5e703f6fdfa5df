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
// Of central incisors also by the finer convexity, in a stretch as wide as the formula has one there and no molar's,
// where one ridge stands before the other and off its line: a notched edge is one line, however the tooth is turned.
// That is found in none of 400 upper central incisors of random arches, 140 of them severely crowded (next: two in
// stretches .82 and .91 times as wide; .81 off the line), nor on 18 scans (next: parted by .174); and in 18 of 61 pairs
// of lower incisors that the division took for one.
constexpr float kPartedFine = 0.2f;
constexpr double kSmallestFine = 3, kFull = 0.92, kBefore = 1.1, kOffLine = 0.9;
constexpr double kAlong = 2.0;    // mm along the arch between their middles: cusps of a premolar lie across it
constexpr double kDeepest = 3.0;  // of their tops below the span's, mm: a cingulum lies deeper
constexpr double kBelowTop = 14;  // mm: the way may lead down to the gingiva

// Among the teeth next to the midline, so many a side.
bool within(int places_a_side, int place) {
  return place >= places / 2 - places_a_side && place < places / 2 + places_a_side;
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

// Whether one ridge stands before the other: across the arch, and off the line of either.
bool stepped(const std::array<Ridge, 2> &ridges) {
  std::array<Vec2, 2> middle, along;
  for (std::size_t r = 0; r < 2; ++r) {
    const auto at = [](std::size_t cell) {
      const std::size_t slice = cell / Strip::across;
      return Vec2(static_cast<double>(slice) * Strip::step, Strip::t(static_cast<int>(cell % Strip::across)));
    };
    middle[r].setZero();
    for (const std::size_t cell : ridges[r].cells) middle[r] += at(cell);
    middle[r] /= static_cast<double>(ridges[r].cells.size());
    double xx = 0, xy = 0, yy = 0;
    for (const std::size_t cell : ridges[r].cells) {
      const Vec2 d = at(cell) - middle[r];
      xx += d.x() * d.x(), xy += d.x() * d.y(), yy += d.y() * d.y();
    }
    const double angle = std::atan2(2 * xy, xx - yy) / 2;
    along[r] = {std::cos(angle), std::sin(angle)};
  }
  const Vec2 gap = middle[1] - middle[0];
  const auto off = [&](const Vec2 &line) { return std::abs(gap.x() * line.y() - gap.y() * line.x()); };
  return std::abs(gap.y()) >= kBefore && std::min(off(along[0]), off(along[1])) >= kOffLine;
}

struct Apart {
  float least;  // how much less convex the way between is
  double area;  // of either ridge, mm^2
};

// The two ridges of some cells that the least convex way connects: cells are joined from the most convex down.
std::optional<std::array<Ridge, 2>> part(const Strip &strip, const Vec<float> &convexity, Vec<std::size_t> cells,
                                         float top, const Apart &apart) {
  const std::size_t first = std::ranges::min(cells), last = std::ranges::max(cells);
  const auto above = [&](std::size_t a, std::size_t b) { return convexity[a] > convexity[b]; };
  std::ranges::sort(cells, [&](std::size_t a, std::size_t b) { return above(a, b) || (!above(b, a) && a < b); });

  Sets sets(last - first + 1);
  Vec<std::size_t> area(last - first + 1, 0);
  Vec<float> height(last - first + 1, 0);
  float deepest = apart.least;
  std::optional<std::array<Ridge, 2>> parted;
  const auto least_area = static_cast<std::size_t>(apart.area / (Strip::step * Strip::step));
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
        const float dip = convexity[less + first] - convexity[c];
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

}  // namespace

std::optional<std::array<Ridge, 2>> two_ridges(const Strip &strip, const ToothSpan &tooth, double expected,
                                               double table) {
  if (!within(3, tooth.place)) return {};
  const Vec<std::size_t> cells = span_cells(strip, tooth, 0);
  float top = -1e9f;
  for (const std::size_t c : cells)
    if (std::abs(Strip::t(static_cast<int>(c % Strip::across))) <= 6) top = std::max(top, strip.height[c]);
  const auto crown = [&](const Vec<float> &convexity) {
    Vec<std::size_t> kept = cells;
    std::erase_if(kept, [&](std::size_t c) { return std::isnan(convexity[c]) || strip.height[c] < top - kBelowTop; });
    return kept;
  };
  const Vec<std::size_t> coarse = crown(strip.convexity);
  if (coarse.empty()) return {};
  const double width = (tooth.to - tooth.from) * Strip::step;
  const bool wide = width > kWide * expected && table < kTable;
  const Apart apart = wide ? Apart{kPartedIfWide, kSmallestIfWide} : Apart{kParted, kSmallest};
  if (auto ridges = part(strip, strip.convexity, coarse, top, apart)) return ridges;
  if (!within(1, tooth.place) || width < kFull * expected || table >= kTable) return {};
  const Vec<std::size_t> fine = crown(strip.fine);
  if (fine.empty()) return {};
  auto ridges = part(strip, strip.fine, fine, top, {kPartedFine, kSmallestFine});
  return ridges && stepped(*ridges) ? std::move(ridges) : std::nullopt;
}

}  // namespace ts::features
