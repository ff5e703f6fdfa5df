// Fits the weights of the division into teeth (src/features/weights.h) to labelled scans.
//   bench_features_fit [--prior P] [--out] [--synthetic] FOLDER...
// The model is a semi-Markov conditional random field: a division's probability is exp(score) over the sum of all. The
// weights maximise the log-probability of the labelled division (its cuts free within a tolerance) less a quadratic
// prior. The dental formula takes no part: given the true places, its widths would make splitting seem dear, and the
// fit would make up for it. Each scan is used as it is, mirrored, noisy and in pieces. --out: also fits without each
// source (the part of a scan's name before the first dash) and scores that source.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <map>
#include <numbers>
#include <set>

#include "bench/features_score.h"
#include "bench/scan_variants.h"
#include "bench/synthetic_scan.h"
#include "features/analysis.h"
#include "features/weights.h"

namespace {

using namespace ts;
using features::Strip;
using features::Term;
using features::Weights;

constexpr int contact_tolerance = static_cast<int>(1.0 / Strip::step),
              end_tolerance = static_cast<int>(1.5 / Strip::step);

struct Scan {
  bench::ScanFolder folder;
  features::Analysis analysis;
  Vec<int> starts, ends;  // as in Lattice
  Vec<std::uint8_t> gap_allowed;
  bool whole = true;  // no variant: counts in the scores

