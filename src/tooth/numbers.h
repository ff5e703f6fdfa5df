// The numbers of a segmentation's teeth: what the caller has set, and what follows from it and the arch.
#pragma once

#include "tooth/arch_row.h"

namespace ts::tooth {

struct NumberOptions {
  std::optional<Jaw> jaw;
  bool mirrored = false;
  double least_confidence = 0.9;  // under which a number or a jaw counts as uncertain
};

// A value: copied, changed and put in place. Numbers stay as they are until they are assigned again.
class Numbers {
 public:
  struct Number {
    Index group = mesh::none;
    std::uint32_t fdi = 0;
    double confidence = 0;
    bool by_hand = false;
  };
  struct JawNumber {
    Jaw jaw = Jaw::upper;
    double confidence = 0;
    bool given = false;  // by the options, or by a number that was set
  };

  const NumberOptions &options() const { return options_; }
  bool assigned() const { return !numbers_.empty(); }
  const Vec<Number> &numbers() const { return numbers_; }  // along the arch
  const Number *number(Index group) const;                 // nullptr if it has none
  const JawNumber &jaw() const { return jaw_; }
  bool uncertain(double confidence) const { return confidence < options_.least_confidence; }

  // All of these throw and change nothing: too_many_teeth, number_order, and where said others.
  // `groups` in the order of the arch, a tooth of `row` each. Numbers set for groups that are not among them are
  // forgotten. Throws number_jaw where one that stays is of the other jaw than the options give.
  void assign(const ArchRow &row, std::span<const Index> groups, const NumberOptions &options);
  // The other numbers follow. Throws invalid_argument (no FDI number), number_jaw, number_taken.
  void set(const ArchRow &row, std::span<const Index> groups, Index group, std::uint32_t fdi);
  // Throws not_found if it has not been set by hand.
  void forget(const ArchRow &row, std::span<const Index> groups, Index group);

 private:
  struct ByHand {
    Index group;
    std::uint32_t fdi;
  };
  void work_out(const ArchRow &row, std::span<const Index> groups, const NumberOptions &options, Vec<ByHand> by_hand);

  NumberOptions options_;
  Vec<ByHand> by_hand_;
  Vec<Number> numbers_;
  JawNumber jaw_;
};

}  // namespace ts::tooth
