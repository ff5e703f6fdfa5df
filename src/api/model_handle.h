#pragma once

#include "api/handles.h"
#include "mesh/intake.h"

namespace ts::api {

struct ModelState {
  ContextPtr context;
  mesh::Model model;
  double ms = 0;  // of intake, reading included

  mesh::SurfacePoint nearest(const mesh::Vec3 &p) const { return model.nearest(p); }
};

using ModelPtr = std::shared_ptr<const ModelState>;

}  // namespace ts::api

struct ts_model {
  ts::api::ModelPtr state;
};
