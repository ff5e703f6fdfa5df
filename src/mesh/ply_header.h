// The header of a PLY file: which elements with which properties follow, and how they are written.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/text.h"

namespace ts::mesh {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class PlyCoding { ascii, little_endian, big_endian };

constexpr std::size_t size_of(PlyType t) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(t)];
}
constexpr bool is_integer(PlyType t) {
  return t < PlyType::float32;
}

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  // of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  const PlyProperty *find(std::string_view property) const;
  bool has_list() const;
  std::size_t least_bytes(PlyCoding coding) const;  // of one element
};

struct PlyHeader {
  PlyCoding coding = PlyCoding::ascii;
  std::vector<PlyElement> elements;
};

// Leaves `text` at the first byte behind the header.
PlyHeader read_ply_header(Text &text);

}  // namespace ts::mesh
