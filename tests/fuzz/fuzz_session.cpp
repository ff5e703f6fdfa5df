// Session files: any text gives a session that goes on, or a status; what was read is written again alike.
// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "check.h"
#include "scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  static const Handle<ts_context> context = one_thread();
  static const Handle<ts_model> model = model_of(context.get(), make_bumps(3, 5, 5));
  const std::string text(reinterpret_cast<const char *>(data), size);
  ts_features *raw = nullptr;
  ts_status got;
  const auto session = made<ts_segmentation>(
      [&](ts_segmentation **out) { return ts_session_read(model.get(), text.data(), text.size(), nullptr, &raw, out); },
      &got);
  const Handle<ts_features> features(raw);
  check::status(got, {1, 2, 3, 5, 6, 7});
  HOLDS((got == TS_OK) == (session != nullptr) && (got == TS_OK) == (features != nullptr));
  if (!session) return 0;
  check::features(model.get(), features.get());
  check::segmentation(model.get(), session.get(), false);
  const auto write = [](const ts_segmentation *s) {
    return check::all<char>([&](char *p, std::uint32_t n, std::uint32_t *c) { return ts_session_write(s, p, n, c); });
  };
  const std::vector<char> once = write(session.get());
  const auto again = made<ts_segmentation>([&](ts_segmentation **out) {
    return ts_session_read(model.get(), once.data(), once.size(), nullptr, nullptr, out);
  });
  HOLDS(again != nullptr && write(again.get()) == once);
  return 0;
}
