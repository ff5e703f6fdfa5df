// The fields of a click.
#pragma once

#include "tooth/pick.h"

namespace ts::tooth {

// u of Eq. 3 for a click, where it is asked for. `target` and `neighbour` are 1 on the tooth's own nodes and 0 on all
// that is held beside it; u = (1 - target + neighbour) / 2 is the paper's form: 0 on the target, 1 on the neighbour,
// and 1/2 on the rest of what is held. With the paper's pair alone, target + neighbour = 1 and u = neighbour. One task
// at a time may ask of each of the two; where `whole`, any number.
class Fields {
 public:
  Fields(const Prepared &prepared, const Pick &pick, bool whole);

  bool has_neighbour() const { return neighbour_.has_value(); }
  double target(Index v) { return target_(v); }
  double neighbour(Index v) { return neighbour_ ? (*neighbour_)(v) : 0 * target_(v); }  // NaN stays
  double own(Index v, bool of_target) { return of_target ? target(v) : neighbour(v); }
  double u(Index v) { return (1 - target(v) + neighbour(v)) / 2; }
  Vec<double> all_of_u();

  std::size_t bytes() const;    // of the factor read so far
  double milliseconds() const;  // that took: of the slower of the two where there are threads for both

 private:
  const Prepared &prepared_;
  field::Solution target_;
  std::optional<field::Solution> neighbour_;
};

// With everything else held, a tooth's own field decides: what it is does then not depend on the pair it was separated
// in, and nothing but the surroundings of the tooth is looked at. The paper's rule looks at the field of the pair,
// whole.
bool own_field_decides(const Options &options);

}  // namespace ts::tooth
