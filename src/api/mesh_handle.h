#pragma once

#include "api/segmentation_handle.h"
#include "tooth/tooth_mesh.h"

namespace ts::api {

struct MeshState {
  ContextPtr context;
  tooth::PartMesh part;
  uint32_t label = 0;
  double lost = 0;  // mm^2
};

}  // namespace ts::api

struct ts_mesh {
  std::shared_ptr<const ts::api::MeshState> state;
};
