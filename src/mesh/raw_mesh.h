// A mesh as a caller or a file gives it: nothing is known of it but that the arrays fit together.
#pragma once

#include <span>

#include "mesh/surface.h"

namespace ts::mesh {

struct RawMesh {
  Vec<Vec3> position;     // in the caller's unit
  Vec<Index> corner;      // the corners of all faces, one face after another; may name vertices that are not there
  Vec<Index> face_start;  // faces + 1 offsets into `corner`; empty if all faces are triangles

  std::size_t faces() const { return face_start.empty() ? corner.size() / 3 : face_start.size() - 1; }
  std::span<const Index> face(std::size_t f) const {
    if (face_start.empty()) return {corner.data() + 3 * f, 3};
    return {corner.data() + face_start[f], corner.data() + face_start[f + 1]};
  }
};

enum class Scalar { float32, float64 };

// Copies a caller's arrays. `stride`: bytes from one vertex to the next, 0 = packed. `triangles` null = soup: three
// vertices a face; then `triangle_count` is 0 or vertex_count / 3.
RawMesh from_arrays(const void *positions, Scalar scalar, std::size_t vertex_count, std::size_t stride,
                    const Index *triangles, std::size_t triangle_count);

}  // namespace ts::mesh
