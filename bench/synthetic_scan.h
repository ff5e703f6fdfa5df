// Synthetic arches as labelled scans.
#pragma once

#include <vector>

#include "bench/scan_folder.h"

namespace ts::bench {

// FDI numbers in `missing`. Throws std::runtime_error.
ScanFolder synthetic_scan(bool upper, double crowding, unsigned seed, const std::vector<std::uint32_t> &missing,
                          std::uint32_t triangles);

}  // namespace ts::bench
