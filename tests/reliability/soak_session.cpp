// SPDX-License-Identifier: Apache-2.0
#include "soak_session.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "check.h"

namespace {

using Index = std::uint32_t;
using Point = std::array<double, 3>;

// Cancels at its `left`-th callback.
int cancel_after(double, const char *, void *left) {
  return --*static_cast<int *>(left) <= 0;
}

// `call(job)` is cancelled at its second callback, and gives nothing.
template <class Call>
void cancelled(ts_context *context, const Call &call) {
  int left = 2;
  const auto job = made<ts_job>([&](ts_job **out) { return ts_job_create(context, cancel_after, &left, out); });
  HOLDS(job != nullptr);
  HOLDS(call(job.get()) == TS_E_CANCELLED);
}

std::vector<char> stl_of(const Scan &scan) {
  const auto faces = static_cast<std::uint32_t>(scan.triangles.size() / 3);
  std::vector<char> bytes(84 + std::size_t{50} * faces, 0);
  std::memcpy(&bytes[80], &faces, 4);
  for (std::size_t f = 0; f < faces; ++f)
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t d = 0; d < 3; ++d) {
        const auto x = static_cast<float>(scan.xyz[3 * scan.triangles[3 * f + k] + d]);
        std::memcpy(&bytes[84 + 50 * f + 12 * (k + 1) + 4 * d], &x, 4);
      }
  return bytes;
}

Handle<ts_model> model_from(ts_context *context, const Scan &scan, bool soup) {
  ts_mesh_input input;
  HOLDS(ts_mesh_input_init(&input, sizeof input) == TS_OK);
  input.scalar = TS_FLOAT64;
  input.positions = scan.xyz.data(), input.vertex_count = static_cast<Index>(scan.xyz.size() / 3);
  input.triangles = scan.triangles.data(), input.triangle_count = static_cast<Index>(scan.triangles.size() / 3);
  const std::vector<char> stl = soup ? stl_of(scan) : std::vector<char>();
  const auto make = [&](ts_job *job, ts_model **out) {
    return soup ? ts_model_read(context, stl.data(), stl.size(), TS_FORMAT_AUTO, nullptr, job, out)
                : ts_model_create(context, &input, nullptr, job, out);
  };
  ts_model *none = nullptr;
  cancelled(context, [&](ts_job *job) { return make(job, &none); });
  auto model = made<ts_model>([&](ts_model **out) { return make(nullptr, out); });
  HOLDS(model != nullptr && none == nullptr);
  return model;
}

// What reading refuses.
void bad_files(ts_context *context, const std::string &path) {
  ts_model *none = nullptr;
  HOLDS(ts_model_load(context, (path + ".not-there").c_str(), nullptr, nullptr, &none) == TS_E_FILE_OPEN);
  const char text[] = "OFF\n3 1 0\n0 0 0\n9 0 0\n0 nine 0\n3 0 1 2\n";
  HOLDS(ts_model_read(context, text, sizeof text - 1, TS_FORMAT_AUTO, nullptr, nullptr, &none) == TS_E_FILE_SYNTAX);
}

Handle<ts_features> features_from(ts_context *context, const ts_model *model) {
  ts_features *none = nullptr;
  cancelled(context, [&](ts_job *job) { return ts_detect_features(model, nullptr, job, &none); });
  auto features =
      made<ts_features>([&](ts_features **out) { return ts_detect_features(model, nullptr, nullptr, out); });
  HOLDS(features != nullptr && none == nullptr);
  // A copy that is edited, and goes again.
  const auto copy = made<ts_features>([&](ts_features **out) { return ts_features_clone(features.get(), out); });
  const auto points = check::all<ts_feature_point>(
      [&](ts_feature_point *p, Index n, Index *c) { return ts_features_get_points(copy.get(), p, n, c); });
  HOLDS(points.size() > 10);
  Index point = TS_NONE;
  HOLDS(ts_features_add_point(copy.get(), points[0].position, TS_NONE, &point, nullptr) == TS_OK);
  HOLDS(ts_features_move_point(copy.get(), point, points[1].position) == TS_OK);
  HOLDS(ts_features_remove_point(copy.get(), point) == TS_OK);
  HOLDS(ts_features_remove_group(copy.get(), points.back().group) == TS_OK);
  return features;
}

std::vector<Index> teeth_of(const ts_segmentation *s) {
  return check::all<Index>([&](Index *p, Index n, Index *c) { return ts_get_teeth(s, p, n, c); });
}
std::vector<Index> labels_of(const ts_segmentation *s) {
  return check::all<Index>([&](Index *p, Index n, Index *c) { return ts_get_labels(s, p, n, c); });
}

