// Correct a tooth: correct_tooth SCAN separates all teeth, says which of them want a look, and does to one of them what
// a user does by clicks: "this too", "not this", done. SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <exception>
#include <toothseg.hpp>

namespace ts = toothseg;

// Stands for the user's click: half a millimetre below the point of the cut that is furthest from the biting surface.
// Off the surface it may be, by up to click_reach; the library takes the surface point nearest to it.
static ts::Point below_cut(const ts::Cut &cut, const ts::Point &occlusal) {
  const auto height = [&](const ts_edge_point &p) {
    return p.position[0] * occlusal[0] + p.position[1] * occlusal[1] + p.position[2] * occlusal[2];
  };
  const ts_edge_point *lowest = &cut.points.at(0);
  for (const ts_edge_point &p : cut.points)
    if (height(p) < height(*lowest)) lowest = &p;
  ts::Point place{};
  for (std::size_t k = 0; k < 3; ++k) place[k] = lowest->position[k] - 0.5 * occlusal[k];
  return place;
}

static void correct(const char *scan) {
  const ts::Context context;
  const ts::Features features = ts::Features::detect(ts::Model::load(context, scan));
  ts::Segmentation segmentation(features);
  segmentation.segment_all();
  std::printf("%zu teeth\n", segmentation.teeth().size());

  // The work list: teeth that the library is not sure of, the worst first.
  for (const ts_review_item &item : segmentation.review())
    std::printf("tooth %u wants a look: confidence %.2f, warnings %u\n", item.tooth, item.confidence, item.warnings);

  // A viewer paints again what changed, whichever call it was: a click, a correction, undo.
  segmentation.on_change([](const std::vector<ts::Index> &teeth) {
    for (const ts::Index tooth : teeth) std::printf("  paint tooth %u again\n", tooth);
  });

  const ts::Index tooth = segmentation.teeth().at(0);
  const ts::Point here = below_cut(segmentation.cut(tooth), features.occlusal());
  const auto area = [&] { return segmentation.tooth(tooth).area; };
  std::printf("tooth %u: %.2f mm^2\n", tooth, area());
  segmentation.include_point(tooth, here);
  std::printf("\"this too\": %.2f mm^2\n", area());
  segmentation.exclude_point(tooth, here);
  std::printf("\"not this\": %.2f mm^2\n", area());
  segmentation.undo();  // the first click was right after all
  std::printf("taken back: %.2f mm^2\n", area());

  // A tooth that is done is locked: what would change it is refused, and nothing has changed then.
  segmentation.set_locked(tooth, true);
  try {
    segmentation.remove_tooth(tooth);
  } catch (const ts::Exception &e) {
    if (e.status() != TS_E_LOCKED) throw;
    std::printf("refused: %s\n", e.what());
  }
  // For two teeth taken for one, and one taken for two: split_tooth and merge_teeth.
}

int main(int argc, char **argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: correct_tooth SCAN\n"), 2;
  try {
    correct(argv[1]);
    return 0;
  } catch (const std::exception &e) {
    return std::fprintf(stderr, "correct_tooth: %s\n", e.what()), 1;
  }
}
