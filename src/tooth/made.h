// Changes to whom the points are held for, on a copy of what clicks share.
#pragma once

#include "mesh/surface_point.h"
#include "tooth/prepared.h"

namespace ts::tooth {

// `prepared` with one group more, the last: held on the disc of seed_radius around the click, put along the arch where
// it lengthens the way through the groups' centres least. Throws click_on_gingiva and no_cut where the
// gingiva or another group is held.
std::shared_ptr<const Prepared> make_group(const Prepared &prepared, const mesh::SurfacePoint &at);

// `prepared` with the disc held for `group`, which may be gingiva_group, as well. Throws as make_group.
std::shared_ptr<const Prepared> extend_group(const Prepared &prepared, const mesh::SurfacePoint &at, Index group);

// In place, for several changes at once.
Index add_group(Prepared &prepared);  // without a point yet
void add_node(Prepared &prepared, const mesh::SurfacePoint &at, Index group);
void hold_added(Prepared &prepared);  // after the last of these
void regroup(Prepared &prepared, Index node, Index group);
void let_go(Prepared &prepared, Index node);  // as an outlier
void hold(Prepared &prepared, Index node);    // an outlier again

}  // namespace ts::tooth
