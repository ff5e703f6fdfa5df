// Numbers from and to text, of which libc++ 13 has those of integers alone; see ranges.h. By the C library, whose
// numbers have a point in every locale here (musl) and are exact both ways, so that files and sessions are those of
// other systems. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 15000

// NOLINTBEGIN(cert-dcl58-cpp): the names are those that the standard gives
namespace std {
namespace ts_missing {

// Where the number that `first` begins with ends; `first` where there is none.
inline const char *number_end(const char *first, const char *last) {
  const auto digits = [&](const char *p) {
    while (p != last && *p >= '0' && *p <= '9') ++p;
    return p;
  };
  const auto word = [&](const char *p, const char *lower) {
    for (; *lower; ++p, ++lower)
      if (p == last || (*p | 0x20) != *lower) return static_cast<const char *>(nullptr);
    return p;
  };
  const char *const begin = first != last && *first == '-' ? first + 1 : first;
  for (const char *name : {"infinity", "inf", "nan"})
    if (const char *const end = word(begin, name)) return end;
  const char *end = digits(begin);
  auto count = end - begin;
  if (end != last && *end == '.') {
    const char *const after = digits(end + 1);
    count += after - (end + 1);
    if (count > 0) end = after;
  }
  if (count == 0) return first;
  if (end != last && (*end == 'e' || *end == 'E')) {
    const char *p = end + 1;
    if (p != last && (*p == '-' || *p == '+')) ++p;
    const char *const after = digits(p);
    if (after != p) end = after;
  }
  return end;
}

inline to_chars_result put(char *first, char *last, const char *text) {
  const size_t length = std::strlen(text);
  if (static_cast<size_t>(last - first) < length) return {last, errc::value_too_large};
  std::memcpy(first, text, length);
  return {first + length, errc()};
}

}  // namespace ts_missing

inline from_chars_result from_chars(const char *first, const char *last, double &value) {
  const char *const end = ts_missing::number_end(first, last);
  if (end == first) return {first, errc::invalid_argument};
  const std::string text(first, end);
  const double x = std::strtod(text.c_str(), nullptr);
  // A number that is not 0 and comes out as 0, or as infinite though written in digits, has no double.
  const bool zero = text.substr(0, text.find_first_of("eE")).find_first_of("123456789") == text.npos;
  const bool in_digits = text.find_first_of("nN") == text.npos;
  if (in_digits && ((x == 0 && !zero) || std::isinf(x))) return {end, errc::result_out_of_range};
  value = x;
  return {end, errc()};
}

inline to_chars_result to_chars(char *first, char *last, double value, chars_format format, int precision) {
  char text[1100];  // the longest: 309 digits before the point
  static_cast<void>(
      std::snprintf(text, sizeof text, format == chars_format::fixed ? "%.*f" : "%.*g", precision, value));
  return ts_missing::put(first, last, text);
}

// The fewest digits that give the same double again; as a plain number unless it is shorter with an exponent.
inline to_chars_result to_chars(char *first, char *last, double value) {
  char text[400];
  if (!std::isfinite(value)) {
    static_cast<void>(std::snprintf(text, sizeof text, "%g", value));
    return ts_missing::put(first, last, text);
  }
  // 15 digits come back from any double, so fewer than that are 15 with zeros behind.
  for (int more = 14; more <= 16; ++more) {
    static_cast<void>(std::snprintf(text, sizeof text, "%.*e", more, value));
    if (std::strtod(text, nullptr) == value) break;
  }
  char *const exponent = std::strchr(text, 'e');
  const int power = std::atoi(exponent + 1);
  const std::string tail(exponent);
  std::string mantissa(text, exponent);
  while (mantissa.back() == '0') mantissa.pop_back();
  if (mantissa.back() == '.') mantissa.pop_back();
  if (mantissa.empty() || mantissa == "-") mantissa += '0';
  const int decimals = static_cast<int>(mantissa.size() - std::min(mantissa.find('.'), mantissa.size() - 1)) - 1;
  const std::string scientific = mantissa + tail;
  static_cast<void>(std::snprintf(text, sizeof text, "%.*f", decimals > power ? decimals - power : 0, value));
  return ts_missing::put(first, last, std::strlen(text) <= scientific.size() ? text : scientific.c_str());
}

}  // namespace std
// NOLINTEND(cert-dcl58-cpp)

#endif
