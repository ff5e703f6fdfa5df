// One click, from the point to its teeth.
#pragma once

#include "tooth/pick.h"
#include "tooth/segmenter.h"

namespace ts::tooth {

// The closest group. Throws click_off_surface, click_on_gingiva.
Pick take(const Prepared &prepared, const mesh::SurfacePoint &at);

// The teeth of a pick. `evidence`: the target's tooth does not hold the click and its own field decides, so that the
// click has to be looked at as evidence. Throws click_on_gingiva, no_cut.
Click separate(const Prepared &prepared, const mesh::SurfacePoint &at, const Pick &picked, double pick_ms,
               const Progress &progress, bool &evidence);

// The teeth of a click that is not on the `first` ones: those of the group that the field at the click is most of; or
// the first ones after all, if the click is at their edge; or those with the click held for the target as well, if it
// lies on a shelf of it; or else of a group that is made of the click. In the last two the click then was made among
// these groups. Throws click_on_gingiva, no_cut.
Click separate_by_evidence(const Prepared &prepared, const mesh::SurfacePoint &at, std::span<const Index> separated,
                           Click first, double pick_ms, const Progress &progress);

// The teeth of a pick, whatever lies under the click. Throws no_cut.
Click cut_out(const Prepared &prepared, const mesh::SurfacePoint &at, const Pick &picked, double pick_ms,
              const Progress &progress);

// Only the target's.
Tooth cut_out_target(const Prepared &prepared, const Pick &picked, const Progress &progress);

// Whose most of the field at a point is, `group` left out: another group, or gingiva_group.
Index strongest_beside(const Prepared &prepared, const mesh::SurfacePoint &at, Index group);

}  // namespace ts::tooth
