// Sets of faces: grown from seeds, holes filled.
#pragma once

#include <span>

#include "cut/polyline.h"

namespace ts::cut {

// A face: 1 inside, 0 outside.
using Mask = Vec<std::uint8_t>;

// The connected sets of faces with mean phi < 0 that touch a seed vertex. Faces with a NaN are outside.
Mask grow(const Surface &surface, std::span<const double> phi, std::span<const Index> seeds);

// Leaves only the connected sets of faces inside that touch a seed vertex.
void keep_seeded(const Surface &surface, std::span<const Index> seeds, Mask &inside);

// Takes in what is enclosed: connected sets of faces outside, of at most `area` mm^2, without a vertex that is
// `foreign` (1 a vertex: seeds of other teeth) and without an edge on a border of the scan.
void fill_holes(const Surface &surface, double area, std::span<const std::uint8_t> foreign, Mask &inside);

Vec<Index> faces_of(const Mask &inside);
Vec<Index> vertices_of(const Surface &surface, std::span<const Index> faces);
double area_of(const Surface &surface, std::span<const Index> faces);
bool touches_border(const Surface &surface, std::span<const Index> faces);

}  // namespace ts::cut
