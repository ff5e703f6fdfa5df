// The dental formula: which teeth follow each other along an arch, and how wide they are.
#pragma once

#include <array>

namespace ts::features {

enum class Jaw { upper, lower };

// Places along an arch, from the third molar of one side to that of the other.
inline constexpr int places = 16;

// Mean mesiodistal width of the crown at a place, mm: the usual means of permanent teeth, from the central incisor to
// the third molar, as textbooks of dental anatomy give them.
constexpr double mean_width(Jaw jaw, int place) {
  constexpr std::array<double, 8> upper{8.5, 6.5, 7.5, 7.0, 7.0, 10.0, 9.5, 8.5};
  constexpr std::array<double, 8> lower{5.0, 5.5, 7.0, 7.0, 7.0, 11.0, 10.5, 10.0};
  const int from_middle = place < 8 ? 7 - place : place - 8;
  return (jaw == Jaw::upper ? upper : lower)[from_middle];
}

// Mean buccolingual diameter of the crown at a place, mm: Ash & Nelson, Wheeler's Dental Anatomy, Physiology and
// Occlusion, 8th ed. (2003), table of average measurements.
constexpr double mean_depth(Jaw jaw, int place) {
  constexpr std::array<double, 8> upper{7.0, 6.0, 8.0, 9.0, 9.0, 11.0, 11.0, 10.0};
  constexpr std::array<double, 8> lower{6.0, 6.5, 7.5, 7.5, 8.0, 10.5, 10.0, 9.5};
  const int from_middle = place < 8 ? 7 - place : place - 8;
  return (jaw == Jaw::upper ? upper : lower)[from_middle];
}

// What departures from the formula cost, in the units of the weights (teeth.h): log-probability.
struct FormulaCosts {
  double width = 12;          // times log(width / mean)^2: a standard deviation of 20 %, of teeth and cuts together
  double missing_closed = 2;  // a tooth missing between two that touch
  double missing_open = 0.5;  // ... where there is a gap
  double missing_end = 0.5;   // ... in front of the last one left, the third molars not counted; at most two count
  double third_molar = 0.5;   // ... that is there
};

// Sizes of people's teeth against the means.
inline constexpr std::array<double, 4> sizes{0.87, 0.95, 1.03, 1.12};

}  // namespace ts::features
