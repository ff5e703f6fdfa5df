// What the reference labels of a scan give to experiments: feature points, clicks, scores.
#pragma once

#include <cstdint>

#include "bench/scan_folder.h"
#include "features/features.h"

namespace ts::bench {

using mesh::Index;

// The labelled teeth of a scan, along the arch.
struct LabelledTeeth {
  Vec<int> label;          // of each tooth
  Vec<Index> of_face;      // a face: place of its tooth, or none
  Vec<double> depth;       // a vertex: mm along edges to the border of its tooth; 0 outside teeth
  Vec<double> deepest;     // a tooth
  Vec<mesh::Vec3> centre;  // of its area
  mesh::Vec3 occlusal = mesh::Vec3::Zero();
};

LabelledTeeth labelled_teeth(const ScanFolder &scan);

enum class PointsFrom { cusp, core };  // local tops of the crown's top 22 %; spread deep inside the crown

// `most` points a tooth, one group a tooth, in the order of the teeth.
features::Features features_from_labels(const ScanFolder &scan, const LabelledTeeth &teeth, PointsFrom from,
                                        std::size_t most);

// The tooth most points of each group are on, none if most are on none.
Vec<Index> tooth_of_groups(const ScanFolder &scan, const LabelledTeeth &teeth, const features::Features &features);

// A face of the tooth at random, further inside than 0.35 of its depth, by area.
// `towards` another tooth: on the half of the crown that faces it (none: anywhere).
Index random_crown_face(const ScanFolder &scan, const LabelledTeeth &teeth, Index tooth, Index towards,
                        std::uint64_t &state);

// Intersection over union by area of each tooth with the predicted part matched to it (largest first, one to one).
struct Scores {
  Vec<double> iou;
  int false_parts = 0;  // whose best IoU is under 0.3
};

Scores score_labels(const ScanFolder &scan, const LabelledTeeth &teeth, const Vec<std::uint32_t> &predicted);

}  // namespace ts::bench
