// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dentition.h"
#include "trimesh.h"

namespace tsa {

struct Feature {
  uint32_t label, kind;
  Vec3 position;
};

struct Arch {
  TriMesh mesh;
  std::vector<uint32_t> labels;
  std::vector<uint32_t> fdi;
  std::vector<Feature> features;
};

Arch generate(const Settings &settings);

}  // namespace tsa
