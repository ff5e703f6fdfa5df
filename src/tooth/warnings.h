// What looks wrong about a tooth that has been cut out, beside its area and its cut.
#pragma once

#include "tooth/prepared.h"
#include "tooth/tooth.h"

namespace ts::tooth {

// For each group the unit vector along the arch where its stretch of it is; zero if unknown (set by hand).
Vec<Vec3> along_the_arch(const features::Features &features);

// Warning::width and Warning::two_groups, from the tooth's vertices, and Warning::flat_top, from its faces.
std::uint32_t warnings_of_place(const Prepared &prepared, Index group, std::span<const Index> vertices);
std::uint32_t warnings_of_shape(const mesh::Surface &surface, std::span<const Index> faces, const Vec3 &occlusal,
                                bool inside_out);

}  // namespace ts::tooth
