// Save and resume: save_and_resume SCAN FILE separates the teeth, saves the session into FILE, forgets everything, and
// goes on where the work was left. SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <exception>
#include <toothseg.hpp>

namespace ts = toothseg;

static void begin(const ts::Model &model, const char *file) {
  ts::Segmentation segmentation(ts::Features::detect(model));
  segmentation.segment_all();
  segmentation.assign_numbers();
  segmentation.set_locked(segmentation.teeth().at(0), true);
  segmentation.remove_tooth(segmentation.teeth().at(1));
  segmentation.undo();

  // The steps, not the surface: a small file, of use with the same scan only, which is there whole or as it was before.
  // write_session() gives the same as text, for a data base.
  segmentation.save_session(file);
  std::printf("saved with %zu teeth\n", segmentation.teeth().size());
}

static void go_on(const ts::Model &model, const char *file) {
  // Throws with TS_E_MISMATCH for the session of another scan, TS_E_FILE_NEWER for that of a later library.
  ts::Session session = ts::Session::load(model, file);
  ts::Segmentation &segmentation = session.segmentation;
  const ts::Index first = segmentation.teeth().at(0);
  std::printf("resumed with %zu teeth; tooth %u is FDI %u, %s\n", segmentation.teeth().size(), first,
              segmentation.number(first).fdi, segmentation.locked(first) ? "locked" : "open");

  // Steps can be taken back, and brought again, as if there had been no break.
  const ts_history_info history = segmentation.history();
  std::printf("%u steps to undo, %u to redo\n", history.undo, history.redo);
  segmentation.redo();
  std::printf("after redo %zu teeth\n", segmentation.teeth().size());
}

int main(int argc, char **argv) {
  if (argc != 3) return std::fprintf(stderr, "usage: save_and_resume SCAN FILE\n"), 2;
  try {
    const ts::Context context;
    const ts::Model model = ts::Model::load(context, argv[1]);
    begin(model, argv[2]);
    go_on(model, argv[2]);
    return 0;
  } catch (const std::exception &e) {
    return std::fprintf(stderr, "save_and_resume: %s\n", e.what()), 1;
  }
}
