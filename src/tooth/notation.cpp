#include "tooth/notation.h"

#include <array>

#include "base/error.h"

namespace ts::tooth {
namespace {

void need_fdi(std::uint32_t number) {
  if (!is_fdi(number))
    throw Error(Fault::invalid_argument,
                std::to_string(number) + " is no FDI number of a permanent tooth (11 to 18, ... 41 to 48)");
}

}  // namespace

bool is_fdi(std::uint32_t number) {
  const std::uint32_t quadrant = number / 10, position = number % 10;
  return quadrant >= 1 && quadrant <= 4 && position >= 1 && position <= 8;
}

Jaw jaw_of(std::uint32_t fdi) {
  need_fdi(fdi);
  return fdi < 30 ? Jaw::upper : Jaw::lower;
}

int place_of(std::uint32_t fdi) {
  need_fdi(fdi);
  const bool right = fdi / 10 == 1 || fdi / 10 == 4;
  const int position = static_cast<int>(fdi % 10);
  return right ? 8 - position : 7 + position;
}

std::uint32_t fdi_of(Jaw jaw, int place) {
  if (place < 0 || place >= features::places)
    throw Error(Fault::invalid_argument, std::to_string(place) + " is no place of the dental formula");
  const bool right = place < 8, upper = jaw == Jaw::upper;
  const int quadrant = right ? (upper ? 1 : 4) : (upper ? 2 : 3);
  return static_cast<std::uint32_t>(10 * quadrant + (right ? 8 - place : place - 7));
}

std::uint32_t universal_of(std::uint32_t fdi) {
  const int place = place_of(fdi);
  return static_cast<std::uint32_t>(jaw_of(fdi) == Jaw::upper ? 1 + place : 32 - place);
}

std::uint32_t fdi_of_universal(std::uint32_t universal) {
  if (universal < 1 || universal > 32)
    throw Error(Fault::invalid_argument, std::to_string(universal) + " is no Universal number (1 to 32)");
  const int n = static_cast<int>(universal);
  return n <= 16 ? fdi_of(Jaw::upper, n - 1) : fdi_of(Jaw::lower, 32 - n);
}

Palmer palmer_of(std::uint32_t fdi) {
  need_fdi(fdi);
  // Drawn as seen from the front: the bars of the angle lie towards the midline and the other jaw.
  constexpr std::array<const char *, 4> letters{"UR", "UL", "LL", "LR"};
  constexpr std::array<const char *, 4> angle{"\u2518", "\u2514", "\u250c", "\u2510"};
  const std::uint32_t quadrant = fdi / 10, position = fdi % 10;
  const std::string digit = std::to_string(position);
  const bool right = quadrant == 1 || quadrant == 4;
  return {letters[quadrant - 1] + digit, right ? digit + angle[quadrant - 1] : angle[quadrant - 1] + digit, quadrant,
          position};
}

}  // namespace ts::tooth
