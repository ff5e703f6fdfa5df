// A file reader (FORMAT, a ts_file_format): any bytes give a model that is sound, or a status of the files or the mesh.
// SPDX-License-Identifier: Apache-2.0
#include "check.h"
#include "scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  static const Handle<ts_context> context = one_thread();
  ts_intake_options options;
  HOLDS(ts_intake_options_init(&options, sizeof options) == TS_OK);
  options.unit = TS_UNIT_MM;
  ts_status got;
  const auto model = made<ts_model>(
      [&](ts_model **out) { return ts_model_read(context.get(), data, size, FORMAT, &options, nullptr, out); }, &got);
  check::status(got, {3, 4});
  HOLDS((got == TS_OK) == (model != nullptr));
  if (model) check::model(model.get());
  return 0;
}
