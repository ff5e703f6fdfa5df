// hello_tooth in C++: hello_tooth_cpp SCAN [X Y Z] prints the cut around the tooth at X Y Z (mm, on the surface), or
// around the first one the library proposes. SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <toothseg.hpp>

namespace ts = toothseg;

static void print_cut(const char *scan, const ts::Point *wanted) {
  const ts::Context context;
  const ts::Features features = ts::Features::detect(ts::Model::load(context, scan));
  ts::Segmentation segmentation(features);

  const ts::Point click = wanted ? *wanted : segmentation.propose_clicks().at(0);
  const ts_click_info info = segmentation.click_info(segmentation.click(click));
  for (const ts_edge_point &p : segmentation.cut(info.target).points)
    std::printf("%.4f %.4f %.4f\n", p.position[0], p.position[1], p.position[2]);
}

int main(int argc, char **argv) {
  if (argc != 2 && argc != 5) return std::fprintf(stderr, "usage: hello_tooth_cpp SCAN [X Y Z]\n"), 2;
  try {
    ts::Point at{};
    for (int i = 2; i < argc; ++i) at[static_cast<std::size_t>(i - 2)] = std::atof(argv[i]);
    print_cut(argv[1], argc == 5 ? &at : nullptr);
    return 0;
  } catch (const std::exception &e) {
    return std::fprintf(stderr, "hello_tooth_cpp: %s\n", e.what()), 1;
  }
}
