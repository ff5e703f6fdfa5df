// Contours of a scalar field that is linear on each face, and how good they are as cuts.
#pragma once

#include <span>

#include "cut/space.h"

namespace ts::cut {

// The contour u = iso within some faces (ascending) as polylines, with u < iso on their left (seen from outside); lines
// that leave the faces are open there. Faces with a NaN are not crossed. A vertex with u = iso counts as above it, so
// that lines never meet.
Vec<Polyline> contour(const Surface &surface, Values u, double iso, std::span<const Index> among);

// Means along a line or a whole contour.
struct Score {
  double length = 0;     // mm
  double gradient = 0;   // |grad u|, 1/mm
  double concavity = 0;  // c^2 / (c^2 + 0.25): near 1 in seams, near 0 elsewhere
  double harmonic = 0;   // harmonic mean of |grad u|
};

Score score(const Surface &surface, Values u, std::span<const double> concavity, std::span<const Polyline> lines);

// The concavity of a score along one line.
double mean_concavity(std::span<const double> concavity, const Polyline &line);

// Iso-value k of n, spread evenly inside (0, 1): neither end value is one.
inline double iso_value(std::size_t k, std::size_t n) {
  return static_cast<double>(k + 1) / static_cast<double>(n + 1);
}

// Of each of n iso-values the faces that its contour crosses, ascending, in one pass over the faces.
Vec<Vec<Index>> crossed_faces(const Surface &surface, std::span<const double> u, std::size_t n);

// The scores of the whole contours of all n iso-values, in one pass over the faces.
Vec<Score> score_all(const Surface &surface, std::span<const double> u, std::span<const double> concavity,
                     std::size_t n);

}  // namespace ts::cut
