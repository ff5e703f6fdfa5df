// What the rivals have in common: the scan they work on, the regions they come to, and how these become teeth.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bench/rival_morphology.h"
#include "features/orientation.h"

namespace ts::bench {

// Heights above the gums, for telling teeth from gingiva.
struct Heights {
  features::Orientation orientation;
  Vec<double> below_top;  // a vertex: mm under the highest point of the scan around it, in plan view
};

Heights heights(const Surface &surface, const Executor &executor);

// A number a face, 1 and up; 0 for no tooth.
struct Teeth {
  Vec<Index> of_face;
  unsigned count = 0, regions = 0;  // regions: before any is merged
  double spread = 0;                // standard deviation of the logarithm of the teeth's areas: 0 if all are as large
};

// What a rival hands back, and what it tells of itself.
struct Outcome {
  Teeth teeth;
  std::vector<std::pair<std::string, double>> settings;
  double run_ms = 0, search_ms = 0;  // one run with the settings; all that was tried to find them
  unsigned tried = 0;
};

// Whether `a` fits `wanted` teeth better than `b`: by the count, then by areas more alike.
bool fits_better(const Teeth &a, const Teeth &b, unsigned wanted);

}  // namespace ts::bench
