// Counts of a file against its size, before anything is allocated for them.
#pragma once

#include <cstdint>
#include <string>

#include "base/error.h"

namespace ts::mesh {

inline constexpr std::uint64_t most_elements = std::uint64_t{1} << 30;

// `count` elements of at least `each` bytes are promised where `left` bytes are left. A promise of over a thousand
// times the rest, or of more than can be read, is a wrong count; a smaller one a file that was cut off.
inline void check_count(std::uint64_t count, std::uint64_t each, std::uint64_t left, const std::string &what) {
  const bool fits = each == 0 || count <= left / each;
  if (fits && count <= most_elements) return;
  const std::string text = "the header promises " + std::to_string(count) + " " + what + " of at least " +
                           std::to_string(each) + " bytes, but " + std::to_string(left) + " bytes follow";
  if (count > most_elements || count / 1000 > left / each) throw Error(Fault::file_count, text);
  throw Error(Fault::file_truncated, text);
}

}  // namespace ts::mesh
