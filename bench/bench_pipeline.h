// The library as a caller uses it: mesh -> model -> features -> segmentation -> clicks, through the C functions.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "bench/bench_scan.h"
#include "features/features.h"
#include "mesh/surface.h"
#include "toothseg.h"

namespace ts::bench {

// Throws std::runtime_error with the library's message.
void need_ok(ts_status status, const char *what);

template <auto Destroy>
struct Give {
  template <class T>
  void operator()(T *p) const {
    Destroy(p);
  }
};

using Point = std::array<double, 3>;

// A scan that is ready for clicks. The times are of the walls, ms.
struct Pipeline {
  std::unique_ptr<ts_context, Give<ts_context_destroy>> context;
  std::unique_ptr<ts_model, Give<ts_model_destroy>> model;
  std::unique_ptr<ts_features, Give<ts_features_destroy>> features;
  std::unique_ptr<ts_segmentation, Give<ts_segmentation_destroy>> segmentation;
  double intake_ms = 0, features_ms = 0, segmentation_ms = 0;
  double prepare_ms() const { return intake_ms + features_ms + segmentation_ms; }
};

// Context and model only.
Pipeline take_in(const Mesh &mesh, unsigned threads, const ts_context_options *hooks = nullptr);

// `threads`: 0 = as a caller who says nothing. `hooks` may be NULL; of it only the allocator is used. The mesh is
// emptied once the library has its copy where `mesh` is movable.
Pipeline prepare(const Mesh &mesh, unsigned threads, const ts_context_options *hooks = nullptr);
Pipeline prepare(Mesh &&mesh, unsigned threads, const ts_context_options *hooks = nullptr);

ts_prepare_times prepare_times(const Pipeline &pipeline);

// Takes all clicks back, so that the prepared scan can be used for the next repetition.
void forget_clicks(Pipeline &pipeline);

std::vector<Point> proposed_clicks(const Pipeline &pipeline);

// A point on each tooth separated so far, the same for the same `seed`.
std::vector<Point> points_on_teeth(const Pipeline &pipeline, std::uint64_t seed);

// All clicks together; the number that failed.
unsigned click_all(Pipeline &pipeline, const std::vector<Point> &points);

// Behind the handles, for what is compared with the rooms inside.
const mesh::Surface &surface_of(const Pipeline &pipeline);
features::Features features_of(const Pipeline &pipeline);

}  // namespace ts::bench
