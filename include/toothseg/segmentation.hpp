// Of toothseg.hpp: teeth, their cuts, corrections and numbers, and the session. SPDX-License-Identifier: Apache-2.0
#ifndef TOOTHSEG_SEGMENTATION_HPP
#define TOOTHSEG_SEGMENTATION_HPP

#include <string_view>

#include "scan.hpp"

namespace toothseg {

inline ts_segment_options segment_options(ts_preset preset = TS_PRESET_DEFAULT) {
  return detail::initialised<ts_segment_options>(
      [&](ts_segment_options *o, std::uint32_t size) { return ts_segment_options_init(o, size, preset); });
}
inline ts_number_options number_options() {
  return detail::initialised<ts_number_options>(ts_number_options_init);
}
inline ts_save_options save_options() {
  return detail::initialised<ts_save_options>(ts_save_options_init);
}

inline Index fdi_to_universal(Index fdi) {
  Index universal = 0;
  detail::check(ts_fdi_to_universal(fdi, &universal));
  return universal;
}
inline Index universal_to_fdi(Index universal) {
  Index fdi = 0;
  detail::check(ts_universal_to_fdi(universal, &fdi));
  return fdi;
}
inline ts_palmer fdi_to_palmer(Index fdi) {
  return detail::info<ts_palmer>([&](auto *palmer) { return ts_fdi_to_palmer(fdi, palmer); });
}

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
                        Job *job = nullptr)
      : handle_(detail::made<Handle>(
            [&](ts_segmentation **out) {
              return ts_segmentation_create(features.get(), &options, detail::handle(job), out);
            },
            job)) {}

  // The number of the click.
  Index click(const Point &position, Job *job = nullptr) {
    Index number = TS_NONE;
    changed(ts_segment_click(get(), position.data(), detail::handle(job), &number), job);
    return number;
  }
  // A status a click.
  std::vector<ts_status> clicks(const std::vector<Point> &positions, Job *job = nullptr) {
    std::vector<ts_status> statuses(positions.size(), TS_OK);
    if (positions.empty()) return statuses;
    changed(ts_segment_clicks(get(), positions.front().data(), detail::count32(positions.size()), detail::handle(job),
                              statuses.data()),
            job);
    return statuses;
  }
  void segment_all(Job *job = nullptr) { changed(ts_segment_all(get(), detail::handle(job)), job); }
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

  // Corrections of a tooth: ts_tooth_include and those after it.
  void include_point(Index tooth, const Point &position, Job *job = nullptr) {
    changed(ts_tooth_include(get(), tooth, position.data(), detail::handle(job)), job);
  }
  void exclude_point(Index tooth, const Point &position, Job *job = nullptr) {
    changed(ts_tooth_exclude(get(), tooth, position.data(), detail::handle(job)), job);
  }
  // The new tooth.
  Index split_tooth(Index tooth, const Point &keep, const Point &part, Job *job = nullptr) {
    Index second = TS_NONE;
    changed(ts_tooth_split(get(), tooth, keep.data(), part.data(), detail::handle(job), &second), job);
    return second;
  }
  void move_point(Index tooth, const Point &from, const Point &to, Job *job = nullptr) {
    changed(ts_tooth_move_point(get(), tooth, from.data(), to.data(), detail::handle(job)), job);
  }
  void merge_teeth(Index tooth, Index other, Job *job = nullptr) {
    changed(ts_tooth_merge(get(), tooth, other, detail::handle(job)), job);
  }
  void remove_tooth(Index tooth) { changed(ts_tooth_remove(get(), tooth)); }
  void set_locked(Index tooth, bool locked) { changed(ts_tooth_set_locked(get(), tooth, locked ? 1 : 0)); }
  bool locked(Index tooth) const {
    Index locked = 0;
    detail::check(ts_tooth_get_locked(get(), tooth, &locked));
    return locked != 0;
  }
  std::vector<ts_review_item> review() const {
    return detail::elements<ts_review_item>([&](auto... a) { return ts_get_review(get(), a...); });
  }
  std::vector<ts_overlap> overlaps() const {
    return detail::elements<ts_overlap>([&](auto... a) { return ts_get_overlaps(get(), a...); });
  }

  // Edits of a cut: ts_cut_drag and those after it.
  void drag_cut(Index tooth, Index loop, Index point, const Point &to, double reach = 0, Job *job = nullptr) {
    changed(ts_cut_drag(get(), tooth, loop, point, to.data(), reach, detail::handle(job)), job);
  }
  void draw_cut(Index tooth, const std::vector<Point> &stroke, Job *job = nullptr) {
    const Point nothing{};
    changed(ts_cut_draw(get(), tooth, stroke.empty() ? nothing.data() : stroke.front().data(),
                        detail::count32(stroke.size()), detail::handle(job)),
            job);
  }
  void offset_cut(Index tooth, double mm, Job *job = nullptr) {
    changed(ts_cut_offset(get(), tooth, mm, detail::handle(job)), job);
  }
  void smooth_cut(Index tooth, double strength, Job *job = nullptr) {
    changed(ts_cut_smooth(get(), tooth, strength, detail::handle(job)), job);
  }
  void reset_cut(Index tooth) { changed(ts_cut_reset(get(), tooth)); }
  std::vector<ts_cut_edit> cut_edits(Index tooth) const {
    return detail::elements<ts_cut_edit>([&](auto... a) { return ts_get_cut_edits(get(), tooth, a...); });
  }

  std::vector<Index> labels() const {
    return detail::elements<Index>([&](auto... a) { return ts_get_labels(get(), a...); });
  }
  ts_tooth_frame tooth_frame(Index tooth) const {
    return detail::info<ts_tooth_frame>([&](auto *f) { return ts_get_tooth_frame(get(), tooth, f); });
  }
  void save(const std::string &path, ts_output_format format, const ts_save_options &options = save_options(),
            Job *job = nullptr) const {
    detail::check(ts_segmentation_save(get(), path.c_str(), format, &options, detail::handle(job)), job);
  }
  ts_memory_info memory() const {
    return detail::info<ts_memory_info>([&](auto *m) { return ts_get_memory(get(), m); });
  }
  ts_prepare_times prepare_times() const {
    return detail::info<ts_prepare_times>([&](auto *t) { return ts_get_prepare_times(get(), t); });
  }

  void assign_numbers(const ts_number_options &options = number_options()) {
    changed(ts_assign_numbers(get(), &options));
  }
  void set_number(Index tooth, std::uint32_t fdi) { changed(ts_set_number(get(), tooth, fdi)); }
  ts_number_info number(Index tooth) const {
    return detail::info<ts_number_info>([&](auto *i) { return ts_get_number(get(), tooth, i); });
  }
  ts_jaw_info jaw() const {
    return detail::info<ts_jaw_info>([&](auto *i) { return ts_get_jaw(get(), i); });
  }

  void undo() { changed(ts_undo(get())); }
  void redo() { changed(ts_redo(get())); }
  ts_history_info history() const {
    return detail::info<ts_history_info>([&](auto *i) { return ts_get_history(get(), i); });
  }
  void set_history_limit(std::uint64_t bytes) { detail::check(ts_set_history_limit(get(), bytes)); }
  std::vector<Index> changes() const {
    return detail::elements<Index>([&](auto... a) { return ts_get_changes(get(), a...); });
  }

  // Called with what changes() tells, after the change. It may read the segmentation, and must not change, move or
  // destroy it.
  using ChangeCallback = std::function<void(const std::vector<Index> &teeth)>;
  void on_change(ChangeCallback callback) {
    std::unique_ptr<Listener> listener;
    if (callback) listener.reset(new Listener{std::move(callback), nullptr});
    detail::check(ts_set_change_callback(get(), listener ? &tell : nullptr, listener.get()));
    listener_ = std::move(listener);
  }

  // The session as text or file, for Session to read.
  std::string write_session() const {
    return detail::elements<char, std::string>([&](auto... a) { return ts_session_write(get(), a...); });
  }
  void save_session(const std::string &path) const { detail::check(ts_session_save(get(), path.c_str())); }

  ts_segmentation *get() const noexcept { return handle_.get(); }

 private:
  friend struct Session;
  using Handle = detail::Owner<ts_segmentation, ts_segmentation_destroy>;
  explicit Segmentation(Handle handle) noexcept : handle_(std::move(handle)) {}

  struct Listener {
    ChangeCallback callback;
    std::exception_ptr thrown;
  };

  static void tell(void *user, const std::uint32_t *teeth, std::uint32_t count) noexcept {
    Listener &listener = *static_cast<Listener *>(user);
    try {
      listener.callback({teeth, teeth + count});
    } catch (...) {
      listener.thrown = std::current_exception();
    }
  }

  // What came of a call that may have changed something.
  void changed(ts_status status, Job *job = nullptr) {
    const std::exception_ptr thrown = listener_ ? std::exchange(listener_->thrown, nullptr) : nullptr;
    detail::check(status, job);
    if (thrown) std::rethrow_exception(thrown);
  }

  std::unique_ptr<Listener> listener_;  // at an address of its own, which the handle knows; outlives it
  Handle handle_;
};

// A session gone through again: the features as they were, and the segmentation, to go on with.
struct Session {
  Features features;
  Segmentation segmentation;

  static Session load(const Model &model, const std::string &path, Job *job = nullptr) {
    return made([&](auto... out) { return ts_session_load(model.get(), path.c_str(), detail::handle(job), out...); },
                job);
  }
  // From what write_session() gave.
  static Session read(const Model &model, std::string_view text, Job *job = nullptr) {
    return made(
        [&](auto... out) {
          return ts_session_read(model.get(), text.data(), text.size(), detail::handle(job), out...);
        },
        job);
  }

 private:
  template <class Make>
  static Session made(Make make, Job *job) {
    Features::Handle features;
    auto segmentation = detail::made<Segmentation::Handle>(
        [&](ts_segmentation **out) {
          ts_features *handle = nullptr;
          const ts_status status = make(&handle, out);
          features.reset(handle);
          return status;
        },
        job);
    return {Features(std::move(features)), Segmentation(std::move(segmentation))};
  }
};

// The C function gives all points of a contour in one array and where each polyline starts in it.
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

#endif  // TOOTHSEG_SEGMENTATION_HPP
