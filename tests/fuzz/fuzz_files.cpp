// A file reader (FORMAT, a ts_file_format): any bytes give a model that is sound, or a status of the files or the mesh.
// Inputs of every fourth size are left to the library to tell apart.
// SPDX-License-Identifier: Apache-2.0
#include "check.h"
#include "scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  static const Handle<ts_context> context = one_thread();
  ts_intake_options options;
  HOLDS(ts_intake_options_init(&options, sizeof options) == TS_OK);
  options.unit = TS_UNIT_MM;
  const ts_file_format format = size % 4 ? FORMAT : TS_FORMAT_AUTO;
  ts_status got;
  const auto model = made<ts_model>(
      [&](ts_model **out) { return ts_model_read(context.get(), data, size, format, &options, nullptr, out); }, &got);
  check::status(got, {3, 4});
  HOLDS((got == TS_OK) == (model != nullptr));
  if (model) check::model(model.get());
  return 0;
}
