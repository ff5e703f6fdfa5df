// Meshes as files.
#pragma once

#include <array>
#include <span>
#include <string>

#include "base/progress.h"
#include "mesh/surface.h"

namespace ts::mesh {

enum class OutputFormat { stl, ply, obj, glb };

struct OutputGroup {
  std::string name;  // letters, digits, - and _
  std::uint32_t label = 0;
  std::array<std::uint8_t, 3> colour = {};
};

struct OutputMesh {
  std::span<const Vec3> position;  // mm
  std::span<const Triangle> triangle;
  std::span<const Index> group_of;  // a triangle: place in `group`; empty: all are of the first
  Vec<OutputGroup> group;
};

// STL: binary, all triangles. PLY: binary, a colour and a label a triangle. OBJ: a group a group. GLB: a mesh and a
// node a group, in m as glTF has it, vertices of several groups in each of them. Coordinates are floats but in OBJ (9
// digits). Throws file_write; then nothing is left half written, and what was there stays.
void save_mesh(const std::string &path, OutputFormat format, const OutputMesh &mesh, const Progress &progress);

}  // namespace ts::mesh
