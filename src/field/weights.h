// Edge weights of the Laplacian (paper, "Selection of weighting scheme").
#pragma once

#include "base/executor.h"
#include "mesh/surface.h"

namespace ts::field {

enum class Scheme {
  concavity,  // beta + (1 - beta) exp(-max(c_i, c_j) / c0), c the concavity at a physical radius
  paper,      // Eq. 8 with the test of Eq. 9
  cotangent,  // paper ref. 39, clamped
  uniform,    // 1
  feature,    // as paper ref. 40: Eq. 8 without the test; what is curved either way conducts less
};

struct WeightOptions {
  Scheme scheme = Scheme::concavity;
  double beta = 1e-3, gamma = 1e-4, theta = 0.2, c0 = 0.07;
  bool inside_out = false;  // the faces look inwards
};

// A weight an edge of the surface; every one is positive. `concavity` (a vertex, 1/mm) is read by Scheme::concavity
// only.
Vec<double> edge_weights(const mesh::Surface &surface, const Vec<double> &concavity, const WeightOptions &options,
                         const Executor &executor);

}  // namespace ts::field
