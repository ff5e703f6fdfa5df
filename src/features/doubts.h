// What speaks against a scan being one arch with one occlusal side.
#pragma once

#include "features/arch.h"
#include "features/features.h"

namespace ts::features {

// The values of ts_features_warning.
enum Doubt : std::uint32_t {
  inside_out = 1,
  opposed = 2,
  several_arches = 4,
};

// Roughness is area x (|cv| - that of plain gingiva), as for the arch curve.
Looks looks_of(std::span<const geometry::Sample> samples, std::span<const double> convexity,
               const Orientation &orientation, const ArchCurve &curve, const Plan &plan);

}  // namespace ts::features
