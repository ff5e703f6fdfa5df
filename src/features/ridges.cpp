#include "features/ridges.h"

#include <algorithm>
#include <cmath>

#include "features/formula.h"
#include "features/points.h"

namespace ts::features {
namespace {

struct Apart {
  float least;  // how much less convex the way between is
  double area;  // of either ridge, mm^2
};

// How much less convex than either top the way from one ridge to another is at best: on labelled real scans at most .13
// within an anterior crown, on synthetic ones .26; between two of them, one before the other, .33 to .44.
// Ridges of less than 6 mm^2 are the ends of an edge that is notched.
constexpr Apart kParted = {0.28f, 6};
// In a stretch this much wider than the formula has a tooth there, two are likely, and less of a way down parts them.
// Anterior teeth of 18 scans: at most 1.26, with .09; of 1,900 of random crowded arches one tooth at most 1.24, and
// two, where they had one group, 1.37 to 1.63 with .13 to .23. A molar that the formula takes for an incisor has a
// wider table, mm: 9, and those pairs 2.4.
constexpr double kWide = 1.3, kTable = 5;
constexpr Apart kPartedIfWide = {0.12f, 1.5};
// Four lower incisors in two pairs pass for the upper central ones. Where both of these stretches have two ridges, one
// before the other, that a little parts, at either radius of convexity, they are such pairs. Of 42 random lower arches
// with molars missing that were taken for upper ones so, 32 have that; of 210 random upper ones, crowded and with noise
// of up to .6 edges, and of 18 scans as they are and with noise of .05, .2 and .5 edges, none; flat from .12 to .2 and
// .08 to .11, .8 to 1.1 mm. One stretch alone says little: noise parts single incisors by .5, and 3 mm across the arch.
constexpr Apart kPartedBoth = {0.10f, 3}, kPartedBothFine = {0.14f, 3};
constexpr double kFull = 0.9, kBefore = 0.9;  // of the width of an upper one; mm across the arch
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

Pair in_order(std::array<Ridge, 2> found) {
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

// How far one ridge stands before the other, mm across the arch.
double step(const std::array<Ridge, 2> &ridges) {
  double middle[2] = {0, 0};
  for (std::size_t r = 0; r < 2; ++r) {
    for (const std::size_t c : ridges[r].cells) middle[r] += Strip::t(static_cast<int>(c % Strip::across));
    middle[r] /= static_cast<double>(ridges[r].cells.size());
  }
  return std::abs(middle[1] - middle[0]);
}

// The two ridges of some cells that the least convex way connects: cells are joined from the most convex down.
Pair part(const Strip &strip, const Vec<float> &convexity, Vec<std::size_t> cells, float top, const Apart &apart) {
  const std::size_t first = std::ranges::min(cells), last = std::ranges::max(cells);
  const auto above = [&](std::size_t a, std::size_t b) { return convexity[a] > convexity[b]; };
  std::ranges::sort(cells, [&](std::size_t a, std::size_t b) { return above(a, b) || (!above(b, a) && a < b); });

  Sets sets(last - first + 1);
  Vec<std::size_t> area(last - first + 1, 0);
  Vec<float> height(last - first + 1, 0);
  float deepest = apart.least;
  Pair parted;
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

// An anterior tooth of a division.
class Stretch {
 public:
  Stretch(const Strip &strip, const ToothSpan &tooth, const Division &division, const Lattice &lattice)
      : strip_(strip),
        cells_(span_cells(strip, tooth, 0)),
        width_((tooth.to - tooth.from) * Strip::step / division.width[(tooth.from + tooth.to) / 2]),
        table_(lattice.table(tooth.from, tooth.to)) {
    for (const std::size_t c : cells_)
      if (std::abs(Strip::t(static_cast<int>(c % Strip::across))) <= 6) top_ = std::max(top_, strip.height[c]);
  }

  Pair alone() const {
    const bool wide = width_ > kWide && table_ < kTable;
    return parted(strip_.convexity, wide ? kPartedIfWide : kParted);
  }

  Pair in_pairs() const {
    if (width_ < kFull || table_ >= kTable) return {};
    Pair ridges = parted(strip_.fine, kPartedBothFine);
    if (!ridges || step(*ridges) < kBefore) ridges = parted(strip_.convexity, kPartedBoth);
    return ridges && step(*ridges) >= kBefore ? std::move(ridges) : std::nullopt;
  }

 private:
  Pair parted(const Vec<float> &convexity, const Apart &apart) const {
    Vec<std::size_t> kept = cells_;
    std::erase_if(kept, [&](std::size_t c) { return std::isnan(convexity[c]) || strip_.height[c] < top_ - kBelowTop; });
    return kept.empty() ? std::nullopt : part(strip_, convexity, std::move(kept), top_, apart);
  }

  const Strip &strip_;
  Vec<std::size_t> cells_;
  double width_;  // against the formula's
  double table_;  // mm
  float top_ = -1e9f;
};

}  // namespace

Vec<Pair> two_ridges(const Strip &strip, const Division &division, const Lattice &lattice) {
  Vec<Pair> found(division.teeth.size());
  std::array<Pair, 2> pairs;  // of the central incisors
  std::array<std::size_t, 2> central{};
  for (std::size_t t = 0; t < found.size(); ++t) {
    const int place = division.teeth[t].place;
    if (!within(3, place)) continue;
    const Stretch stretch(strip, division.teeth[t], division, lattice);
    found[t] = stretch.alone();
    if (division.jaw != Jaw::upper || !within(1, place)) continue;
    const std::size_t side = place >= places / 2;
    central[side] = t;
    pairs[side] = stretch.in_pairs();
  }
  if (pairs[0] && pairs[1])
    for (const std::size_t side : {0, 1})
      if (!found[central[side]]) found[central[side]] = std::move(pairs[side]);
  return found;
}

}  // namespace ts::features
