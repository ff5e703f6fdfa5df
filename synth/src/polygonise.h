// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dentition.h"
#include "trimesh.h"

namespace tsa {

// The surface of the dentition by marching tetrahedra on a grid of the given spacing: a manifold, open a little
// beyond the trim. The walk starts at a tooth and follows the surface, so that only cells on it are ever evaluated and
// the result is one piece.
TriMesh polygonise(const Dentition &dentition, double spacing);

}  // namespace tsa
