// What the division into teeth rests on: everything that is measured before any weight is applied.
#pragma once

#include "base/progress.h"
#include "features/detect.h"
#include "features/teeth.h"

namespace ts::features {

struct Analysis {
  Orientation orientation;
  Looks looks;
  Plan plan;
  TopView view;
  Strip strip;
  Evidence evidence;
};

Analysis analyse(const mesh::Surface &surface, const DetectOptions &options, const Executor &executor,
                 const Progress &progress);

// The division that `weights` prefer, with its points.
Features divide(const mesh::Surface &surface, const Analysis &analysis, const Weights &weights,
                const DetectOptions &options);

}  // namespace ts::features
