// A separated tooth and the line it was cut along.
#pragma once

#include <cstdint>

#include "cut/polyline.h"

namespace ts::tooth {

using mesh::Index;
using mesh::Vec3;

// The values of ts_tooth_warning.
enum Warning : std::uint32_t {
  area_small = 1,
  area_large = 2,
  open_at_border = 4,
  several_loops = 8,
  no_neighbour = 16,
  seed_rejected = 32,
  width = 64,
  two_groups = 128,
  flat_top = 256,
  made_by_click = 512,
};

struct Cut {
  cut::Polyline line;    // seen from outside counter-clockwise around the tooth
  double iso = 0;        // iso-value it was chosen at
  double gradient = 0;   // mean of |grad u| along it, 1/mm
  double concavity = 0;  // share of it in concave valleys, 0 to 1
};

struct Tooth {
  Index group = mesh::none;  // index into Features::groups; from their number on: made by a click
  Vec<Index> faces;          // ascending
  Vec<Index> vertices;       // of these faces, ascending
  Vec<Index> seeds;          // vertices held as its constraint, ascending
  Vec<Cut> loops;            // longest first
  double area = 0;           // mm^2
  double iso = 0, gradient = 0;
  double confidence = 0;  // 0 to 1
  std::uint32_t warnings = 0;
};

}  // namespace ts::tooth
