// Weights of the terms of a division (teeth.h), fitted by bench/features_fit.cpp (--prior 0.5 --synthetic) to 15
// labelled scans of 6 sources, upper and lower, with 198 teeth (as they are, mirrored, noisy and in pieces) and, for
// crowding, to 8 synthetic arches. With the source of a scan left out of the fit they own as many of its teeth (197 of
// 198). Dimensionless but for the slices, which count a mm.
#pragma once

#include "features/teeth.h"

namespace ts::features {

// clang-format off
inline constexpr Weights fitted_weights = {
    // contacts, anterior: bias, area_mean, area_least, notch, ridge, fine_ridge, valley, curvature, slant
    0.276, -3.69, -3.03, 1.41, -0.467, 1.6, -1.72, 1.1, -4.83,
    // contacts, posterior
    -0.795, -2.22, 0.311, -0.0675, -1.23, 0.628, -3.03, 2.31, -1.87,
    // slices: bias, roughness, peak, fine_peak, drop, relief, hole
    -3.04, 3.03, 1.01, -0.889, -0.523, 1.19, 0.465,
    // a tooth, z, z^2, a change
    -1.31, 2.94, -2.81, -1.58};
// clang-format on

}  // namespace ts::features
