// Numbers as the text of files.
#pragma once

#include <charconv>
#include <string>

namespace ts::mesh {

// Nine digits, which tell all floats apart; with a point whatever locale the host has set, unlike printf.
inline std::string decimal(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, 9).ptr};
}

}  // namespace ts::mesh
