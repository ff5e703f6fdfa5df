// A row of bumps on a plane, some hundred triangles: the least that can be separated, with a feature point on each
// bump. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <toothseg.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

struct Destroy {
  void operator()(ts_context *p) const { ts_context_destroy(p); }
  void operator()(ts_job *p) const { ts_job_destroy(p); }
  void operator()(ts_model *p) const { ts_model_destroy(p); }
  void operator()(ts_features *p) const { ts_features_destroy(p); }
  void operator()(ts_segmentation *p) const { ts_segmentation_destroy(p); }
  void operator()(ts_mesh *p) const { ts_mesh_destroy(p); }
};
template <class T>
using Handle = std::unique_ptr<T, Destroy>;

// The first argument is the maker, the last is where it puts what it makes.
template <class T, class Make>
Handle<T> made(const Make &make, ts_status *status = nullptr) {
  T *raw = nullptr;
  const ts_status got = make(&raw);
  if (status) *status = got;
  return Handle<T>(raw);
}

struct Bumps {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
  std::vector<std::array<double, 3>> top;  // of each bump
};

// `count` bumps 6 mm apart with valleys between, grid of `cells` a bump; `height` mm.
Bumps make_bumps(unsigned count, unsigned cells, double height);

ts_mesh_input input_of(const Bumps &bumps);
Handle<ts_context> one_thread();
Handle<ts_model> model_of(ts_context *context, const Bumps &bumps);
// A point a bump, a group each, looking along z.
Handle<ts_features> features_of(const ts_model *model, const Bumps &bumps);
