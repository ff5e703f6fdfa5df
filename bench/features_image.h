// A look at the strip: height and convexity, with labels, cuts and points. For private use with private scans.
#pragma once

#include <string>

#include "bench/scan_folder.h"
#include "features/features.h"

namespace ts::bench {

void draw_strip(const std::string &file, const ScanFolder &scan, const features::Features &found);

}  // namespace ts::bench
