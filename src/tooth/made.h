// What clicks add to the groups: a crown without a feature point has none, and the click on it is one.
#pragma once

#include "mesh/surface_point.h"
#include "tooth/prepared.h"

namespace ts::tooth {

// `prepared` with one group more, the last: held on the disc of seed_radius around the click, put along the arch where
// it lengthens the way through the groups' centres least. Throws click_on_gingiva and no_cut where the
// gingiva or another group is held.
std::shared_ptr<const Prepared> make_group(const Prepared &prepared, const mesh::SurfacePoint &at);

// `prepared` with the disc held for `group` as well. Throws as make_group.
std::shared_ptr<const Prepared> extend_group(const Prepared &prepared, const mesh::SurfacePoint &at, Index group);

}  // namespace ts::tooth
