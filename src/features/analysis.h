// What the division into teeth rests on: everything that is measured before any weight is applied.
#pragma once

#include "base/progress.h"
#include "features/detect.h"
#include "features/evidence.h"

namespace ts::features {

struct Analysis {
  Orientation looks;
  Plan plan;
  TopView view;
  Strip strip;
  Evidence evidence;
};

Analysis analyse(const mesh::Surface &surface, const DetectOptions &options, const Executor &executor,
                 const Progress &progress);

}  // namespace ts::features
