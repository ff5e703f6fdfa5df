#include "features/teeth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ts::features {
namespace {

constexpr double impossible = Lattice::impossible;

double log_add(double a, double b) {
  if (a < b) std::swap(a, b);
  return b == impossible ? a : a + std::log1p(std::exp(b - a));
}

}  // namespace

double mean_tooth_width(double table) {
  return 5.8 + (11.0 - 5.8) * std::clamp(table, 0.0, 14.0) / 14;
}

Lattice::Lattice(const Evidence &e, const Weights &w) : evidence_(&e) {
  const int n = e.slices;
  contact_.assign(n + 1, impossible);
  slant_.assign(n + 1, Slants::count / 2);
  for (int i = 1; i < n; ++i)
    for (int k = 0; k < Slants::count; ++k) {
      const CutTerms &t = e.cut[static_cast<std::size_t>(i) * Slants::count + k];
      double s = 0;
      for (int m = 0; m < cut_terms; ++m) s += w[Term::cut + m] * t[m];
      if (s > contact_[i]) contact_[i] = s, slant_[i] = k;
    }
  slice_.assign(n + 1, 0);
  table_.assign(n + 1, 0);
  for (int i = 0; i <= n; ++i)
    for (int m = 0; m < slice_terms; ++m) slice_[i] += w[Term::slice + m] * e.slice[i][m];
  for (int i = 0; i < n; ++i) table_[i + 1] = table_[i] + e.table[i];
  bias_ = w[Term::tooth];
  width_ = w[Term::width];
  width2_ = w[Term::width2];
  change_ = w[Term::change];
}

double Lattice::table(int from, int to) const {
  return (table_[to] - table_[from]) / (to - from);
}

double Lattice::log_width(int from, int to) const {
  return std::log((to - from) * Strip::step / mean_tooth_width(table(from, to)));
}

double Lattice::tooth(int from, int to) const {
  if (!starts.empty() && (starts[from] < 0 || starts[from] != ends[to])) return impossible;
  const double z = log_width(from, to);
  double score = slice_[to] - slice_[from] + bias_ + width_ * z + width2_ * z * z;
  if (!expected.empty())
    score -= width_cost * std::pow(std::log((to - from) * Strip::step / expected[(from + to) / 2]), 2);
  return score;
}

namespace {

// What the formula says of the step from place `a` (-1: none yet) to place `b` (places: none any more).
struct Steps {
  explicit Steps(const FormulaCosts &c) {
    for (int a = -1; a < places; ++a)
      for (int b = a + 1; b <= places; ++b) {
        const auto third_molar = [](int p) { return p == 0 || p == places - 1; };
        int missing = 0;
        for (int p = a + 1; p < b; ++p) missing += !third_molar(p);
        const double molar = b < places && third_molar(b) ? c.third_molar : 0;
        const bool end = a < 0 || b == places;
        open[a + 1][b] = -molar - (end ? c.missing_end * std::min(missing, 2) : c.missing_open * missing);
        closed[a + 1][b] = -molar - (end ? c.missing_end * std::min(missing, 2) : c.missing_closed * missing);
      }
  }
  std::array<std::array<double, places + 1>, places + 1> open{}, closed{};
};

// The best division for one jaw and one size.
class Assignment {
 public:
  Assignment(const Lattice &l, Jaw jaw, double size, const FormulaCosts &costs, const Steps &steps)
      : l_(l),
        steps_(steps),
        width_cost_(costs.width),
        rows_(l.slices() + 1),
        reached_(rows_),
        gap_(rows_),
        before_(rows_) {
    for (int k = 0; k < places; ++k) log_mean_[k] = std::log(size * mean_width(jaw, k));
    run();
  }

  double score() const { return score_; }

