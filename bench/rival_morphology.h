// Mathematical morphology on the vertices of a surface: what the skeleton method does to its feature region.
#pragma once

#include <limits>

#include "mesh/surface.h"

namespace ts::bench {

using mesh::Index;
using mesh::Surface;

using Mask = Vec<std::uint8_t>;  // a vertex: 1 if in the set

// mm along edges to the set, infinite beyond `reach`.
Vec<double> distance_to(const Surface &surface, const Mask &mask,
                        double reach = std::numeric_limits<double>::infinity());

// All within `radius` mm of the set, along edges.
Mask dilated(const Surface &surface, const Mask &mask, double radius);

// Dilation, then erosion: closes gaps of twice the radius. What lies outside the scan takes nothing away.
Mask closed(const Surface &surface, const Mask &mask, double radius);

// Takes connected pieces of less than `area` mm^2 out of the set, or (`of` 0) its holes into it.
void drop_small_pieces(const Surface &surface, Mask &mask, std::uint8_t of, double area);

// Thins the set to lines one vertex wide without joining or splitting what lies around it. Vertices of the least
// `priority` go first, so that the lines stay where it is greatest. Ends of lines go too: what is left separates. The
// outside of the scan counts as part of the set, so that a line may end at the scan's border.
void thin(const Surface &surface, Mask &mask, const Vec<double> &priority);

}  // namespace ts::bench