  features::Lattice lattice(const Weights &w, bool known) const {
    features::Lattice l(analysis.evidence, w);
    if (known) l.starts = starts, l.ends = ends, l.gap_allowed = gap_allowed;
    return l;
  }
};

struct Truth {
  int label = 0, cells = 0;
  double middle = 0;
  int from = 0, to = 0;
  bool from_contact = false, to_contact = false;
};

// The boundary between two labelled teeth: the slanted line with fewest cells on the wrong side; the range of lines
// that do equally well tells a contact from a gap.
void part(const std::map<int, Vec<std::pair<int, int>>> &cells, Truth &left, Truth &right) {
  int fewest = 1 << 30, first = 0, last = 0;
  for (int k = 0; k < features::Slants::count; ++k) {
    const double tangent = std::tan(features::Slants::degrees(k) * std::numbers::pi / 180);
    std::map<int, int> change;  // of the errors, from one line to the next
    int errors = 0;
    for (const auto &[i, j] : cells.at(left.label))
      ++errors, --change[i - static_cast<int>(std::lround(Strip::t(j) * tangent / Strip::step)) + 1];
    for (const auto &[i, j] : cells.at(right.label))
      ++change[i - static_cast<int>(std::lround(Strip::t(j) * tangent / Strip::step)) + 1];
    for (auto c = change.begin(); c != change.end(); ++c) {
      errors += c->second;
      const int next = std::next(c) == change.end() ? c->first + 1 : std::next(c)->first;
      if (errors < fewest || (errors == fewest && next - c->first > last - first))
        fewest = errors, first = c->first, last = next;
    }
  }
  if ((last - first) * Strip::step > 2) {
    left.to = first, right.from = last;
    return;
  }
  left.to = right.from = (first + last) / 2;
  left.to_contact = right.from_contact = true;
}

void add_truth(Scan &scan) {
  const features::Analysis &a = scan.analysis;
  std::map<int, Vec<std::pair<int, int>>> cells;
  for (int i = 0; i < a.strip.slices; ++i)
    for (int j = Strip::half - 28; j <= Strip::half + 28; ++j) {
      const mesh::Index f = a.view.face(a.strip.plan_point(i, Strip::t(j)));
      if (f != mesh::none && scan.folder.label[f]) cells[std::abs(scan.folder.label[f])].push_back({i, j});
    }
  Vec<Truth> teeth;
  for (auto &[label, c] : cells) {
    if (c.size() < 60) continue;
    Truth t;
    t.label = label;
    Vec<int> along;
    for (const auto &[i, j] : c) along.push_back(i), t.middle += i;
    t.middle /= static_cast<double>(c.size());
    std::sort(along.begin(), along.end());
    t.from = along[along.size() / 50];
    t.to = along[along.size() - 1 - along.size() / 50] + 1;
    teeth.push_back(t);
  }
  std::sort(teeth.begin(), teeth.end(), [](const Truth &x, const Truth &y) { return x.middle < y.middle; });
  for (std::size_t k = 0; k + 1 < teeth.size(); ++k) part(cells, teeth[k], teeth[k + 1]);
  const int n = a.strip.slices;
  scan.starts.assign(n + 1, -1);
  scan.ends.assign(n + 1, -1);
  scan.gap_allowed.assign(n, 1);
  for (std::size_t k = 0; k < teeth.size(); ++k) {
    const Truth &t = teeth[k];
    const int begin = t.from_contact ? contact_tolerance : end_tolerance,
              end = t.to_contact ? contact_tolerance : end_tolerance;
    for (int i = std::max(0, t.from - begin); i <= std::min(n, t.from + begin); ++i)
      scan.starts[i] = static_cast<int>(k);
    for (int i = std::max(0, t.to - end); i <= std::min(n, t.to + end); ++i) scan.ends[i] = static_cast<int>(k);
    for (int i = t.from + begin; i < t.to - end; ++i) scan.gap_allowed[i] = 0;
  }
}

void add_scan(std::deque<Scan> &scans, bench::ScanFolder folder, bool whole, const Executor &executor) {
  features::Analysis analysis = features::analyse(folder.surface, {}, executor, {});
  Scan scan{std::move(folder), std::move(analysis), {}, {}, {}, whole};
  add_truth(scan);
  const Weights zero{};
  if (features::marginals(scan.lattice(zero, true)).total == features::Lattice::impossible) {
    std::fprintf(stderr, "%s, a variant: its labels allow no division, left out\n", scan.folder.name.c_str());
    return;
  }

  scans.push_back(std::move(scan));
}

// Log-sum of a lattice and, times `sign`, the expectation of its terms.
double expectation(const features::Lattice &l, const features::Evidence &e, double sign, Weights &sum) {
  const features::Marginals m = features::marginals(l);
  const int n = l.slices();
  Vec<double> contact(n + 1, 0), slice(n + 1, 0);
  for (int j = 0; j < n; ++j) {
    const double free = m.gap_before[j] + l.change(), touching = m.tooth_before[j] + l.contact(j);
    const double most = std::max(free, touching);
    if (most == features::Lattice::impossible) continue;
    const double before = most + std::log(std::exp(free - most) + std::exp(touching - most)),
                 share = std::exp(touching - before);
    for (int i = j + l.shortest(); i <= std::min(n, j + l.longest()); ++i) {
      const double p = std::exp(before + l.tooth(j, i) + m.after_tooth[i] - m.total);
      if (p == 0) continue;
      contact[j] += p * share;
      sum[Term::change] += sign * 2 * p * (1 - share);
      slice[i] += p;
      slice[j] -= p;
      const double z = l.log_width(j, i);
      sum[Term::tooth] += sign * p;
      sum[Term::width] += sign * p * z;
      sum[Term::width2] += sign * p * z * z;
    }
  }
  for (int i = 0; i <= n; ++i) {
    for (int k = 0; k < features::slice_terms; ++k) sum[Term::slice + k] += sign * slice[i] * e.slice[i][k];
    if (contact[i] == 0 || i == n) continue;
    const features::CutTerms &t = e.cut[static_cast<std::size_t>(i) * features::Slants::count + l.slant(i)];
    for (int k = 0; k < features::cut_terms; ++k) sum[Term::cut + k] += sign * contact[i] * t[k];
  }
  return m.total;
}

// Of all scans but those of `without`: minus the log-probability plus the prior.
double objective(const std::deque<Scan> &scans, const std::string &without, const Weights &w, const Weights &start,
                 double prior, Weights &gradient) {
  double value = 0;
  for (int k = 0; k < Term::count; ++k) {
    const double d = w[k] - start[k];
    value += prior * d * d / 2;
    gradient[k] = prior * d;
  }
  for (const Scan &s : scans) {
    if (!without.empty() && s.folder.name.starts_with(without + "-")) continue;
    value += expectation(s.lattice(w, false), s.analysis.evidence, 1, gradient);
    value -= expectation(s.lattice(w, true), s.analysis.evidence, -1, gradient);
  }
  return value;
}

double dot(const Weights &a, const Weights &b) {
  double sum = 0;
  for (int k = 0; k < Term::count; ++k) sum += a[k] * b[k];
  return sum;
}

// Limited-memory BFGS with backtracking. The choice of slant per position makes the objective piecewise smooth only; a
// step that does not descend ends the search.
Weights fit(const std::deque<Scan> &scans, const std::string &without, double prior, int rounds) {
  const Weights start{};
  Weights w = features::fitted_weights, g{};
  double value = objective(scans, without, w, start, prior, g);
  std::deque<std::pair<Weights, Weights>> memory;
  for (int round = 0; round < rounds; ++round) {
    Weights d = g;
    Vec<double> alpha;
    for (auto m = memory.rbegin(); m != memory.rend(); ++m) {
      alpha.push_back(dot(m->first, d) / dot(m->first, m->second));
      for (int k = 0; k < Term::count; ++k) d[k] -= alpha.back() * m->second[k];
    }
    const double scale = memory.empty() ? 0.1 / std::sqrt(dot(g, g))
                                        : dot(memory.back().first, memory.back().second) /
                                              dot(memory.back().second, memory.back().second);
    for (double &x : d) x *= scale;
    for (auto m = memory.begin(); m != memory.end(); ++m) {
      const double beta = dot(m->second, d) / dot(m->first, m->second),
                   a = alpha[static_cast<std::size_t>(memory.end() - m) - 1];
      for (int k = 0; k < Term::count; ++k) d[k] += (a - beta) * m->first[k];
    }
    double step = 1, next = 0;
    Weights trial{}, trial_g{};
    for (int half = 0; half < 12; ++half, step /= 2) {
      for (int k = 0; k < Term::count; ++k) trial[k] = w[k] - step * d[k];
      next = objective(scans, without, trial, start, prior, trial_g);
      if (next < value - 1e-4 * step * dot(g, d)) break;
    }
    if (!(next < value)) break;
    Weights s{}, y{};
    for (int k = 0; k < Term::count; ++k) s[k] = trial[k] - w[k], y[k] = trial_g[k] - g[k];
    if (dot(s, y) > 1e-9) memory.push_back({s, y});
    if (memory.size() > 10) memory.pop_front();
    const bool done = value - next < 1e-3;
    w = trial, g = trial_g, value = next;
    if (done) break;
  }
  std::fprintf(stderr, "without '%s': %.2f\n", without.c_str(), value);
  return w;
}

bench::FeatureScore score(const Scan &s, const Weights &w, bool verbose) {
  const features::Features found = features::divide(s.folder.surface, s.analysis, w, {});
  return bench::score_features(s.folder, found, verbose);
}

}  // namespace