  Vec<ToothSpan> spans() const {
    Vec<ToothSpan> teeth;
    int i = l_.slices(), k = last_;
    bool in_tooth = ends_in_tooth_;
    while (i > 0 && k >= 0) {
      if (!in_tooth) {
        in_tooth = gap_[i][k + 1].after_tooth;
        --i;
        continue;
      }
      const End &e = reached_[i][k];
      const Before &b = before_[e.from][k];
      ToothSpan span{e.from, i, b.touching ? l_.slant(e.from) : -1, -1, k, 0};
      if (!teeth.empty() && teeth.back().from == i) span.to_slant = teeth.back().from_slant;
      teeth.push_back(span);
      i = e.from;
      k = b.previous;
      in_tooth = b.touching;
    }
    std::reverse(teeth.begin(), teeth.end());
    return teeth;
  }

 private:
  struct End {  // of a tooth at a position
    double score = impossible;
    int from = 0;
  };
  struct Gap {  // at a position, by the place of the last tooth + 1
    double score = impossible;
    bool after_tooth = false;
  };
  struct Before {  // what comes before a tooth that begins at a position
    double score = impossible;
    int previous = -1;
    bool touching = false;
  };

  void run() {
    gap_[0][0].score = 0;
    for (int i = 0; i < static_cast<int>(rows_); ++i) {
      if (i > 0) {
        end_teeth(i);
        for (int k = -1; k < places; ++k) {
          const double on = gap_[i - 1][k + 1].score,
                       from = k < 0 ? impossible : reached_[i - 1][k].score + l_.change();
          gap_[i][k + 1] = {std::max(on, from) + l_.gap(i - 1), from > on};
        }
      }
      begin_teeth(i);
    }
    const int n = l_.slices();
    for (int k = 0; k < places; ++k) {
      const double end = steps_.open[k + 1][places];
      if (const double s = gap_[n][k + 1].score + end; s > score_) score_ = s, last_ = k, ends_in_tooth_ = false;
      if (const double s = reached_[n][k].score + l_.change() + end; s > score_)
        score_ = s, last_ = k, ends_in_tooth_ = true;
    }
    if (gap_[n][0].score > score_) score_ = gap_[n][0].score, last_ = -1;
  }

  void end_teeth(int i) {
    for (int j = std::max(0, i - l_.longest()); j <= i - l_.shortest(); ++j) {
      const double tooth = l_.tooth(j, i);
      if (tooth == impossible) continue;
      const double log_width = std::log((i - j) * Strip::step);
      for (int k = 0; k < places; ++k) {
        const double z = log_width - log_mean_[k], s = before_[j][k].score + tooth - width_cost_ * z * z;
        if (s > reached_[i][k].score) reached_[i][k] = {s, j};
      }
    }
  }

  void begin_teeth(int j) {
    for (int k = 0; k < places; ++k)
      for (int a = -1; a < k; ++a) {
        Before &b = before_[j][k];
        if (const double s = gap_[j][a + 1].score + l_.change() + steps_.open[a + 1][k]; s > b.score) b = {s, a, false};
        if (a < 0) continue;
        if (const double s = reached_[j][a].score + l_.contact(j) + steps_.closed[a + 1][k]; s > b.score)
          b = {s, a, true};
      }
  }

  const Lattice &l_;
  const Steps &steps_;
  double width_cost_;
  std::size_t rows_;
  std::array<double, places> log_mean_;
  Vec<std::array<End, places>> reached_;
  Vec<std::array<Gap, places + 1>> gap_;
  Vec<std::array<Before, places>> before_;
  double score_ = impossible;
  int last_ = -1;
  bool ends_in_tooth_ = false;
};

// Probability of each tooth, its ends within 1 mm, if teeth nearby are as wide as the formula has them here.
void add_confidence(Lattice l, const FormulaCosts &costs, const Vec<double> &width, Vec<ToothSpan> &teeth) {
  const int n = l.slices(), near = static_cast<int>(1 / Strip::step);
  l.expected = width;
  l.width_cost = costs.width;
  const Marginals m = marginals(l);
  for (ToothSpan &t : teeth) {
    for (int j = std::max(0, t.from - near); j <= t.from + near; ++j)
      for (int i = std::max(j + l.shortest(), t.to - near); i <= std::min({n, t.to + near, j + l.longest()}); ++i) {
        const double before = log_add(m.gap_before[j] + l.change(), m.tooth_before[j] + l.contact(j));
        t.confidence += std::exp(before + l.tooth(j, i) + m.after_tooth[i] - m.total);
      }
    t.confidence = std::min(1.0, t.confidence);
  }
}

}  // namespace

