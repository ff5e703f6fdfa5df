#include "tooth/numbering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/error.h"

namespace ts::tooth {
namespace {

constexpr int places = features::places;
constexpr double impossible = -std::numeric_limits<double>::infinity();
using Places = std::array<double, places>;
using Pairs = std::array<Places, places>;

// Probabilities, round figures: that a tooth is missing inside the row of those left, and that the one beside a missing
// one is missing too; that one is in front of the first or behind the last, where at most three count (a scan of one
// quadrant); that a third molar stands.
constexpr double kMissing = 0.04, kMissingToo = 0.25, kMissingAtEnd = 0.15, kThirdMolar = 0.15;
constexpr int kMostAtEnd = 3;

// Of log(measured / (size * mean)). Within a population crown widths have standard deviations of 5 to 7 % of the mean
// and of 9 to 10 % at upper lateral incisors and third molars; on top of that comes the measuring, on a crown or on the
// stretch of the arch between two interstices. One in twenty is measured wrong.
constexpr double kNatural = 0.06, kVariable = 0.095, kCrownError = 0.06, kDepthError = 0.09, kStretchError = 0.12;
constexpr double kWrong = 0.05, kWrongRange = 1.4;
// People's teeth against the means, as a whole.
constexpr double kSizeSpread = 0.05, kSizeStep = 0.04;
constexpr int kSizes = 4;  // to either side

// Along the arch: how far off its place in an arch without gaps a tooth stands, mm and over its distance from the
// midline. Student's t with 3 degrees of freedom, as some have drifted far.
constexpr double kPlace = 1.0, kPlaceGrowth = 0.08;
// Between two teeth, mm: contact, and the open stretch that missing teeth leave.
constexpr double kContact = 0.8, kDiastema = 2, kDiastemas = 0.1;
constexpr double kGapLeft = 0.9, kGapSpread = 1, kGapGrowth = 0.15, kClosed = 0.15, kHalfClosed = 0.15;
// Feature points: how far across the crown they lie, over its depth, and the spread of that, mm.
constexpr double kAcrossSpread = 1.3;

double normal(double x, double sd) {
  return std::exp(-0.5 * x * x / (sd * sd)) / (sd * std::sqrt(2 * std::numbers::pi));
}

int from_middle(int place) {  // 0: central incisor
  return place < 8 ? 7 - place : place - 8;
}
bool third_molar(int place) {
  return from_middle(place) == 7;
}

double natural_spread(Jaw jaw, int place) {
  const int k = from_middle(place);
  return (jaw == Jaw::upper && k == 1) || k == 7 ? kVariable : kNatural;
}

double across_share(Jaw jaw, int place) {
  constexpr std::array<double, 8> upper{0.15, 0.15, 0.2, 0.55, 0.55, 0.55, 0.55, 0.55};
  constexpr std::array<double, 8> lower{0.15, 0.15, 0.2, 0.45, 0.55, 0.55, 0.55, 0.55};
  return (jaw == Jaw::upper ? upper : lower)[static_cast<std::size_t>(from_middle(place))];
}

double measured(double value, double mean, double spread, double error) {
  const double z = std::log(value / mean);
  return std::log((1 - kWrong) * normal(z, std::hypot(spread, error)) + kWrong / kWrongRange);
}

// The row from the patient's right to the left under a hypothesis: jaw and size of the teeth.
class Formula {
 public:
  Formula(Jaw jaw, double size, const Vec<ArchTooth> &teeth, const Vec<int> &fixed) : teeth_(teeth) {
    double sum = 0;
    for (int p = 8; p < places; ++p) {
      const double w = size * features::mean_width(jaw, p);
      width_[p] = width_[places - 1 - p] = w;
      offset_[p] = sum + w / 2;
      offset_[places - 1 - p] = -offset_[p];
      sum += w;
    }
    for (int p = 0; p < places; ++p) {
      int missing = 0;
      for (int q = 0; q < p; ++q) missing += !third_molar(q);
      const double third = third_molar(p) ? std::log(kThirdMolar) : std::log(1 - kThirdMolar);
      begin_[p] = std::exp(third + std::min(missing, kMostAtEnd) * std::log(kMissingAtEnd));
    }
    std::reverse_copy(begin_.begin(), begin_.end(), end_.begin());
    for (std::size_t i = 0; i < teeth.size(); ++i) {
      const Places score = form(jaw, size, teeth[i]);
      const double most = fixed[i] >= 0 ? score[fixed[i]] : *std::ranges::max_element(score);
      form_.emplace_back();
      log_form_ += most;
      for (int p = 0; p < places; ++p) form_.back()[p] = fixed[i] >= 0 && p != fixed[i] ? 0 : std::exp(score[p] - most);
      if (i > 0) pairs_.push_back(pairs(teeth[i - 1], teeth[i]));
    }
  }