int main(int argc, char **argv) {
  double prior = 0.2;
  bool out = false;
  std::deque<Scan> scans;
  std::set<std::string> sources;
  const Executor executor(2);
  for (int a = 1; a < argc; ++a) {
    if (!std::strcmp(argv[a], "--prior") && a + 1 < argc) {
      prior = std::atof(argv[++a]);
    } else if (!std::strcmp(argv[a], "--synthetic")) {
      for (const bool upper : {true, false})
        for (const double crowding : {0.0, 0.35, 0.65, 1.0})
          add_scan(scans, bench::synthetic_scan(upper, crowding, 101, {}, 30000), false, executor);
    } else if (!std::strcmp(argv[a], "--out")) {
      out = true;
    } else {
      const bench::ScanFolder folder = bench::read_scan_folder(argv[a]);
      if (folder.label.empty()) continue;
      sources.insert(folder.name.substr(0, folder.name.find('-')));
      for (const bench::Variant v : {bench::Variant::as_is, bench::Variant::mirrored, bench::Variant::noise_10,
                                     bench::Variant::left_half, bench::Variant::right_half, bench::Variant::front})
        add_scan(scans, bench::make_variant(folder, v, 11), v == bench::Variant::as_is, executor);
    }
  }
  const Weights w = fit(scans, "", prior, 200);
  for (int k = 0; k < Term::count; ++k)
    std::printf("%s%.3g,%s", k ? " " : "", w[k],
                k == features::CutMeasure::count - 1 || k == Term::slice - 1 || k == Term::tooth - 1 ? "\n" : "");
  std::printf("\n");
  bench::FeatureScore total;
  for (const Scan &s : scans) {
    if (!s.whole) continue;
    const bench::FeatureScore one = score(s, w, true);
    one.print(s.folder.name.c_str());
    total.add(one);
  }
  total.print("all, fitted on all");
  if (!out) return 0;
  bench::FeatureScore left_out;
  for (const std::string &source : sources) {
    const Weights v = fit(scans, source, prior, 100);
    for (const Scan &s : scans) {
      if (!s.whole || !s.folder.name.starts_with(source + "-")) continue;
      const bench::FeatureScore one = score(s, v, true);
      one.print((s.folder.name + " *").c_str());
      left_out.add(one);
    }
  }
  left_out.print("each source left out");
}
