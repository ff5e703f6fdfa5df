#include "features/teeth.h"

#include <algorithm>
#include <cmath>

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

double Lattice::log_width(int from, int to) const {
  return std::log((to - from) * Strip::step / mean_tooth_width((table_[to] - table_[from]) / (to - from)));
}

double Lattice::tooth(int from, int to) const {
  if (!starts.empty() && (starts[from] < 0 || starts[from] != ends[to])) return impossible;
  const double z = log_width(from, to);
  return slice_[to] - slice_[from] + bias_ + width_ * z + width2_ * z * z;
}

Vec<ToothSpan> best_division(const Lattice &l) {
  const int n = l.slices();
  // best score of a division up to a position that ends in a tooth / in a gap, and where that segment began
  Vec<double> tooth(n + 1, impossible), gap(n + 1, impossible);
  Vec<int> start(n + 1, -1);
  Vec<std::uint8_t> contact(n + 1, 0), gap_after_tooth(n + 1, 0);
  gap[0] = 0;
  for (int i = 1; i <= n; ++i) {
    const double from_tooth = tooth[i - 1] + l.change() + l.gap(i - 1), from_gap = gap[i - 1] + l.gap(i - 1);
    gap[i] = std::max(from_tooth, from_gap);
    gap_after_tooth[i] = from_tooth > from_gap;
    for (int j = std::max(0, i - l.longest()); j <= i - l.shortest(); ++j) {
      const double free = gap[j] + l.change(), touching = tooth[j] + l.contact(j), before = std::max(free, touching);
      if (before == impossible) continue;
      const double s = before + l.tooth(j, i);
      if (s > tooth[i]) tooth[i] = s, start[i] = j, contact[i] = touching > free;
    }
  }
  Vec<ToothSpan> teeth;
  bool in_tooth = tooth[n] + l.change() > gap[n];
  for (int i = n; i > 0;) {
    if (!in_tooth) {
      in_tooth = gap_after_tooth[i];
      --i;
      continue;
    }
    ToothSpan span{start[i], i, -1, -1, 0};
    if (contact[i]) span.from_slant = l.slant(start[i]);
    if (!teeth.empty() && teeth.back().from == i && teeth.back().from_slant >= 0)
      span.to_slant = teeth.back().from_slant;
    teeth.push_back(span);
    in_tooth = contact[i];
    i = start[i];
  }
  std::reverse(teeth.begin(), teeth.end());

  const Marginals m = marginals(l);
  const int near = static_cast<int>(1 / Strip::step);
  for (ToothSpan &t : teeth)
    for (int j = std::max(0, t.from - near); j <= t.from + near; ++j)
      for (int i = std::max(j + l.shortest(), t.to - near); i <= std::min({n, t.to + near, j + l.longest()}); ++i) {
        const double before = log_add(m.gap_before[j] + l.change(), m.tooth_before[j] + l.contact(j));
        t.confidence += std::exp(before + l.tooth(j, i) + m.after_tooth[i] - m.total);
      }
  for (ToothSpan &t : teeth) t.confidence = std::min(1.0, t.confidence);
  return teeth;
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

}  // namespace ts::features
