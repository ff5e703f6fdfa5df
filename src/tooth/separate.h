// One click, from the point to its teeth.
#pragma once

#include "tooth/pick.h"
#include "tooth/segmenter.h"

namespace ts::tooth {

// The closest group. Throws click_off_surface, click_on_gingiva.
Pick take(const Prepared &prepared, const mesh::SurfacePoint &at);

// The teeth of a pick. Nothing if the target's tooth does not hold the click and its own field decides: then the click
// has to be looked at as evidence. Throws click_on_gingiva, no_cut.
std::optional<Click> separate(const Prepared &prepared, const mesh::SurfacePoint &at, const Pick &picked,
                              double pick_ms, const Progress &progress);

// The teeth of a click that separate() gave nothing for: those of the group that the field at the click is most of, or
// else of a group that is made of the click; that the click then was made among. Throws click_on_gingiva, no_cut.
Click separate_by_evidence(const Prepared &prepared, const mesh::SurfacePoint &at, std::span<const Index> separated,
                           Index target, double pick_ms, const Progress &progress);

}  // namespace ts::tooth
