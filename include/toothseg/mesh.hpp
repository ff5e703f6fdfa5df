// Of toothseg.hpp: teeth and gingiva as meshes of their own. SPDX-License-Identifier: Apache-2.0
#ifndef TOOTHSEG_MESH_HPP
#define TOOTHSEG_MESH_HPP

#include "segmentation.hpp"

namespace toothseg {

inline ts_tooth_mesh_options tooth_mesh_options() {
  return detail::initialised<ts_tooth_mesh_options>(ts_tooth_mesh_options_init);
}

// A tooth or the gingiva as a mesh of its own.
class Mesh {
 public:
  static Mesh tooth(const Segmentation &segmentation, Index tooth,
                    const ts_tooth_mesh_options &options = tooth_mesh_options(), Job *job = nullptr) {
    return Mesh(detail::made<Handle>(
        [&](ts_mesh **out) {
          return ts_tooth_mesh_create(segmentation.get(), tooth, &options, detail::handle(job), out);
        },
        job));
  }
  static Mesh gingiva(const Segmentation &segmentation, const ts_tooth_mesh_options &options = tooth_mesh_options(),
                      Job *job = nullptr) {
    return Mesh(detail::made<Handle>(
        [&](ts_mesh **out) { return ts_gingiva_mesh_create(segmentation.get(), &options, detail::handle(job), out); },
        job));
  }

  ts_mesh_info info() const {
    return detail::info<ts_mesh_info>([&](auto *i) { return ts_mesh_get_info(get(), i); });
  }
  std::vector<Point> positions() const {
    return detail::points([&](auto... a) { return ts_mesh_get_positions(get(), a...); });
  }
  std::vector<Point> normals() const {
    return detail::points([&](auto... a) { return ts_mesh_get_normals(get(), a...); });
  }
  std::vector<Triangle> triangles() const {
    return detail::triangles([&](auto... a) { return ts_mesh_get_triangles(get(), a...); });
  }
  std::vector<Index> faces() const {
    return detail::elements<Index>([&](auto... a) { return ts_mesh_get_faces(get(), a...); });
  }
  std::vector<std::uint8_t> vertex_flags() const {
    return detail::elements<std::uint8_t>([&](auto... a) { return ts_mesh_get_vertex_flags(get(), a...); });
  }
  void save(const std::string &path, ts_output_format format, Job *job = nullptr) const {
    detail::check(ts_mesh_save(get(), path.c_str(), format, detail::handle(job)), job);
  }

  ts_mesh *get() const noexcept { return handle_.get(); }

 private:
  using Handle = detail::Owner<ts_mesh, ts_mesh_destroy>;
  explicit Mesh(Handle handle) noexcept : handle_(std::move(handle)) {}

  Handle handle_;
};

}  // namespace toothseg

#endif  // TOOTHSEG_MESH_HPP