void clicks(ts_context *context, ts_segmentation *s) {
  const auto proposed =
      check::all<double>([&](double *p, Index n, Index *c) { return ts_propose_clicks(s, p, n, c); }, 3);
  HOLDS(proposed.size() >= 12);
  cancelled(context, [&](ts_job *job) { return ts_segment_click(s, proposed.data(), job, nullptr); });
  HOLDS(teeth_of(s).empty());
  for (std::size_t k = 0; k < 6; k += 3) check::status(ts_segment_click(s, &proposed[k], nullptr, nullptr), {6});
  HOLDS(ts_segment_clicks(s, &proposed[6], static_cast<Index>(proposed.size() / 3 - 2), nullptr, nullptr) == TS_OK);
  cancelled(context, [&](ts_job *job) { return ts_segment_all(s, job); });
  HOLDS(ts_segment_all(s, nullptr) == TS_OK);
  Index count = 0;
  HOLDS(ts_get_click_count(s, &count) == TS_OK && count > 0);
  // What is worked out when it is first asked for.
  HOLDS(!check::all<double>([&](double *p, Index n, Index *c) { return ts_get_field(s, 0, p, n, c); }).empty());
  HOLDS(!check::all<ts_contour_info>([&](ts_contour_info *p, Index n, Index *c) {
           return ts_get_contours(s, 0, p, n, c);
         }).empty());
}

Point between(const Point &a, const Point &b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

// Corrections and edits, as far as they are taken; how many were.
long edits(ts_segmentation *s, const std::vector<Index> &teeth) {
  long taken = 0;
  const auto step = [&](ts_status got) {
    check::status(got, {6});
    taken += got == TS_OK;
    return got == TS_OK;
  };
  const auto step_and_back = [&](ts_status got) {
    if (step(got)) HOLDS(ts_undo(s) == TS_OK);
  };
  for (std::size_t k = 0; k < teeth.size(); k += 7) {
    const Index tooth = teeth[k], other = teeth[(k + 1) % teeth.size()];
    ts_tooth_frame frame;
    frame.struct_size = sizeof frame;
    HOLDS(ts_get_tooth_frame(s, tooth, &frame) == TS_OK);
    const auto cut = check::all<ts_edge_point>(
        [&](ts_edge_point *p, Index n, Index *c) { return ts_get_cut(s, tooth, 0, nullptr, p, n, c); });
    const auto at = [&](std::size_t i) {
      const ts_edge_point &p = cut[i % cut.size()];
      return Point{p.position[0], p.position[1], p.position[2]};
    };
    const Point centre = {frame.centre[0], frame.centre[1], frame.centre[2]};
    const std::size_t third = cut.size() / 3;
    step(ts_cut_drag(s, tooth, 0, static_cast<Index>(third), between(at(third), centre, -0.12).data(), 0, nullptr));
    step(ts_cut_smooth(s, tooth, 0.3, nullptr));
    step(ts_cut_offset(s, tooth, 0.2, nullptr));
    step_and_back(ts_cut_reset(s, tooth));
    const double stroke[] = {at(0)[0], at(0)[1], at(0)[2], at(9)[0], at(9)[1], at(9)[2]};
    step_and_back(ts_cut_draw(s, other, stroke, 2, nullptr));
    step(ts_tooth_include(s, tooth, between(at(0), centre, 0.3).data(), nullptr));
    step(ts_tooth_exclude(s, tooth, between(at(third), centre, 0.05).data(), nullptr));
    step_and_back(ts_tooth_split(s, tooth, between(at(0), centre, 0.4).data(),
                                 between(at(cut.size() / 2), centre, 0.4).data(), nullptr, nullptr));
    step_and_back(ts_tooth_merge(s, tooth, other, nullptr));
    step(ts_tooth_set_locked(s, tooth, 1));
    HOLDS(ts_tooth_remove(s, tooth) == TS_E_LOCKED);
    step(ts_tooth_set_locked(s, tooth, 0));
    step_and_back(ts_tooth_remove(s, tooth));
  }
  return taken;
}

void numbers(ts_segmentation *s, const std::vector<Index> &teeth) {
  HOLDS(ts_assign_numbers(s, nullptr) == TS_OK);
  ts_number_info number;
  number.struct_size = sizeof number;
  HOLDS(ts_get_number(s, teeth[0], &number) == TS_OK);
  HOLDS(ts_set_number(s, teeth[0], number.fdi) == TS_OK);
}

// To the beginning and to the end again: the same bytes.
void there_and_back(ts_segmentation *s) {
  const auto labels = labels_of(s);
  ts_history_info history;
  history.struct_size = sizeof history;
  HOLDS(ts_get_history(s, &history) == TS_OK && history.complete == 1);
  for (Index k = 0; k < history.undo; ++k) HOLDS(ts_undo(s) == TS_OK);
  HOLDS(teeth_of(s).empty());
  for (Index k = 0; k < history.undo; ++k) HOLDS(ts_redo(s) == TS_OK);
  HOLDS(labels_of(s) == labels);
}

void meshes(const ts_segmentation *s, const std::vector<Index> &teeth, const std::string &path) {
  ts_tooth_mesh_options closed;
  HOLDS(ts_tooth_mesh_options_init(&closed, sizeof closed) == TS_OK);
  closed.closed = 1;
  long watertight = 0;
  for (std::size_t k = 0; k <= teeth.size(); k += teeth.size() / 3) {
    ts_status got;
    const auto part = made<ts_mesh>(
        [&](ts_mesh **out) {
          return k < teeth.size() ? ts_tooth_mesh_create(s, teeth[k], &closed, nullptr, out)
                                  : ts_gingiva_mesh_create(s, &closed, nullptr, out);
        },
        &got);
    check::status(got, {6, 7});
    if (!part) continue;
    ++watertight;
    HOLDS(ts_mesh_save(part.get(), (path + ".stl").c_str(), TS_OUTPUT_STL, nullptr) == TS_OK);
  }
  HOLDS(watertight > 0);
  check::status(ts_segmentation_save(s, (path + ".glb").c_str(), TS_OUTPUT_GLB, nullptr, nullptr), {6});
}

void saved_and_loaded(ts_context *context, const ts_model *model, const ts_segmentation *s, const std::string &path) {
  const std::string file = path + ".json";
  HOLDS(ts_session_save(s, file.c_str()) == TS_OK);
  ts_segmentation *none = nullptr;
  cancelled(context, [&](ts_job *job) { return ts_session_load(model, file.c_str(), job, nullptr, &none); });
  ts_features *features = nullptr;
  const auto again = made<ts_segmentation>(
      [&](ts_segmentation **out) { return ts_session_load(model, file.c_str(), nullptr, &features, out); });
  ts_features_destroy(features);
  HOLDS(again != nullptr && none == nullptr && features != nullptr && labels_of(again.get()) == labels_of(s));
}

}  // namespace

