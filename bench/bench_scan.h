// The meshes that ts-bench measures on, kept in files so that no process holds one that it does not work on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ts::bench {

struct Mesh {
  std::vector<float> xyz;                // 3 a vertex
  std::vector<std::uint32_t> triangles;  // 3 a face

  std::uint32_t vertices() const { return static_cast<std::uint32_t>(xyz.size() / 3); }
  std::uint32_t faces() const { return static_cast<std::uint32_t>(triangles.size() / 3); }
};

// Arches of more triangles than this are made from one of a quarter by halving every edge. Making one directly takes
// some 0.08 ms a triangle and more than all that is measured on it.
inline constexpr std::uint32_t most_direct = 600000;

// The lower arch with mild crowding. Throws std::runtime_error.
Mesh make_arch(std::uint32_t triangles);

// A binary PLY of floats and triangles, as the folders of scans have it.
Mesh read_mesh(const std::string &path);
void write_mesh(const Mesh &mesh, const std::string &path);

// The bytes of a binary STL.
std::vector<unsigned char> stl_of(const Mesh &mesh);

}  // namespace ts::bench
