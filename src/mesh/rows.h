// Building Rows: items sorted into rows by counting, items of a row ascending.
#pragma once

#include <numeric>

#include "mesh/surface.h"

namespace ts::mesh {

// row_of(i, add) calls add(row) for each row that item i belongs to.
Rows rows_by(std::size_t rows, std::size_t items, const auto &row_of) {
  Rows r;
  r.start.assign(rows + 1, 0);
  for (std::size_t i = 0; i < items; ++i) row_of(i, [&](Index row) { ++r.start[row + 1]; });
  std::partial_sum(r.start.begin(), r.start.end(), r.start.begin());
  r.item.resize(r.start.back());
  Vec<Index> fill(r.start.begin(), r.start.end() - 1);
  for (std::size_t i = 0; i < items; ++i) row_of(i, [&](Index row) { r.item[fill[row]++] = static_cast<Index>(i); });
  return r;
}

}  // namespace ts::mesh
