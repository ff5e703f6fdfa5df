// From the fields of a click to its teeth.
#pragma once

#include <limits>

#include "cut/select.h"
#include "tooth/region.h"

namespace ts::tooth {

// The cuts chosen on u: iso-values, NaN where there is none.
struct Selection {
  double target_iso = std::numeric_limits<double>::quiet_NaN();
  double neighbour_iso = std::numeric_limits<double>::quiet_NaN();
};

// By the paper's rule, on the field of the pair.
Selection select_cuts(const Prepared &prepared, const Pick &pick, Fields &fields);
Region pair_region(const Prepared &prepared, Fields &fields, double iso, Index group, bool is_target);

// The tooth of `group`, what is measured on u along its cuts left out. Throws Fault::no_cut.
Tooth extract_tooth(const Prepared &prepared, Fields &fields, Region region, Index group, bool is_target);

// What follows from the faces of a tooth and the lines of its loops: vertices, area, concavities, warnings.
void take_stock(const Prepared &prepared, Tooth &tooth, cut::Space &space);

// Gradients on u along the cuts of a tooth of the click.
void measure_cuts(const Prepared &prepared, Fields &fields, Tooth &tooth);

// From the tooth's own field on its faces and from its loops.
void set_confidence(const Prepared &prepared, Fields &fields, bool is_target, Tooth &tooth);

}  // namespace ts::tooth
