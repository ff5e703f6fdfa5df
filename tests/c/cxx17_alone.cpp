// The C headers compile alone as C++17. SPDX-License-Identifier: Apache-2.0
#include <toothseg.h>
#include <toothseg_arch.h>

#include <type_traits>

// What crosses the border is plain data.
static_assert(std::is_trivial_v<ts_segment_options> && std::is_standard_layout_v<ts_segment_options>);
static_assert(std::is_trivial_v<ts_tooth_info> && std::is_standard_layout_v<ts_tooth_info>);
static_assert(sizeof(ts_edge_point) == 40 && sizeof(ts_status) == 4);
