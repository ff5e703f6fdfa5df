// Of toothseg.hpp: the scan and its feature points. SPDX-License-Identifier: Apache-2.0
#ifndef TOOTHSEG_SCAN_HPP
#define TOOTHSEG_SCAN_HPP

#include "base.hpp"

namespace toothseg {

inline ts_intake_options intake_options() {
  return detail::initialised<ts_intake_options>(ts_intake_options_init);
}
inline ts_feature_options feature_options() {
  return detail::initialised<ts_feature_options>(ts_feature_options_init);
}

// Describes the caller's arrays, which must live until the model is made from them.
template <class Real>
ts_mesh_input mesh_input(const std::vector<Real> &xyz, const std::vector<Index> &triangles) {
  static_assert(std::is_same_v<Real, float> || std::is_same_v<Real, double>, "coordinates are float or double");
  ts_mesh_input input = detail::initialised<ts_mesh_input>(ts_mesh_input_init);
  input.scalar = std::is_same_v<Real, float> ? TS_FLOAT32 : TS_FLOAT64;
  input.positions = xyz.data();
  input.vertex_count = detail::count32(xyz.size() / 3);
  input.triangles = triangles.data();
  input.triangle_count = detail::count32(triangles.size() / 3);
  return input;
}

// --------------------------------------------------------------------------------------------------------------- model

class Model {
 public:
  Model(const Context &context, const ts_mesh_input &input, const ts_intake_options &options = intake_options(),
        Job *job = nullptr)
      : handle_(detail::made<Handle>(
            [&](ts_model **out) { return ts_model_create(context.get(), &input, &options, detail::handle(job), out); },
            job)) {}

  static Model load(const Context &context, const std::string &path,
                    const ts_intake_options &options = intake_options(), Job *job = nullptr) {
    return Model(detail::made<Handle>(
        [&](ts_model **out) { return ts_model_load(context.get(), path.c_str(), &options, detail::handle(job), out); },
        job));
  }

  static Model read(const Context &context, const void *bytes, std::size_t size, ts_file_format format = TS_FORMAT_AUTO,
                    const ts_intake_options &options = intake_options(), Job *job = nullptr) {
    return Model(detail::made<Handle>(
        [&](ts_model **out) {
          return ts_model_read(context.get(), bytes, size, format, &options, detail::handle(job), out);
        },
        job));
  }

  ts_intake_report report() const {
    return detail::info<ts_intake_report>([&](auto *r) { return ts_model_get_report(get(), r); });
  }
  std::vector<Point> positions() const {
    return detail::points([&](auto... a) { return ts_model_get_positions(get(), a...); });
  }
  std::vector<Triangle> triangles() const {
    return detail::triangles([&](auto... a) { return ts_model_get_triangles(get(), a...); });
  }
  std::vector<Index> face_sources() const {
    return detail::elements<Index>([&](auto... a) { return ts_model_get_face_sources(get(), a...); });
  }
  std::vector<Index> vertex_map() const {
    return detail::elements<Index>([&](auto... a) { return ts_model_get_vertex_map(get(), a...); });
  }

  ts_surface_point nearest(const Point &position) const {
    ts_surface_point p{};
    detail::check(ts_model_nearest(get(), position.data(), &p));
    return p;
  }
  ts_surface_point raycast(const Point &origin, const Point &direction) const {
    ts_surface_point p{};
    detail::check(ts_model_raycast(get(), origin.data(), direction.data(), &p));
    return p;
  }

  ts_model *get() const noexcept { return handle_.get(); }

 private:
  using Handle = detail::Owner<ts_model, ts_model_destroy>;
  explicit Model(Handle handle) noexcept : handle_(std::move(handle)) {}

  Handle handle_;
};

// ------------------------------------------------------------------------------------------------------------ features

class Features {
 public:
  // An empty set, to be filled by hand.
  explicit Features(const Model &model)
      : handle_(detail::made<Handle>([&](ts_features **out) { return ts_features_create(model.get(), out); })) {}

  static Features detect(const Model &model, const ts_feature_options &options = feature_options(),
                         Job *job = nullptr) {
    return Features(detail::made<Handle>(
        [&](ts_features **out) { return ts_detect_features(model.get(), &options, detail::handle(job), out); }, job));
  }

  Features clone() const {
    return Features(detail::made<Handle>([&](ts_features **out) { return ts_features_clone(get(), out); }));
  }

  ts_features_info info() const {
    return detail::info<ts_features_info>([&](auto *i) { return ts_features_get_info(get(), i); });
  }
  Point occlusal() const {
    Point d{};
    detail::check(ts_features_get_occlusal(get(), d.data()));
    return d;
  }
  void set_occlusal(const Point &direction) { detail::check(ts_features_set_occlusal(get(), direction.data())); }

  std::vector<Point> arch() const {
    return detail::points([&](auto... a) { return ts_features_get_arch(get(), a...); });
  }
  std::vector<ts_feature_point> points() const {
    return detail::elements<ts_feature_point>([&](auto... a) { return ts_features_get_points(get(), a...); });
  }
  std::vector<ts_feature_group> groups() const {
    return detail::elements<ts_feature_group>([&](auto... a) { return ts_features_get_groups(get(), a...); });
  }

  struct Place {
    Index point;
    Index group;
  };
  Place add_point(const Point &position, Index group = TS_NONE) {
    Place place{};
    detail::check(ts_features_add_point(get(), position.data(), group, &place.point, &place.group));
    return place;
  }
  void move_point(Index point, const Point &position) {
    detail::check(ts_features_move_point(get(), point, position.data()));
  }
  Index set_group(Index point, Index group = TS_NONE) {
    Index now = TS_NONE;
    detail::check(ts_features_set_group(get(), point, group, &now));
    return now;
  }
  void remove_point(Index point) { detail::check(ts_features_remove_point(get(), point)); }
  void remove_group(Index group) { detail::check(ts_features_remove_group(get(), group)); }

  ts_features *get() const noexcept { return handle_.get(); }

 private:
  friend struct Session;
  using Handle = detail::Owner<ts_features, ts_features_destroy>;
  explicit Features(Handle handle) noexcept : handle_(std::move(handle)) {}

  Handle handle_;
};

}  // namespace toothseg

#endif  // TOOTHSEG_SCAN_HPP
