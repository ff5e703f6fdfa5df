// The baselines in turns with what they are compared with.
#pragma once

#include <optional>

#include "bench/bench_baselines.h"
#include "bench/bench_run.h"
#include "features/features.h"
#include "field/solver.h"

namespace ts::bench {

// How often things are repeated: `least` times, then until `most` or the time is spent.
struct Effort {
  std::size_t least = 1, most = 1;
  int rounds = 1;       // of clicks before and after a turn of the baselines
  bool choose = false;  // try what CHOLMOD is quickest with; else as it comes, which is what all trials ended with
  double turns_ms = 0, batch_ms = 0, factor_ms = 0;
};
Effort effort_for(std::size_t triangles, bool quick);

class Comparison {
 public:
  // Holds a copy of what it needs but the surface, which must outlive the turns' use: it is copied too.
  Comparison(const mesh::Surface &surface, const features::Features &features, const Effort &effort, Figures &figures);

  // A click of each baseline, and the bandwidth: of that the best of all turns counts.
  void turn();

  // Numeric factorisations in turns, the bound, and the medians of all.
  void finish(const Effort &effort, Figures &figures);

 private:
  void choose(Figures &figures);

  mesh::Surface surface_;
  Problem problem_;
  std::unique_ptr<const field::Solver> solver_;
  mesh::Index group_ = 0;
  std::optional<Cholmod> cholmod_;
  // Of a baseline's clicks.
  struct Parts {
    Samples total, assemble, analyse, factorise, solve;
    void add(const BaselineTimes &times);
    void set(const std::string &name, Figures &figures) const;
  };
  Parts a_, b_[2];
  double bandwidth_ = 0;
};

}  // namespace ts::bench
