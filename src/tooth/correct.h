// What a person says about teeth that stand separated. Nothing is factorised again: points are nodes that come after
// the factorisation (field/border.h), and whom a node is held for is a matter of the right-hand side.
#pragma once

#include "tooth/session.h"

namespace ts::tooth {

// All of them give the teeth to be cut anew, those of `session` that the change touches included, and throw what
// make_group does, Fault::no_cut, Fault::locked where that would change a locked tooth, and Fault::no_change where
// what is said is so already.

// "This too": the disc of seed_radius around the point is held for `group`. On a feature point of another tooth that
// point is, if it is not its last.
Correction take_in(const Prepared &prepared, const Session &session, Index group, const mesh::SurfacePoint &at,
                   const Progress &progress);

// "Not this": the disc is held for the tooth that the field there is most of after `group`, or for the gingiva where
// that has more. On a feature point of the tooth that point is freed, if it is not its last.
Correction leave_out(const Prepared &prepared, const Session &session, Index group, const mesh::SurfacePoint &at,
                     const Progress &progress);

// Two teeth of one: its points that are nearer to `part` than to `kept` go to a group that is made, and each of the two
// discs is held for its own.
Correction divide(const Prepared &prepared, const Session &session, Index group, const mesh::SurfacePoint &kept,
                  const mesh::SurfacePoint &part, const Progress &progress);

// A point of the tooth elsewhere: the one at `from` is freed, and the disc at `to` held.
Correction move_point(const Prepared &prepared, const Session &session, Index group, const mesh::SurfacePoint &from,
                      const mesh::SurfacePoint &to, const Progress &progress);

// One tooth of two: the points of `other` are held for `group`.
Correction unite(const Prepared &prepared, const Session &session, Index group, Index other, const Progress &progress);

}  // namespace ts::tooth
