// From the fields of a click to its teeth.
#pragma once

#include "cut/region.h"
#include "cut/select.h"
#include "tooth/pick.h"

namespace ts::tooth {

// u of Eq. 3 for a click. `target` and `neighbour` are 1 on the tooth's own nodes and 0 on all that is held beside it;
// `u` = (1 - target + neighbour) / 2 is the paper's form: 0 on the target, 1 on the neighbour, and 1/2 on the rest of
// what is held. With the paper's pair alone, target + neighbour = 1 and u = neighbour.
struct Fields {
  Vec<double> target, neighbour, u;
};

Fields solve_fields(const Prepared &prepared, const Pick &pick);

// The cuts chosen on u: iso-values and, per vertex, phi < 0 on the tooth's side, about -1 deep inside.
struct Selection {
  double v_med = 0;
  double target_iso = 0, neighbour_iso = 0;
};

Selection select_cuts(const Prepared &prepared, const Pick &pick, const Fields &fields);

// The tooth of `group`; `iso` is of u. Throws Fault::no_cut.
Tooth extract_tooth(const Prepared &prepared, const Fields &fields, const Selection &selection, Index group,
                    bool is_target);

}  // namespace ts::tooth
