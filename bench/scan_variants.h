// Variants of a labelled scan that must not change what is found: pose, mirror image, inside out, noise, pieces.
#pragma once

#include "bench/scan_folder.h"

namespace ts::bench {

enum class Variant {
  as_is,
  posed,
  mirrored,
  inside_out,
  noise_05,
  noise_10,
  left_half,
  right_half,
  front,
  quadrant,
  shuffled,
  count
};

const char *name_of(Variant variant);

// `seed` chooses pose, noise and order. Pieces are cut by planes along the arch's depth, from the labelled teeth.
ScanFolder make_variant(const ScanFolder &scan, Variant variant, unsigned seed);

}  // namespace ts::bench
