// Weights of the terms of a division (teeth.h).
#pragma once

#include "features/teeth.h"

namespace ts::features {

inline constexpr Weights fitted_weights = {
    // contacts, anterior: bias, area_mean, area_least, notch, ridge, fine_ridge, valley, curvature, slant
    1, -2, 0, 2, -4, -2, -8, 3, -0.5,
    // contacts, posterior
    -1, -6, -2, 0.5, -2, 0, -4, 1, -0.5,
    // slices, a mm: bias, roughness, peak, fine_peak, drop, relief, hole
    -2, 0.6, 1.0, 0.5, -0.8, 0.3, -1,
    // a tooth, z, z^2, change
    0, 0, -8, -1.5};

}  // namespace ts::features
