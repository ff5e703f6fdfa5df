// Weights of the terms of a division (teeth.h), fitted by bench/features_fit.cpp (prior 0.3) to 15 labelled scans of 6
// sources, upper and lower, with 198 teeth, as they are, mirrored, noisy and in pieces. Dimensionless but for the
// slices, which count a mm.
#pragma once

#include "features/teeth.h"

namespace ts::features {

// clang-format off
inline constexpr Weights fitted_weights = {
    // contacts, anterior: bias, area_mean, area_least, notch, ridge, fine_ridge, valley, curvature, slant
    0.712, -3.37, -2.96, 0.648, -0.966, 1.62, -0.734, 2.21, -6.43,
    // contacts, posterior
    -1.39, -2.68, 0.292, -0.275, -1.17, 0.749, -3.25, 2.27, -1.7,
    // slices: bias, roughness, peak, fine_peak, drop, relief, hole
    -3.1, 3.08, 1.04, -1.01, -0.509, 1.32, 0.668,
    // a tooth, z, z^2, a change
    -1.5, 3.04, -2.42, -1.62};
// clang-format on

}  // namespace ts::features
