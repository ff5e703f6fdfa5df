#include "mesh/raw_mesh.h"

#include <cstring>
#include <numeric>

#include "base/stop.h"

namespace ts::mesh {
namespace {

template <class Real>
void copy_positions(const void *from, std::size_t stride, Vec<Vec3> &to) {
  const auto *bytes = static_cast<const std::byte *>(from);
  StopNowAndThen stop(1 << 16);
  for (Vec3 &p : to) {
    stop();
    Real xyz[3];  // the caller's array may be unaligned
    std::memcpy(xyz, bytes, sizeof xyz);
    p = Vec3(xyz[0], xyz[1], xyz[2]);
    bytes += stride;
  }
}

}  // namespace

RawMesh from_arrays(const void *positions, Scalar scalar, std::size_t vertex_count, std::size_t stride,
                    const Index *triangles, std::size_t triangle_count) {
  const std::size_t packed = 3 * (scalar == Scalar::float32 ? sizeof(float) : sizeof(double));
  if (stride == 0) stride = packed;
  if (stride < packed)
    throw Error(Fault::invalid_argument,
                "stride of " + std::to_string(stride) + " bytes is less than a vertex's " + std::to_string(packed));
  if (vertex_count > 0 && !positions) throw Error(Fault::null, "positions is NULL, vertex_count is not 0");
  if (!triangles && (vertex_count % 3 != 0 || (triangle_count != 0 && triangle_count != vertex_count / 3)))
    throw Error(Fault::invalid_argument, "a soup of " + std::to_string(vertex_count) + " vertices is not " +
                                             (triangle_count ? std::to_string(triangle_count) : "a whole number of") +
                                             " triangles");
  if (vertex_count > none || triangle_count > none / 3)
    throw Error(Fault::mesh_too_large, "more than 2^30 vertices or faces");
  RawMesh raw;
  raw.position.resize(vertex_count);
  if (scalar == Scalar::float32)
    copy_positions<float>(positions, stride, raw.position);
  else
    copy_positions<double>(positions, stride, raw.position);
  if (triangles) {
    raw.corner.assign(triangles, triangles + 3 * triangle_count);
  } else {
    raw.corner.resize(vertex_count);
    std::iota(raw.corner.begin(), raw.corner.end(), 0);
  }
  return raw;
}

}  // namespace ts::mesh