Division best_division(const Lattice &l, const FormulaCosts &costs) {
  const Steps steps(costs);
  Division d;
  double best = impossible;
  for (const Jaw jaw : {Jaw::upper, Jaw::lower})
    for (const double size : sizes) {
      const Assignment a(l, jaw, size, costs, steps);
      if (a.score() > best) best = a.score(), d.jaw = jaw, d.size = size, d.teeth = a.spans();
    }
  if (d.teeth.empty()) return d;
  d.width.resize(l.slices() + 1);
  std::size_t k = 0;
  for (int i = 0; i <= l.slices(); ++i) {
    while (k + 1 < d.teeth.size() && i > (d.teeth[k].to + d.teeth[k + 1].from) / 2) ++k;
    d.width[i] = d.size * mean_width(d.jaw, d.teeth[k].place);
  }
  add_confidence(l, costs, d.width, d.teeth);
  return d;
}

Marginals marginals(const Lattice &l) {
  const int n = l.slices();
  Marginals m;
  m.tooth_before.assign(n + 1, impossible);
  m.gap_before = m.after_tooth = m.after_gap = m.tooth_before;
  m.gap_before[0] = 0;
  for (int i = 1; i <= n; ++i) {
    m.gap_before[i] = log_add(m.gap_before[i - 1], m.tooth_before[i - 1] + l.change()) + l.gap(i - 1);
    for (int j = std::max(0, i - l.longest()); j <= i - l.shortest(); ++j) {
      const double before = log_add(m.gap_before[j] + l.change(), m.tooth_before[j] + l.contact(j));
      m.tooth_before[i] = log_add(m.tooth_before[i], before + l.tooth(j, i));
    }
  }
  m.after_gap[n] = 0;
  m.after_tooth[n] = l.change();
  for (int j = n - 1; j >= 0; --j) {
    double next_tooth = impossible;
    for (int i = j + l.shortest(); i <= std::min(n, j + l.longest()); ++i)
      next_tooth = log_add(next_tooth, l.tooth(j, i) + m.after_tooth[i]);
    const double next_gap = l.gap(j) + m.after_gap[j + 1];
    m.after_gap[j] = log_add(next_gap, next_tooth + l.change());
    m.after_tooth[j] = log_add(next_gap + l.change(), next_tooth + l.contact(j));
  }
  m.total = log_add(m.gap_before[n], m.tooth_before[n] + l.change());
  return m;
}

Vec<std::size_t> span_cells(const Strip &strip, const ToothSpan &tooth, double off) {
  const auto tangent = [](int slant) {
    return slant < 0 ? 0 : std::tan(Slants::degrees(slant) * std::numbers::pi / 180);
  };
  constexpr int reach = static_cast<int>(8 / Strip::step);
  const double from_tan = tangent(tooth.from_slant), to_tan = tangent(tooth.to_slant);
  Vec<std::size_t> cells;
  for (int j = Strip::half - reach; j <= Strip::half + reach; ++j) {
    const double t = Strip::t(j);
    const double begin = tooth.from + (from_tan * t + off * std::hypot(1, from_tan)) / Strip::step;
    const double end = tooth.to + (to_tan * t - off * std::hypot(1, to_tan)) / Strip::step;
    for (int i = std::max(0, static_cast<int>(std::ceil(begin))); i <= std::min<double>(strip.slices - 1, end); ++i)
      if (const std::size_t c = strip.at(i, j); !std::isnan(strip.height[c])) cells.push_back(c);
  }
  return cells;
}

}  // namespace ts::features
