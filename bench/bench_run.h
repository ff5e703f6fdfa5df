// The measurements of one scan. Each is to be run in a process of its own (in_child).
#pragma once

#include <string>

#include "bench/bench_figures.h"

namespace ts::bench {

struct RunOptions {
  bool quick = false;
  bool baselines = true;
};

// Peak and steady memory of the pipeline alone.
void measure_memory(const std::string &mesh_file, Figures &figures);

// Times of the stages, of clicks, of batches, and of the baselines in turns with them.
void measure_times(const std::string &mesh_file, const RunOptions &options, Figures &figures);

// Bytes a second that one core moves in a[i] = b[i] + s * c[i].
double triad_bandwidth();

}  // namespace ts::bench
