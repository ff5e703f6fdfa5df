// Numbers of permanent teeth: FDI (ISO 3950), Universal (ADA) and Palmer.
#pragma once

#include <cstdint>
#include <string>

#include "features/formula.h"

namespace ts::tooth {

using features::Jaw;

// FDI: quadrant 1 (upper right), 2 (upper left), 3 (lower left), 4 (lower right), then 1 (central incisor) to 8.
bool is_fdi(std::uint32_t number);

// The functions below throw Fault::invalid_argument for what is no number of their notation.
Jaw jaw_of(std::uint32_t fdi);

// Place in the dental formula (features/formula.h), counted from the patient's right.
int place_of(std::uint32_t fdi);
std::uint32_t fdi_of(Jaw jaw, int place);

// Universal: 1 to 16 from the upper right third molar to the upper left, 17 to 32 from the lower left to the lower
// right.
std::uint32_t universal_of(std::uint32_t fdi);
std::uint32_t fdi_of_universal(std::uint32_t universal);

// Palmer: position 1 to 8 in a quadrant, written "UR6", or with the angle of the quadrant, "6" before or after it.
struct Palmer {
  std::string letters, symbol;  // "UR6"; UTF-8
  std::uint32_t quadrant = 0;   // as FDI has it
  std::uint32_t position = 0;
};
Palmer palmer_of(std::uint32_t fdi);

}  // namespace ts::tooth
