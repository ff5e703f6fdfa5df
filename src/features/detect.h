// Finds the teeth of a surface: occlusal direction, arch curve, feature points in groups, one a tooth.
#pragma once

#include "base/executor.h"
#include "base/progress.h"
#include "features/features.h"

namespace ts::features {

struct DetectOptions {
  unsigned max_points = 8;       // a tooth
  double radius = 2.0;           // of the convexity measure, mm
  Vec3 occlusal = Vec3::Zero();  // a direction to use instead of the estimated one; zero = estimate
};

// Throws Error{no_teeth} where nothing looks like a tooth.
Features detect(const mesh::Surface &surface, const DetectOptions &options, const Executor &executor,
                const Progress &progress);

}  // namespace ts::features
