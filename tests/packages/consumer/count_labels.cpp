// count_labels.c by the C++ layer. SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <exception>
#include <toothseg.hpp>

#include "made_arch.hpp"
#include "summary.h"

int main() {
  try {
    const MadeArch arch;
    const toothseg::Context context;
    const toothseg::Model model(context, toothseg::mesh_input(arch.positions, arch.triangles));
    toothseg::Segmentation segmentation(toothseg::Features::detect(model));
    segmentation.click(segmentation.propose_clicks().at(0));
    const auto labels = segmentation.labels();
    print_summary(labels.data(), static_cast<std::uint32_t>(labels.size()));
    return 0;
  } catch (const std::exception &e) {
    return std::fprintf(stderr, "count_labels: %s\n", e.what()), 1;
  }
}
