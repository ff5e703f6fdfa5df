// Feature points of the teeth and their groups, one a tooth (paper, "Site constraints"; refs. 38 and 30).
#pragma once

#include "mesh/surface.h"

namespace ts::features {

using mesh::Index;
using mesh::Vec3;

struct Point {
  Index vertex = mesh::none;  // nearest vertex of the surface
  Vec3 position = Vec3::Zero();
  double convexity = 0;  // at radius r, dimensionless: 0.25 to 0.4 on a cusp
};

struct Group {
  Vec<Point> points;
  double from = 0, to = 0;  // extent of the tooth along the arch curve, mm
  double confidence = 1;    // that this is exactly one tooth
};

// How far a scan looks like one arch with one occlusal side; all zero in a set made by hand.
struct Looks {
  double opposed = 0;          // roughness that faces against the occlusal direction over that which faces with it
  double coverage = 0;         // share of the roughness that lies near the arch curve
  double length = 0;           // of the arch curve, mm
  std::uint32_t warnings = 0;  // sum of Doubt (doubts.h)
};

struct Features {
  Vec3 occlusal = Vec3::Zero();  // unit, from the gums to the biting surface
  Vec<Vec3> arch;                // polyline from one end to the other, mm
  Vec<Group> groups;             // along the arch
  bool inside_out = false;       // the faces of the surface look inwards
  Looks looks;
};

}  // namespace ts::features
