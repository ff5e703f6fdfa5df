// Something to begin with for each fuzzer: make_corpus FOLDER writes FOLDER/<target>/. SPDX-License-Identifier:
// Apache-2.0
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "check.h"
#include "scene.h"

namespace {

void write(const std::filesystem::path &path, const std::string &text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

}  // namespace

int main(int argc, char **argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: make_corpus FOLDER\n"), 2;
  const std::filesystem::path folder = argv[1];
  const auto context = one_thread();
  const Bumps bumps = make_bumps(3, 5, 5);
  const auto model = model_of(context.get(), bumps);
  const auto features = features_of(model.get(), bumps);
  const auto s = made<ts_segmentation>(
      [&](ts_segmentation **out) { return ts_segmentation_create(features.get(), nullptr, nullptr, out); });
  HOLDS(s != nullptr);

  // Files: as the library writes them, and small ones by hand.
  const Bumps small = make_bumps(1, 2, 3);
  const auto tiny = model_of(context.get(), small);
  const auto tiny_features = features_of(tiny.get(), small);
  const auto t = made<ts_segmentation>(
      [&](ts_segmentation **out) { return ts_segmentation_create(tiny_features.get(), nullptr, nullptr, out); });
  HOLDS(t != nullptr);
  for (const auto &[name, format] : {std::pair{"stl", TS_OUTPUT_STL}, {"ply", TS_OUTPUT_PLY}, {"obj", TS_OUTPUT_OBJ}}) {
    std::filesystem::create_directories(folder / name);
    HOLDS(ts_segmentation_save(t.get(), (folder / name / "written").c_str(), format, nullptr, nullptr) == TS_OK);
  }
  write(folder / "stl" / "text",
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 9 0 0\nvertex 0 9 "
        "0\nendloop\nendfacet\nendsolid a\n");
  write(folder / "ply" / "text",
        "ply\nformat ascii 1.0\ncomment c\nelement vertex 3\nproperty float x\nproperty double y\nproperty float "
        "z\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n0 0 0\n9 0 0\n0 9 0\n3 0 1 2\n");
  write(folder / "obj" / "text",
        "# o\nv 0 0 0\nv 9 0 0 1\nv 0 9 0\nv 9 9 0\nvn 0 0 1\nvt 0 0\ng g\nf 1/1/1 2//1 -2\nf 2 4 3 \\\n1\n");
  write(folder / "off" / "text", "OFF\n# c\n4 2 0\n0 0 0\n9 0 0\n0 9 0\n9 9 0\n3 0 1 2 0.5 0.5 0.5\n3 1 3 2\n");
  write(folder / "off" / "colours", "STCOFF 3 1 0\n0 0 0 1 1 1 1 0 0\n9 0 0 1 1 1 1 0 0\n0 9 0 1 1 1 1 0 0\n3 0 1 2\n");

  // Sessions after every kind of step.
  auto save = [&, n = 0]() mutable {
    const auto text = check::all<char>(
        [&](char *p, std::uint32_t c, std::uint32_t *k) { return ts_session_write(s.get(), p, c, k); });
    write(folder / "session" / std::to_string(n++), std::string(text.begin(), text.end()));
  };
  save();
  HOLDS(ts_segment_click(s.get(), bumps.top[0].data(), nullptr, nullptr) == TS_OK);
  save();
  HOLDS(ts_segment_all(s.get(), nullptr) == TS_OK);
  const auto teeth = check::all<std::uint32_t>(
      [&](std::uint32_t *p, std::uint32_t c, std::uint32_t *k) { return ts_get_teeth(s.get(), p, c, k); });
  HOLDS(teeth.size() == 3);
  const double beside[3] = {5, 1, 1};
  HOLDS(ts_tooth_include(s.get(), teeth[0], beside, nullptr) == TS_OK);
  HOLDS(ts_cut_smooth(s.get(), teeth[1], 0.4, nullptr) == TS_OK);
  HOLDS(ts_assign_numbers(s.get(), nullptr) == TS_OK);
  HOLDS(ts_set_number(s.get(), teeth[0], 33) == TS_OK);
  HOLDS(ts_tooth_set_locked(s.get(), teeth[2], 1) == TS_OK);
  save();
  HOLDS(ts_undo(s.get()) == TS_OK);
  HOLDS(ts_tooth_merge(s.get(), teeth[0], teeth[1], nullptr) == TS_OK);
  HOLDS(ts_undo(s.get()) == TS_OK);
  save();
  return 0;
}
