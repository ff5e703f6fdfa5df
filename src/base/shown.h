// Numbers and points in messages: with a decimal point whatever the host's locale, which std::to_string(double)
// follows.
#pragma once

#include <charconv>
#include <string>

namespace ts {

inline std::string shown(double x) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, x, std::chars_format::general, 6).ptr};
}

template <class Point>
requires requires(const Point &p) {
  p.x(), p.y(), p.z();
}
std::string shown(const Point &p) {
  return "(" + shown(p.x()) + ", " + shown(p.y()) + ", " + shown(p.z()) + ")";
}

}  // namespace ts
