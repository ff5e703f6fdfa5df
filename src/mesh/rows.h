// Building Rows: items sorted into rows by counting, items of a row ascending.
#pragma once

#include <numeric>

#include "base/stop.h"
#include "mesh/surface.h"

namespace ts::mesh {

// row_of(i, add) calls add(row) for each row that item i belongs to.
Rows rows_by(std::size_t rows, std::size_t items, const auto &row_of) {
  Rows r;
  // Counted two places on, so that the ends of the rows become their starts while they are filled.
  r.start.assign(rows + 2, 0);
  StopNowAndThen stop(1 << 16);
  for (std::size_t i = 0; i < items; ++i) {
    stop();
    row_of(i, [&](Index row) { ++r.start[row + 2]; });
  }
  std::partial_sum(r.start.begin(), r.start.end(), r.start.begin());
  r.item.resize(r.start.back());
  for (std::size_t i = 0; i < items; ++i) {
    stop();
    row_of(i, [&](Index row) { r.item[r.start[row + 1]++] = static_cast<Index>(i); });
  }
  r.start.pop_back();
  return r;
}

}  // namespace ts::mesh
