// Drag a cut: drag_cut SCAN takes a point of a tooth's cut half a millimetre towards the gums, as a user does with the
// mouse, draws a stretch of it anew, and gives the tooth its first cut again. SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <exception>
#include <toothseg.hpp>

namespace ts = toothseg;

static ts::Point moved(const ts_edge_point &p, const ts::Point &direction, double mm) {
  return {p.position[0] + mm * direction[0], p.position[1] + mm * direction[1], p.position[2] + mm * direction[2]};
}

static void drag(const char *scan) {
  const ts::Context context;
  const ts::Features features = ts::Features::detect(ts::Model::load(context, scan));
  const ts::Point up = features.occlusal();
  ts::Segmentation segmentation(features);
  segmentation.segment_all();
  const ts::Index tooth = segmentation.teeth().at(0);
  const auto print = [&](const char *what) {
    const ts::Cut now = segmentation.cut(tooth);
    std::printf("%s: %zu points, %.2f mm around %.2f mm^2\n", what, now.points.size(), now.info.length,
                segmentation.tooth(tooth).area);
  };
  print("cut");

  // Points are named by their place in cut().points, which is another one after each edit. A viewer has picked one;
  // here it is the one furthest from the biting surface.
  const ts::Cut cut = segmentation.cut(tooth);
  const auto height = [&](const ts_edge_point &p) {
    return p.position[0] * up[0] + p.position[1] * up[1] + p.position[2] * up[2];
  };
  std::size_t lowest = 0;
  for (std::size_t i = 1; i < cut.points.size(); ++i)
    if (height(cut.points[i]) < height(cut.points[lowest])) lowest = i;

  // What cannot be is refused and nothing has changed, so a host may call this at each move of the mouse and paint what
  // comes of it; undo() before the next one.
  try {
    segmentation.drag_cut(tooth, 0, static_cast<ts::Index>(lowest), moved(cut.points[lowest], up, -0.5));
    print("dragged");
    segmentation.undo();
  } catch (const ts::Exception &e) {
    if (e.status() < TS_E_EDIT_NOTHING || e.status() > TS_E_EDIT_NO_LOOP) throw;
    std::printf("refused: %s\n", e.what());
  }

  // A stroke begins and ends on the cut, and takes the place of what is between.
  const std::size_t n = cut.points.size(), reach = n / 12;
  const ts_edge_point &from = cut.points[(lowest + n - reach) % n], &to = cut.points[(lowest + reach) % n];
  segmentation.draw_cut(tooth, {moved(from, up, 0), moved(cut.points[lowest], up, -0.3), moved(to, up, 0)});
  print("drawn");
  segmentation.offset_cut(tooth, 0.1);  // the whole cut, outwards
  print("widened");

  // Edits are kept, and applied again when another click separates the tooth anew.
  std::printf("%zu edits\n", segmentation.cut_edits(tooth).size());
  segmentation.reset_cut(tooth);
  print("reset");
}

int main(int argc, char **argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: drag_cut SCAN\n"), 2;
  try {
    drag(argv[1]);
    return 0;
  } catch (const std::exception &e) {
    return std::fprintf(stderr, "drag_cut: %s\n", e.what()), 1;
  }
}
