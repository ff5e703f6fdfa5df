// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "vec3.h"

namespace tsa {

struct TriMesh {
  std::vector<Vec3> points;
  std::vector<std::array<uint32_t, 3>> faces;
};

}  // namespace tsa
