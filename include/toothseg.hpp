// toothseg.hpp - toothseg.h for C++17: owners, vectors and exceptions instead of destroy functions, buffers and
// statuses. SPDX-License-Identifier: Apache-2.0
//
// Nothing but inline code over toothseg.h, whose comments are the manual: units, indices, threads and lifetimes are as
// said there, and the C structs and enumerators are used as they are. In addition:
//   Owners      are move-only. A moved-from one may only be assigned to or destroyed. Children keep their parents
//               alive, so owners may go in any order. get() gives the C handle to call toothseg.h with.
//   Failures    throw Exception, with nothing changed. What a progress callback throws comes out of the call it
//   stopped. Jobs        are given by pointer; nullptr: no progress, no cancellation.
#ifndef TOOTHSEG_HPP
#define TOOTHSEG_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "toothseg.h"

namespace toothseg {

using Index = std::uint32_t;
using Point = std::array<double, 3>;

class Exception : public std::runtime_error {
 public:
  Exception(ts_status status, const std::string &what) : std::runtime_error(what), status_(status) {}
  ts_status status() const noexcept { return status_; }

 private:
  ts_status status_;
};

namespace detail {

inline void check(ts_status status) {
  if (status != TS_OK) throw Exception(status, ts_last_error_message());
}

inline std::uint32_t count32(std::size_t n) {
  if (n > std::numeric_limits<std::uint32_t>::max())
    throw Exception(TS_E_INVALID_ARGUMENT, "more than 2^32 - 1 elements");
  return static_cast<std::uint32_t>(n);
}

template <auto destroy>
struct Destroy {
  template <class Handle>
  void operator()(Handle *handle) const noexcept {
    destroy(handle);
  }
};
template <class Handle, auto destroy>
using Owner = std::unique_ptr<Handle, Destroy<destroy>>;

// The options or the result of a struct that begins with struct_size.
template <class Struct, class Init>
Struct initialised(Init init) {
  Struct s{};
  check(init(&s, static_cast<std::uint32_t>(sizeof(Struct))));
  return s;
}
template <class Struct, class Get>
Struct info(Get get) {
  Struct s{};
  s.struct_size = static_cast<std::uint32_t>(sizeof(Struct));
  check(get(&s));
  return s;
}

// The two calls of a getter: for the size, for the elements. get(T *, capacity, count).
template <class T, class Get>
std::vector<T> elements(Get get) {
  std::uint32_t n = 0;
  check(get(static_cast<T *>(nullptr), 0u, &n));
  std::vector<T> out(n);
  if (n != 0) check(get(out.data(), n, &n));
  return out;
}

// The same where three doubles make an element.
static_assert(sizeof(Point) == 3 * sizeof(double), "points are packed");
template <class Get>
std::vector<Point> points(Get get) {
  return elements<Point>([&](Point *p, std::uint32_t capacity, std::uint32_t *count) {
    return get(p ? p->data() : nullptr, capacity, count);
  });
}

}  // namespace detail

inline ts_number_options number_options() {
  return detail::initialised<ts_number_options>(ts_number_options_init);
}
inline ts_context_options context_options() {
  return detail::initialised<ts_context_options>(ts_context_options_init);
}
inline ts_intake_options intake_options() {
  return detail::initialised<ts_intake_options>(ts_intake_options_init);
}
inline ts_feature_options feature_options() {
  return detail::initialised<ts_feature_options>(ts_feature_options_init);
}
inline ts_segment_options segment_options(ts_preset preset = TS_PRESET_DEFAULT) {
  return detail::initialised<ts_segment_options>(
      [&](ts_segment_options *o, std::uint32_t size) { return ts_segment_options_init(o, size, preset); });
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

// ------------------------------------------------------------------------------------------------------------- context

// The hooks in the options, and what their user pointers point to, must outlive every object made from the context, not
// only the Context itself.
class Context {
 public:
  explicit Context(const ts_context_options &options = context_options()) {
    ts_context *handle = nullptr;
    detail::check(ts_context_create(&options, &handle));
    handle_.reset(handle);
  }

  ts_context *get() const noexcept { return handle_.get(); }

 private:
  detail::Owner<ts_context, ts_context_destroy> handle_;
};

// ----------------------------------------------------------------------------------------------------------------- job

class Job {
 public:
  // Called during a long call, from a thread that works for it. True: go on; false: cancel.
  using Callback = std::function<bool(double fraction, const char *stage)>;

  explicit Job(const Context &context, Callback callback = {}) : state_(std::make_unique<State>()) {
    const bool calls_back = static_cast<bool>(callback);
    state_->callback = std::move(callback);
    ts_job *handle = nullptr;
    detail::check(ts_job_create(context.get(), calls_back ? &proceed : nullptr, state_.get(), &handle));
    handle_.reset(handle);
  }

  void cancel() noexcept { ts_job_cancel(handle_.get()); }  // from any thread
  void reset() noexcept { ts_job_reset(handle_.get()); }
  double progress() const noexcept { return ts_job_progress(handle_.get()); }
  ts_job *get() const noexcept { return handle_.get(); }

  // Throws what the callback threw, else what the status says.
  void check(ts_status status) {
    if (std::exception_ptr thrown = std::exchange(state_->thrown, nullptr)) std::rethrow_exception(thrown);
    detail::check(status);
  }

 private:
  struct State {
    Callback callback;
    std::exception_ptr thrown;
  };

  static int proceed(double fraction, const char *stage, void *user) noexcept {
    State &state = *static_cast<State *>(user);
    try {
      return state.callback(fraction, stage) ? 0 : 1;
    } catch (...) {
      state.thrown = std::current_exception();
      return 1;
    }
  }

  std::unique_ptr<State> state_;  // at an address of its own, which the handle knows; outlives it
  detail::Owner<ts_job, ts_job_destroy> handle_;
};

namespace detail {
inline ts_job *handle(Job *job) noexcept {
  return job ? job->get() : nullptr;
}
inline void check(ts_status status, Job *job) {
  job ? job->check(status) : check(status);
}
}  // namespace detail

// --------------------------------------------------------------------------------------------------------------- model

class Model {
 public:
  Model(const Context &context, const ts_mesh_input &input, const ts_intake_options &options = intake_options(),
        Job *job = nullptr)
      : Model(
            [&](ts_model **out) { return ts_model_create(context.get(), &input, &options, detail::handle(job), out); },
            job) {}

  static Model load(const Context &context, const std::string &path,
                    const ts_intake_options &options = intake_options(), Job *job = nullptr) {
    return Model(
        [&](ts_model **out) { return ts_model_load(context.get(), path.c_str(), &options, detail::handle(job), out); },
        job);
  }

  static Model read(const Context &context, const void *bytes, std::size_t size, ts_file_format format = TS_FORMAT_AUTO,
                    const ts_intake_options &options = intake_options(), Job *job = nullptr) {
    return Model(
        [&](ts_model **out) {
          return ts_model_read(context.get(), bytes, size, format, &options, detail::handle(job), out);
        },
        job);
  }

  ts_intake_report report() const {
    return detail::info<ts_intake_report>([&](auto *r) { return ts_model_get_report(get(), r); });
  }
  std::vector<Point> positions() const {
    return detail::points([&](auto... a) { return ts_model_get_positions(get(), a...); });
  }
  std::vector<std::array<Index, 3>> triangles() const {
    using Triangle = std::array<Index, 3>;
    return detail::elements<Triangle>([&](Triangle *t, std::uint32_t capacity, std::uint32_t *count) {
      return ts_model_get_triangles(get(), t ? t->data() : nullptr, capacity, count);
    });
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
  template <class Make>
  Model(Make make, Job *job) {
    ts_model *handle = nullptr;
    const ts_status status = make(&handle);
    handle_.reset(handle);  // first: a callback may have thrown at the very end
    detail::check(status, job);
  }

  detail::Owner<ts_model, ts_model_destroy> handle_;
};

// ------------------------------------------------------------------------------------------------------------ features

class Features {
 public:
  // An empty set, to be filled by hand.
  explicit Features(const Model &model)
      : Features([&](ts_features **out) { return ts_features_create(model.get(), out); }, nullptr) {}

  static Features detect(const Model &model, const ts_feature_options &options = feature_options(),
                         Job *job = nullptr) {
    return Features(
        [&](ts_features **out) { return ts_detect_features(model.get(), &options, detail::handle(job), out); }, job);
  }

  Features clone() const {
    return Features([&](ts_features **out) { return ts_features_clone(get(), out); }, nullptr);
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
  template <class Make>
  Features(Make make, Job *job) {
    ts_features *handle = nullptr;
    const ts_status status = make(&handle);
    handle_.reset(handle);  // first: a callback may have thrown at the very end
    detail::check(status, job);
  }

  detail::Owner<ts_features, ts_features_destroy> handle_;
};

// -------------------------------------------------------------------------------------------------------- segmentation

struct Cut {
  ts_cut_info info;
  std::vector<ts_edge_point> points;
};

struct Polyline {
  std::vector<ts_edge_point> points;
  bool closed;
};

class Segmentation {
 public:
  explicit Segmentation(const Features &features, const ts_segment_options &options = segment_options(),
                        Job *job = nullptr) {
    ts_segmentation *handle = nullptr;
    const ts_status status = ts_segmentation_create(features.get(), &options, detail::handle(job), &handle);
    handle_.reset(handle);  // first: a callback may have thrown at the very end
    detail::check(status, job);
  }

  // The number of the click.
  Index click(const Point &position, Job *job = nullptr) {
    Index number = TS_NONE;
    detail::check(ts_segment_click(get(), position.data(), detail::handle(job), &number), job);
    return number;
  }
  // A status a click.
  std::vector<ts_status> clicks(const std::vector<Point> &positions, Job *job = nullptr) {
    std::vector<ts_status> statuses(positions.size(), TS_OK);
    if (positions.empty()) return statuses;
    detail::check(ts_segment_clicks(get(), positions.front().data(), detail::count32(positions.size()),
                                    detail::handle(job), statuses.data()),
                  job);
    return statuses;
  }
  std::vector<Point> propose_clicks() const {
    return detail::points([&](auto... a) { return ts_propose_clicks(get(), a...); });
  }

  Index click_count() const {
    Index n = 0;
    detail::check(ts_get_click_count(get(), &n));
    return n;
  }
  ts_click_info click_info(Index click) const {
    return detail::info<ts_click_info>([&](auto *i) { return ts_get_click(get(), click, i); });
  }
  std::vector<double> field(Index click) const {
    return detail::elements<double>([&](auto... a) { return ts_get_field(get(), click, a...); });
  }
  std::vector<Index> histogram(Index click) const {
    return detail::elements<Index>([&](auto... a) { return ts_get_histogram(get(), click, a...); });
  }
  std::vector<ts_contour_info> contours(Index click) const {
    return detail::elements<ts_contour_info>([&](auto... a) { return ts_get_contours(get(), click, a...); });
  }
  std::vector<Polyline> contour(Index click, Index contour) const;

  std::vector<Index> teeth() const {
    return detail::elements<Index>([&](auto... a) { return ts_get_teeth(get(), a...); });
  }
  ts_tooth_info tooth(Index tooth) const {
    return detail::info<ts_tooth_info>([&](auto *i) { return ts_get_tooth(get(), tooth, i); });
  }
  std::vector<Index> tooth_faces(Index tooth) const {
    return detail::elements<Index>([&](auto... a) { return ts_get_tooth_faces(get(), tooth, a...); });
  }
  std::vector<Index> tooth_vertices(Index tooth) const {
    return detail::elements<Index>([&](auto... a) { return ts_get_tooth_vertices(get(), tooth, a...); });
  }
  std::vector<Index> tooth_seeds(Index tooth) const {
    return detail::elements<Index>([&](auto... a) { return ts_get_tooth_seeds(get(), tooth, a...); });
  }
  Cut cut(Index tooth, Index loop = 0) const {
    Cut cut{};
    cut.info.struct_size = static_cast<std::uint32_t>(sizeof(ts_cut_info));
    cut.points =
        detail::elements<ts_edge_point>([&](auto... a) { return ts_get_cut(get(), tooth, loop, &cut.info, a...); });
    return cut;
  }

  // Edits of a cut: ts_cut_drag and those after it.
  void drag_cut(Index tooth, Index loop, Index point, const Point &to, double reach = 0, Job *job = nullptr) {
    detail::check(ts_cut_drag(get(), tooth, loop, point, to.data(), reach, detail::handle(job)), job);
  }
  void draw_cut(Index tooth, const std::vector<Point> &stroke, Job *job = nullptr) {
    const Point nothing{};
    detail::check(ts_cut_draw(get(), tooth, stroke.empty() ? nothing.data() : stroke.front().data(),
                              detail::count32(stroke.size()), detail::handle(job)),
                  job);
  }
  void offset_cut(Index tooth, double mm, Job *job = nullptr) {
    detail::check(ts_cut_offset(get(), tooth, mm, detail::handle(job)), job);
  }
  void smooth_cut(Index tooth, double strength, Job *job = nullptr) {
    detail::check(ts_cut_smooth(get(), tooth, strength, detail::handle(job)), job);
  }
  void reset_cut(Index tooth) { detail::check(ts_cut_reset(get(), tooth)); }
  std::vector<ts_cut_edit> cut_edits(Index tooth) const {
    return detail::elements<ts_cut_edit>([&](auto... a) { return ts_get_cut_edits(get(), tooth, a...); });
  }

  std::vector<Index> labels() const {
    return detail::elements<Index>([&](auto... a) { return ts_get_labels(get(), a...); });
  }
  ts_tooth_frame tooth_frame(Index tooth) const {
    return detail::info<ts_tooth_frame>([&](auto *f) { return ts_get_tooth_frame(get(), tooth, f); });
  }
  void save(const std::string &path, ts_output_format format, const ts_save_options *options = nullptr,
            Job *job = nullptr) const {
    detail::check(ts_segmentation_save(get(), path.c_str(), format, options, detail::handle(job)), job);
  }
  ts_memory_info memory() const {
    return detail::info<ts_memory_info>([&](auto *m) { return ts_get_memory(get(), m); });
  }
  ts_prepare_times prepare_times() const {
    return detail::info<ts_prepare_times>([&](auto *t) { return ts_get_prepare_times(get(), t); });
  }

  void assign_numbers(const ts_number_options &options = number_options()) {
    detail::check(ts_assign_numbers(get(), &options));
  }
  void set_number(Index tooth, std::uint32_t fdi) { detail::check(ts_set_number(get(), tooth, fdi)); }
  ts_number_info number(Index tooth) const {
    return detail::info<ts_number_info>([&](auto *i) { return ts_get_number(get(), tooth, i); });
  }
  ts_jaw_info jaw() const {
    return detail::info<ts_jaw_info>([&](auto *i) { return ts_get_jaw(get(), i); });
  }

  ts_segmentation *get() const noexcept { return handle_.get(); }

 private:
  detail::Owner<ts_segmentation, ts_segmentation_destroy> handle_;
};

// The C function gives all points in one array and where each polyline starts in it.
inline ts_tooth_mesh_options tooth_mesh_options() {
  return detail::initialised<ts_tooth_mesh_options>(ts_tooth_mesh_options_init);
}

// A tooth or the gingiva as a mesh of its own.
class Mesh {
 public:
  static Mesh tooth(const Segmentation &s, Index tooth, const ts_tooth_mesh_options &options = tooth_mesh_options(),
                    Job *job = nullptr) {
    return made([&](ts_mesh **out) {
      return ts_tooth_mesh_create(s.get(), tooth, &options, detail::handle(job), out);
    }, job);
  }
  static Mesh gingiva(const Segmentation &s, const ts_tooth_mesh_options &options = tooth_mesh_options(),
                      Job *job = nullptr) {
    return made([&](ts_mesh **out) { return ts_gingiva_mesh_create(s.get(), &options, detail::handle(job), out); },
                job);
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
  // 3 vertices a triangle.
  std::vector<std::array<Index, 3>> triangles() const {
    return detail::elements<std::array<Index, 3>>([&](auto *p, auto capacity, auto *count) {
      return ts_mesh_get_triangles(get(), p ? p->data() : nullptr, capacity, count);
    });
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
  template <class Make>
  static Mesh made(Make make, Job *job) {
    ts_mesh *handle = nullptr;
    const ts_status status = make(&handle);
    Mesh mesh;
    mesh.handle_.reset(handle);  // first: a callback may have thrown at the very end
    detail::check(status, job);
    return mesh;
  }

  detail::Owner<ts_mesh, ts_mesh_destroy> handle_;
};

inline std::vector<Polyline> Segmentation::contour(Index click, Index contour) const {
  const std::vector<ts_contour_info> infos = contours(click);
  if (contour >= infos.size()) throw Exception(TS_E_NOT_FOUND, "no contour " + std::to_string(contour));
  const std::size_t polylines = infos[contour].polylines;
  std::vector<Index> starts(polylines);
  std::vector<std::uint8_t> closed(polylines);
  const std::vector<ts_edge_point> all =
      detail::elements<ts_edge_point>([&](ts_edge_point *p, std::uint32_t capacity, std::uint32_t *count) {
        return ts_get_contour_points(get(), click, contour, p, capacity, count, p ? starts.data() : nullptr,
                                     p ? closed.data() : nullptr);
      });
  std::vector<Polyline> out(polylines);
  for (std::size_t i = 0; i < polylines; ++i) {
    const std::size_t end = i + 1 < polylines ? starts[i + 1] : all.size();
    out[i].points.assign(all.begin() + static_cast<std::ptrdiff_t>(starts[i]),
                         all.begin() + static_cast<std::ptrdiff_t>(end));
    out[i].closed = closed[i] != 0;
  }
  return out;
}

}  // namespace toothseg

#endif  // TOOTHSEG_HPP
