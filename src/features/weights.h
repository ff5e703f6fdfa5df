// Weights of the terms of a division (teeth.h), fitted by bench/features_fit.cpp (prior 0.2) to 15 labelled scans of 6
// sources, upper and lower, with 198 teeth. Fitted without a source they do as well on it. Dimensionless but for the
// slices, which count a mm.
#pragma once

#include "features/teeth.h"

namespace ts::features {

// clang-format off
inline constexpr Weights fitted_weights = {
    // contacts, anterior: bias, area_mean, area_least, notch, ridge, fine_ridge, valley, curvature, slant
    0.545, -2.79, -3.01, 1.87, -0.147, -0.0962, -0.54, 1.89, -3.52,
    // contacts, posterior
    -1.06, -0.841, -0.986, 0.4, -0.882, -0.554, -1.17, 2.97, -2.99,
    // slices: bias, roughness, peak, fine_peak, drop, relief, hole
    -3.1, 2.6, 2.15, -0.959, -1.3, 2.34, -2.35,
    // a tooth, z, z^2, a change
    -1.48, 2.66, -3.4, -1.96};
// clang-format on

}  // namespace ts::features
