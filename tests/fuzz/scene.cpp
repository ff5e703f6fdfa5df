// SPDX-License-Identifier: Apache-2.0
#include "scene.h"

#include <cmath>

#include "check.h"

Bumps make_bumps(unsigned count, unsigned cells, double height) {
  constexpr double side = 6;
  Bumps b;
  const unsigned nx = count * cells, ny = 2 * cells;
  for (unsigned j = 0; j <= ny; ++j)
    for (unsigned i = 0; i <= nx; ++i) {
      const double x = side * i / cells, y = side * j / cells - side;
      const double along = std::pow(std::sin(M_PI * x / side), 2), across = std::exp(-y * y / 8);
      b.xyz.insert(b.xyz.end(), {x, y, height * std::sqrt(along) * across});
    }
  const auto at = [&](unsigned i, unsigned j) { return j * (nx + 1) + i; };
  for (unsigned j = 0; j < ny; ++j)
    for (unsigned i = 0; i < nx; ++i) {
      const std::uint32_t q[4] = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
      b.triangles.insert(b.triangles.end(), {q[0], q[1], q[2], q[0], q[2], q[3]});
    }
  for (unsigned k = 0; k < count; ++k) b.top.push_back({side * (k + 0.5), 0, height});
  return b;
}

ts_mesh_input input_of(const Bumps &bumps) {
  ts_mesh_input input;
  HOLDS(ts_mesh_input_init(&input, sizeof input) == TS_OK);
  input.scalar = TS_FLOAT64;
  input.positions = bumps.xyz.data();
  input.vertex_count = static_cast<std::uint32_t>(bumps.xyz.size() / 3);
  input.triangles = bumps.triangles.data();
  input.triangle_count = static_cast<std::uint32_t>(bumps.triangles.size() / 3);
  return input;
}

Handle<ts_context> one_thread() {
  ts_context_options options;
  HOLDS(ts_context_options_init(&options, sizeof options) == TS_OK);
  options.threads = 1;
  auto context = made<ts_context>([&](ts_context **out) { return ts_context_create(&options, out); });
  HOLDS(context != nullptr);
  return context;
}

Handle<ts_model> model_of(ts_context *context, const Bumps &bumps) {
  const ts_mesh_input input = input_of(bumps);
  auto model = made<ts_model>([&](ts_model **out) { return ts_model_create(context, &input, nullptr, nullptr, out); });
  HOLDS(model != nullptr);
  return model;
}

Handle<ts_features> features_of(const ts_model *model, const Bumps &bumps) {
  auto features = made<ts_features>([&](ts_features **out) { return ts_features_create(model, out); });
  HOLDS(features != nullptr);
  const double up[3] = {0, 0, 1};
  HOLDS(ts_features_set_occlusal(features.get(), up) == TS_OK);
  for (const auto &top : bumps.top)
    HOLDS(ts_features_add_point(features.get(), top.data(), TS_NONE, nullptr, nullptr) == TS_OK);
  return features;
}
