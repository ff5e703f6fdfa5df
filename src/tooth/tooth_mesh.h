// A tooth, or the gingiva, as a mesh of its own.
#pragma once

#include "base/executor.h"
#include "base/progress.h"
#include "tooth/partition.h"

namespace ts::tooth {

// What a vertex of a part is; the values of ts_mesh_vertex_flag.
enum VertexFlag : std::uint8_t {
  on_cut = 1,   // shared with another part, bit for bit
  on_rim = 2,   // on a rim of the scan
  of_fill = 4,  // made to close the mesh
};

struct PartMesh {
  Vec<Vec3> position;      // mm
  Vec<Triangle> triangle;  // counter-clockwise seen from outside; those that close it last
  Vec<std::uint8_t> flag;  // a vertex: sum of VertexFlag
  Vec<Vec3> normal;        // a vertex: unit, outwards; zero where the faces cancel out
  Vec<Index> source;       // a triangle: the face of the scan that it is of; none of those that close it
  Index loops = 0;         // closed rims of it that are open
  Index filled = 0;        // rims that were closed
  Index trimmed = 0;       // triangles taken off at rims for the sake of closing
  Index components = 0;    // connected pieces
  double area = 0;         // mm^2, of all of it
  double fill_area = 0;    // mm^2, of what closes it
  double volume = 0;       // mm^3; 0 while it is open
};

// The triangles of `owner` (none: the gingiva). Vertices at which it only touches itself are there once for each side.
// `inside_out`: the faces of the scan look inwards, and are turned. Throws no_cut where there are none.
PartMesh part_of(const Partition &partition, Index owner, bool inside_out, const Executor &executor);

// Takes triangles off, and pieces of less than a hundredth of the area that hang on them.
void take_off(PartMesh &part, std::span<const Index> triangles, const Executor &executor);

// Closes every rim of it by a smooth membrane (docs/method.md). Triangles at the rims that cross others or every fill
// are taken off first, up to 3 % of the area. Throws not_closed where that is not enough; then `part` is as it was.
void close(PartMesh &part, const Executor &executor, const Progress &progress);

// What follows from positions and triangles.
void measure(PartMesh &part, const Executor &executor);

}  // namespace ts::tooth
