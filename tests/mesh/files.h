// Mesh files made in memory.
#pragma once

#include <cstring>
#include <string>

#include "mesh/read.h"

namespace files {

inline std::span<const std::byte> bytes(const std::string &s) {
  return {reinterpret_cast<const std::byte *>(s.data()), s.size()};
}

inline ts::mesh::RawMesh read(const std::string &file, ts::mesh::Format format = ts::mesh::Format::automatic) {
  return ts::mesh::read_mesh(bytes(file), format, {});
}

// The bytes of a value, in either order.
template <class T>
std::string raw(T value, bool big = false) {
  std::string s(sizeof value, '\0');
  std::memcpy(s.data(), &value, sizeof value);
  const std::uint16_t one = 1;
  const bool host_is_big = *reinterpret_cast<const char *>(&one) == 0;
  return big == host_is_big ? s : std::string(s.rbegin(), s.rend());
}

inline std::string binary_stl(std::uint32_t promised, std::uint32_t there,
                              std::string header = "written by a scanner") {
  header.resize(80);
  std::string s = header + raw(promised);
  for (std::uint32_t f = 0; f < there; ++f) {
    for (int i = 0; i < 3; ++i) s += raw(0.f);
    for (int i = 0; i < 9; ++i) s += raw(static_cast<float>(f) + 0.5f * static_cast<float>(i));
    s += std::string(2, '\0');
  }
  return s;
}

}  // namespace files
