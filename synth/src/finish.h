// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "trimesh.h"

namespace tsa {

// Cuts off what lies beyond the trim and hangs on the border of `mesh`, then whatever would make the new rim
// pinched or frayed. A closed mesh comes back as it is.
TriMesh trimmed(const TriMesh &mesh, const std::function<double(Vec3)> &trim);

// Gives specks of a label to the label around them: every tooth and the gingiva keep their largest piece.
void removeSpecks(const TriMesh &mesh, std::vector<uint32_t> &labels, uint32_t labelCount);

// Vertices - edges + faces: 2 for a closed surface without handles, 1 with one rim.
int64_t eulerCharacteristic(const TriMesh &mesh);

double meanEdge(const TriMesh &mesh);

// Gaussian, `sigma` in mm.
void addNoise(TriMesh &mesh, double sigma, bool isotropic, uint64_t seed);

}  // namespace tsa