  // Log-probability with the midline there; `marginal` a tooth: that of each place, sums to 1.
  double run(double midline, Vec<Places> &marginal) const {
    const std::size_t n = teeth_.size();
    double log = log_form_;
    Vec<Places> own(n);
    for (std::size_t i = 0; i < n; ++i)
      for (int p = 0; p < places; ++p) own[i][p] = form_[i][p] * at_place(teeth_[i].at - midline, p);
    Vec<Places> before(n);  // marginals of the teeth up to this one
    for (std::size_t i = 0; i < n; ++i) {
      Places reach = i == 0 ? begin_ : Places{};
      if (i > 0) add_reached(before[i - 1], pairs_[i - 1], reach);
      double sum = 0;
      for (int q = 0; q < places; ++q) {
        reach[q] *= own[i][q];
        sum += i + 1 == n ? reach[q] * end_[q] : reach[q];
      }
      if (!(sum > 0)) return impossible;
      for (double &b : reach) b /= sum;
      before[i] = reach;
      log += std::log(sum);
    }
    Places after = end_;
    for (std::size_t i = n; i-- > 0;) {
      double sum = 0;
      for (int p = 0; p < places; ++p) sum += marginal[i][p] = before[i][p] * after[p];
      for (double &m : marginal[i]) m /= sum;
      if (i > 0) after = reaching(pairs_[i - 1], own[i], after);
    }
    return log;
  }

 private:
  // From the marginals of a tooth on to the places of the next.
  static void add_reached(const Places &before, const Pairs &pairs, Places &reach) {
    for (int p = 0; p < places; ++p) {
      const double b = before[p];
      const Places &pair = pairs[p];
      if (b != 0)
        for (int q = p + 1; q < places; ++q) reach[q] += b * pair[q];
    }
  }

  // From what lies behind a tooth back to the places of the one before it, the most being 1.
  static Places reaching(const Pairs &pairs, const Places &own, const Places &after) {
    Places before{};
    double most = 0;
    for (int p = 0; p < places; ++p) {
      const Places &pair = pairs[p];
      for (int q = p + 1; q < places; ++q) before[p] += pair[q] * own[q] * after[q];
      most = std::max(most, before[p]);
    }
    for (double &b : before) b /= most;
    return before;
  }

  static Places form(Jaw jaw, double size, const ArchTooth &t) {
    Places score{};
    for (int p = 0; p < places; ++p) {
      const double spread = natural_spread(jaw, p), depth = size * features::mean_depth(jaw, p);
      if (t.width > 0)
        score[p] +=
            measured(t.width, size * features::mean_width(jaw, p), spread, t.crown ? kCrownError : kStretchError);
      if (t.depth > 0) score[p] += measured(t.depth, depth, spread, kDepthError);
      if (!std::isnan(t.across))
        score[p] +=
            std::log((1 - kWrong) * normal(t.across - across_share(jaw, p) * depth, kAcrossSpread) + kWrong / 10);
    }
    return score;
  }

  double at_place(double at, int place) const {
    const double sd = kPlace + kPlaceGrowth * std::abs(offset_[place]), x = (at - offset_[place]) / sd;
    const double tail = 1 + x * x / 3;
    return 2 / (std::numbers::pi * std::numbers::sqrt3 * sd * tail * tail);
  }

  Pairs pairs(const ArchTooth &a, const ArchTooth &b) const {
    const auto half = [](const ArchTooth &t) { return t.width > 0 ? t.width / 2 : 0; };
    const double gap = std::max(0.0, b.at - a.at - half(a) - half(b));  // crowded teeth overlap
    const double contact = 2 * normal(gap, kContact);
    Pairs pair{};
    for (int p = 0; p < places; ++p) {
      double open = 0, prior = 1;
      for (int q = p + 1; q < places; ++q) {
        if (q == p + 1) {
          pair[p][q] = (1 - kDiastemas) * contact + kDiastemas * std::exp(-gap / kDiastema) / kDiastema;
        } else {
          open += width_[q - 1];
          prior *= q == p + 2 ? kMissing : kMissingToo;
          const double left = normal(gap - kGapLeft * open, kGapSpread + kGapGrowth * open);
          pair[p][q] = prior * ((1 - kClosed - kHalfClosed) * left + kClosed * contact +
                                kHalfClosed * (gap < open ? 1 / open : 0));
        }
      }
    }
    return pair;
  }

  const Vec<ArchTooth> &teeth_;
  Places width_{}, offset_{}, begin_{}, end_{};
  double log_form_ = 0;
  Vec<Places> form_;  // over e^log_form_
  Vec<Pairs> pairs_;  // between a tooth and the next
};

// Marginals summed over hypotheses, in units of e^top.
struct Sum {
  double top = impossible, weight = 0;
  Vec<Places> marginal;

