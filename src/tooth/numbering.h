// Which teeth of the dental formula stand in an arch: numbers from widths, places, gaps and forms, by dynamic
// programming.
#pragma once

#include <limits>
#include <optional>

#include "base/memory.h"
#include "tooth/notation.h"

namespace ts::tooth {

// What is measured of a tooth, mm; NaN: not known.
struct ArchTooth {
  double at = 0;                                             // of its middle, along the arch
  double width = std::numeric_limits<double>::quiet_NaN();   // mesiodistal
  double depth = std::numeric_limits<double>::quiet_NaN();   // buccolingual
  double across = std::numeric_limits<double>::quiet_NaN();  // extent of its feature points across the arch
  bool crown = false;                                        // measured on the separated crown
};

// How the arch turns from its first tooth to its last, seen from where the other jaw is.
enum class Turn { unknown, left, right };

struct ArchRow {
  static constexpr double step = 1;  // between possible midlines, mm

  Vec<ArchTooth> teeth;  // along the arch
  Turn turn = Turn::unknown;
  double midline_from = 0;
  Vec<double> midline;  // log-probability of a midline at midline_from + i * step along the arch
};

// What is known for certain.
struct Given {
  std::optional<Jaw> jaw;
  bool mirrored = false;  // the scan is a mirror image of the patient
  Vec<int> place;         // a tooth: place in the dental formula, -1 = not known; empty: of none
};

struct Numbering {
  Jaw jaw = Jaw::upper;
  double jaw_confidence = 0.5;
  Vec<int> place;          // a tooth: in the dental formula, from the patient's right
  Vec<double> confidence;  // a tooth: probability that this is its number, the jaw's included
};

// Throws Fault::too_many_teeth, and Fault::number_order where the given places fit no numbering.
Numbering number_teeth(const ArchRow &row, const Given &given);

}  // namespace ts::tooth
