// Edits of a tooth's cut by hand: values that can be kept, and applied again to the tooth of another click.
#pragma once

#include <span>
#include <string>

#include "base/error.h"
#include "tooth/prepared.h"
#include "tooth/tooth.h"

namespace ts::tooth {

// The values of ts_edit_kind.
enum class EditKind : std::uint32_t { drag = 1, draw = 2, offset = 3, smooth = 4 };

struct CutEdit {
  EditKind kind = EditKind::drag;
  Vec<Vec3> points;   // drag: where the line was taken, where to; draw: the stroke
  double amount = 0;  // mm. drag: half the length of the stretch, 0 = as long as the drag and at least kHalfStretch;
                      // offset: outwards; smooth: the radius
};

// As far on either side as the minimum cut looks for the valley (Options::refine_band): about the distance between two
// line angles of a molar. mm.
inline constexpr double kHalfStretch = 2.5;

// Radii from which on a molar's cut (some 10 by 10 mm) is a circle say nothing any more. mm.
inline constexpr double kMostSmoothing = 2;

// What an edit looks at beside the tooth.
struct Surroundings {
  std::span<const Tooth *const> others;                   // the other teeth that stand separated
  FunctionRef<mesh::SurfacePoint(const Vec3 &)> nearest;  // the surface point nearest to a position
};

// Throws invalid_argument (numbers), click_off_surface, and
//   edit_nothing   the edit has no length
//   edit_off_cut   it does not come near the cut
//   edit_on_tooth  it comes to lie on another tooth, or takes in its points
//   edit_crossing  the new line would cross the rest of the cut, or part seeds from the tooth
//   edit_no_loop   a loop would vanish or become several.
// What is measured on the field of a click (gradients, confidence) is not set.
Tooth apply_edit(const Prepared &prepared, const Tooth &tooth, const CutEdit &edit, const Surroundings &around);

// An edit of a tooth, as it is kept.
struct EditRecord {
  CutEdit edit;
  bool dropped = false;  // could not be applied again
  Fault fault = Fault::internal;
  std::string why;
};

// All that can be applied, one after the other; the others are marked as dropped.
Tooth apply_edits(const Prepared &prepared, Tooth tooth, std::span<EditRecord> edits, const Surroundings &around);

}  // namespace ts::tooth