  void add(double log, const Vec<Places> &m) {
    if (marginal.empty()) marginal.assign(m.size(), Places{});
    if (log == impossible) return;
    if (log > top) {
      const double shrink = std::exp(top - log);
      weight *= shrink;
      for (Places &x : marginal)
        for (double &v : x) v *= shrink;
      top = log;
    }
    const double w = std::exp(log - top);
    weight += w;
    for (std::size_t i = 0; i < m.size(); ++i)
      for (int p = 0; p < places; ++p) marginal[i][p] += w * m[i][p];
  }
  double log() const { return weight > 0 ? top + std::log(weight) : impossible; }
};

// The rising places with the largest sum of marginals.
Vec<int> rising(const Vec<Places> &marginal) {
  const std::size_t n = marginal.size();
  Vec<Places> best(n);
  for (std::size_t i = 0; i < n; ++i)
    for (int q = 0; q < places; ++q) {
      double before = i == 0 ? 0 : impossible;
      if (i > 0)
        for (int p = 0; p < q; ++p) before = std::max(before, best[i - 1][p]);
      best[i][q] = before + marginal[i][q];
    }
  Vec<int> place(n);
  int limit = places;
  for (std::size_t i = n; i-- > 0;) {
    const auto end = best[i].begin() + limit;
    limit = place[i] = static_cast<int>(std::max_element(best[i].begin(), end) - best[i].begin());
  }
  return place;
}

struct Hypotheses {
  Jaw jaw;
  bool reversed;  // the first tooth is the one furthest on the patient's left
  Sum sum;
};

void run(const ArchRow &row, const Given &given, Hypotheses &h) {
  Vec<ArchTooth> teeth = row.teeth;
  Vec<int> fixed = given.place.empty() ? Vec<int>(teeth.size(), -1) : given.place;
  if (h.reversed) {
    std::ranges::reverse(teeth);
    std::ranges::reverse(fixed);
    for (ArchTooth &t : teeth) t.at = -t.at;
  }
  Vec<Places> marginal(teeth.size());
  for (int s = -kSizes; s <= kSizes; ++s) {
    const double log_size = s * kSizeStep;
    const Formula formula(h.jaw, std::exp(log_size), teeth, fixed);
    for (std::size_t m = 0; m < row.midline.size(); ++m) {
      if (row.midline[m] == impossible) continue;
      const double midline = row.midline_from + static_cast<double>(m) * ArchRow::step;
      const double log = formula.run(h.reversed ? -midline : midline, marginal);
      h.sum.add(log + row.midline[m] - 0.5 * std::pow(log_size / kSizeSpread, 2), marginal);
    }
  }
  if (h.reversed) std::ranges::reverse(h.sum.marginal);
}

}  // namespace

Numbering number_teeth(const ArchRow &row, const Given &given) {
  if (row.teeth.size() > static_cast<std::size_t>(places))
    throw Error(Fault::too_many_teeth,
                std::to_string(row.teeth.size()) + " teeth along the arch, a jaw has " + std::to_string(places));
  if (row.teeth.empty()) return {};
  Vec<Hypotheses> all;
  for (const Jaw jaw : {Jaw::upper, Jaw::lower}) {
    if (given.jaw && *given.jaw != jaw) continue;
    // Looking at the biting surface with the incisors up, the patient's right is on the left of the upper arch: from
    // right to left it turns right. Of the lower arch it is on the right.
    const Turn from_right = (jaw == Jaw::upper) != given.mirrored ? Turn::right : Turn::left;
    for (const bool reversed : {false, true})
      if (row.turn == Turn::unknown || (row.turn == from_right) != reversed) all.push_back({jaw, reversed, {}});
  }
  for (Hypotheses &h : all) run(row, given, h);
  double top = impossible;
  for (const Hypotheses &h : all) top = std::max(top, h.sum.log());
  if (top == impossible)
    throw Error(Fault::number_order, "the numbers set do not rise along the arch, or leave none for the teeth between");
  const auto weight = [&](const Hypotheses &h) { return std::exp(h.sum.log() - top); };
  double total = 0;
  for (const Hypotheses &h : all) total += weight(h);
  const Hypotheses &best = *std::ranges::max_element(all, {}, weight);
  Numbering n;
  n.jaw = best.jaw;
  n.jaw_confidence = 0;
  for (const Hypotheses &h : all)
    if (h.jaw == n.jaw) n.jaw_confidence += weight(h) / total;
  Vec<Places> marginal = best.sum.marginal;
  if (best.reversed) std::ranges::reverse(marginal);
  n.place = rising(marginal);
  for (std::size_t i = 0; i < marginal.size(); ++i)
    n.confidence.push_back(marginal[i][n.place[i]] / best.sum.weight * weight(best) / total);
  if (best.reversed) {
    std::ranges::reverse(n.place);
    std::ranges::reverse(n.confidence);
  }
  return n;
}

}  // namespace ts::tooth
