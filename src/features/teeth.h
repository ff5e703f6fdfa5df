// The teeth along the arch: the best division of the strip into teeth and gaps, by dynamic programming.
#pragma once

#include <limits>

#include "features/evidence.h"
#include "features/formula.h"

namespace ts::features {

// A division scores the sum of its terms, weighed:
//   contacts: CutTerms of the cut between two teeth; slices: SliceTerms summed over the teeth;
//   a tooth: 1, z, z^2 with z = log(width / mean width for its occlusal table); a change between tooth and gap: 1.
struct Term {
  static constexpr int cut = 0, slice = cut + cut_terms, tooth = slice + slice_terms, width = tooth + 1,
                       width2 = width + 1, change = width2 + 1, count = change + 1;
};
using Weights = std::array<double, Term::count>;

// Widths of teeth along the arch, mm.
inline constexpr double least_tooth = 3.0, most_tooth = 14.0;
double mean_tooth_width(double table);

// All divisions of a strip and their scores; positions 0 to slices are the boundaries between slices.
class Lattice {
 public:
  static constexpr double impossible = -std::numeric_limits<double>::infinity();

  Lattice(const Evidence &evidence, const Weights &weights);

  int slices() const { return evidence_->slices; }
  int slant(int position) const { return slant_[position]; }
  double contact(int position) const { return contact_[position]; }
  double change() const { return change_; }
  double tooth(int from, int to) const;  // impossible outside the range of widths
  double gap(int slice) const { return gap_allowed.empty() || gap_allowed[slice] ? 0 : impossible; }
  double table(int from, int to) const;      // mean width of the occlusal table, mm
  double log_width(int from, int to) const;  // z
  static int shortest() { return static_cast<int>(least_tooth / Strip::step); }
  static int longest() { return static_cast<int>(most_tooth / Strip::step); }

  // What is known of the answer (for fitting): a tooth may only run from starts[from] to ends[to] if these are equal
  // and not negative. Empty: nothing is known.
  Vec<int> starts, ends;
  Vec<std::uint8_t> gap_allowed;
  // Widths to expect, mm, by the slice in a tooth's middle, and what departures cost. Empty: nothing is expected.
  Vec<double> expected;
  double width_cost = 0;

 private:
  const Evidence *evidence_;
  Vec<double> contact_, slice_, table_;
  Vec<int> slant_;
  double bias_, width_, width2_, change_;
};

struct ToothSpan {
  int from = 0, to = 0;                // slices
  int from_slant = -1, to_slant = -1;  // of the cuts; -1 = towards a gap or an end, straight
  int place = 0;                       // in the dental formula, counted from the strip's beginning
  double confidence = 0;               // probability of exactly this tooth, its ends within 1 mm, under the model
};

// Cells of the strip, as Strip::at gives them, that lie between the span's cuts, `off` mm from each, on a surface and
// within 8 mm of the curve; column by column.
Vec<std::size_t> span_cells(const Strip &strip, const ToothSpan &tooth, double off);

struct Division {
  Vec<ToothSpan> teeth;
  Jaw jaw = Jaw::upper;
  double size = 1;    // of the teeth against the means
  Vec<double> width;  // a position: the width the formula expects of a tooth around it, mm
};

// The best division with places of the dental formula, over both jaws and several sizes.
Division best_division(const Lattice &lattice, const FormulaCosts &costs = {});

// Log-sums over all divisions of what lies before and after a position, by whether a tooth or a gap ends there.
struct Marginals {
  Vec<double> tooth_before, gap_before;  // ... the last segment before the position is a tooth / is (or may be) gap
  Vec<double> after_tooth, after_gap;    // ... given that the segment before is a tooth / gap
  double total = 0;
};
Marginals marginals(const Lattice &lattice);

}  // namespace ts::features