SessionOutcome soak_session(ts_context *context, const Scan &scan, bool soup, const std::string &path) {
  bad_files(context, path);
  auto model = model_from(context, scan, soup);
  auto features = features_from(context, model.get());
  ts_segmentation *none = nullptr;
  cancelled(context, [&](ts_job *job) { return ts_segmentation_create(features.get(), nullptr, job, &none); });
  const auto s = made<ts_segmentation>(
      [&](ts_segmentation **out) { return ts_segmentation_create(features.get(), nullptr, nullptr, out); });
  HOLDS(s != nullptr && none == nullptr);
  features.reset();
  clicks(context, s.get());
  const auto teeth = teeth_of(s.get());
  HOLDS(teeth.size() > 8);
  const long taken = edits(s.get(), teeth);
  numbers(s.get(), teeth);
  there_and_back(s.get());
  meshes(s.get(), teeth_of(s.get()), path);
  saved_and_loaded(context, model.get(), s.get(), path);
  model.reset();  // the segmentation keeps it
  std::uint64_t hash = 14695981039346656037u;
  for (const Index label : labels_of(s.get())) hash = (hash ^ label) * 1099511628211u;
  return {hash, taken};
}

Handle<ts_segmentation> soak_case(ts_context *context, const Scan &scan) {
  const auto model = model_from(context, scan, false);
  const auto features = features_from(context, model.get());
  auto s = made<ts_segmentation>(
      [&](ts_segmentation **out) { return ts_segmentation_create(features.get(), nullptr, nullptr, out); });
  HOLDS(s != nullptr && ts_segment_all(s.get(), nullptr) == TS_OK);
  return s;
}

void soak_corrections(ts_segmentation *s) {
  const auto teeth = teeth_of(s);
  const auto labels = labels_of(s);
  HOLDS(teeth.size() > 8);
  const auto and_back = [&](ts_status got) {
    HOLDS(got == TS_OK);
    HOLDS(ts_undo(s) == TS_OK);
  };
  and_back(ts_cut_smooth(s, teeth[1], 0.3, nullptr));
  and_back(ts_cut_offset(s, teeth[2], 0.2, nullptr));
  and_back(ts_tooth_merge(s, teeth[3], teeth[4], nullptr));
  and_back(ts_tooth_remove(s, teeth[5]));
  and_back(ts_assign_numbers(s, nullptr));
  const auto mesh =
      made<ts_mesh>([&](ts_mesh **out) { return ts_tooth_mesh_create(s, teeth[0], nullptr, nullptr, out); });
  HOLDS(mesh != nullptr);
  HOLDS(!check::all<char>([&](char *p, Index n, Index *c) { return ts_session_write(s, p, n, c); }).empty());
  HOLDS(labels_of(s) == labels);
}
