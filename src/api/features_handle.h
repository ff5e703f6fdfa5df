#pragma once

#include "api/model_handle.h"
#include "features/feature_set.h"

namespace ts::api {

struct FeaturesState {
  ModelPtr model;
  features::FeatureSet set;
  double ms = 0;  // of the detection
};

}  // namespace ts::api

struct ts_features {
  std::shared_ptr<const ts::api::FeaturesState> state;  // replaced as a whole by an edit
};
