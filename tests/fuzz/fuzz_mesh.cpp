// Mesh arrays as nobody should make them: soups, pinches, fans, slivers, huge, tiny and denormal coordinates, indices
// out of range. SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "check.h"
#include "input.h"
#include "scene.h"

namespace {

double coordinate(Input &in) {
  switch (in.byte() % 8) {
    case 0: return in.any();
    case 1: return (in.share() - 0.5) * 1e-6;
    case 2: return 1e5 + in.share();
    case 3: return 4.9e-324 * in.byte();
    default: return in.below(16) * 0.5;  // few different ones: points meet
  }
}

std::uint32_t corner(Input &in, std::uint32_t vertices) {
  const std::uint8_t how = in.byte();
  return how < 250 ? how % (vertices ? vertices : 1) : 0xffffffffu >> (how - 250);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  static const Handle<ts_context> context = one_thread();
  Input in(data, size);
  const bool soup = in.byte() % 4 == 0, floats = in.byte() % 2 == 0;
  const std::uint32_t vertices = soup ? 3 * in.below(40) : in.below(60), faces = soup ? vertices / 3 : in.below(90);
  const std::uint32_t gap = in.byte() % 3 * 8;
  const double tolerance = in.byte() % 3 == 0 ? in.share() : 0;
  std::vector<double> d;
  std::vector<float> f;
  for (std::uint32_t i = 0; i < vertices; ++i) {
    for (int k = 0; k < 3; ++k) {
      const double x = coordinate(in);
      floats ? f.push_back(static_cast<float>(x)) : d.push_back(x);
    }
    if (gap && floats) f.insert(f.end(), gap / 4, NAN);
    if (gap && !floats) d.insert(d.end(), gap / 8, NAN);
  }
  std::vector<std::uint32_t> triangles;
  if (!soup) {
    const std::uint32_t hub = in.below(vertices + 1);
    while (triangles.size() < 3 * std::size_t{faces}) {
      switch (in.byte() % 4) {
        case 0:  // of a fan
          triangles.insert(triangles.end(), {hub % (vertices + 1), corner(in, vertices), corner(in, vertices)});
          break;
        case 1:  // on an edge that is there
          if (triangles.size() >= 3) {
            const std::size_t at = 3 * in.below(static_cast<std::uint32_t>(triangles.size() / 3));
            triangles.insert(triangles.end(), {triangles[at + 1], triangles[at], corner(in, vertices)});
            break;
          }
          [[fallthrough]];
        default:
          for (int k = 0; k < 3; ++k) triangles.push_back(corner(in, vertices));
      }
    }
  }
  ts_mesh_input input;
  HOLDS(ts_mesh_input_init(&input, sizeof input) == TS_OK);
  input.scalar = floats ? TS_FLOAT32 : TS_FLOAT64;
  input.positions = floats ? static_cast<const void *>(f.data()) : d.data();
  input.vertex_count = vertices;
  input.stride = gap ? (floats ? 12 : 24) + gap : 0;
  input.triangles = soup ? nullptr : triangles.data();
  input.triangle_count = faces;
  ts_intake_options options;
  HOLDS(ts_intake_options_init(&options, sizeof options) == TS_OK);
  options.unit = static_cast<ts_unit>(in.byte() % 5);
  options.weld_tolerance = tolerance;
  ts_status got;
  const auto model = made<ts_model>(
      [&](ts_model **out) { return ts_model_create(context.get(), &input, &options, nullptr, out); }, &got);
  check::status(got, {1, 4});
  HOLDS((got == TS_OK) == (model != nullptr));
  if (model) check::model(model.get());
  return 0;
}
