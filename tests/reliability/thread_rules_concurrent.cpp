// SPDX-License-Identifier: Apache-2.0
#include <cerrno>
#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

#include "thread_rules.h"

namespace {

using Index = std::uint32_t;

// It is there whole at any time, but on Windows not to be opened while another thread puts it in place.
std::string content_of(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  for (int i = 0; i < 1000 && !file && errno == EACCES; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    file.open(path, std::ios::binary);
  }
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string session_text(const Objects &o) {
  return got<char>([&](char *p, Index n, Index *c) { return ts_session_write(o.s(), p, n, c); });
}

std::vector<Rule> of_models() {
  return {
      {"ts_model_get_report",
       [](Objects &o) {
         return info<ts_intake_report>([&](ts_intake_report *r) { return ts_model_get_report(o.model, r); });
       }},
      {"ts_model_get_positions",
       [](Objects &o) {
         return got<double>([&](double *p, Index n, Index *c) { return ts_model_get_positions(o.model, p, n, c); }, 3);
       }},
      {"ts_model_get_triangles",
       [](Objects &o) {
         return got<Index>([&](Index *p, Index n, Index *c) { return ts_model_get_triangles(o.model, p, n, c); }, 3);
       }},
      {"ts_model_get_face_sources",
       [](Objects &o) {
         return got<Index>([&](Index *p, Index n, Index *c) { return ts_model_get_face_sources(o.model, p, n, c); });
       }},
      {"ts_model_get_vertex_map",
       [](Objects &o) {
         return got<Index>([&](Index *p, Index n, Index *c) { return ts_model_get_vertex_map(o.model, p, n, c); });
       }},
      {"ts_model_nearest",
       [](Objects &o) {
         const double at[3] = {7, 1, 9};
         ts_surface_point p;
         HOLDS(ts_model_nearest(o.model, at, &p) == TS_OK);
         return bytes_of(p);
       }},
      {"ts_model_raycast",
       [](Objects &o) {
         const double from[3] = {8, 1, 50}, down[3] = {0, 0, -1};
         ts_surface_point p;
         HOLDS(ts_model_raycast(o.model, from, down, &p) == TS_OK);
         return bytes_of(p);
       }},
      {"ts_detect_features",
       [](Objects &o) {
         return made_bytes<ts_features>(
             [&](ts_features **out) { return ts_detect_features(o.model, nullptr, nullptr, out); });
       }},
      {"ts_features_create",
       [](Objects &o) {
         return made_bytes<ts_features>([&](ts_features **out) { return ts_features_create(o.model, out); });
       }},
      {"ts_session_read",
       [](Objects &o) {
         const std::string text = session_text(o);
         return made_bytes<ts_segmentation>([&](ts_segmentation **out) {
           return ts_session_read(o.model, text.data(), text.size(), nullptr, nullptr, out);
         });
       }},
      {"ts_session_load",
       [](Objects &o) {
         const std::string path = o.path + ".json";  // written by all, the same, and there whole at any time
         HOLDS(ts_session_save(o.s(), path.c_str()) == TS_OK);
         return made_bytes<ts_segmentation>(
             [&](ts_segmentation **out) { return ts_session_load(o.model, path.c_str(), nullptr, nullptr, out); });
       }},
  };
}

std::vector<Rule> of_features() {
  return {
      {"ts_features_clone",
       [](Objects &o) {
         return made_bytes<ts_features>([&](ts_features **out) { return ts_features_clone(o.features.get(), out); });
       }},
      {"ts_features_get_info",
       [](Objects &o) {
         return info<ts_features_info>([&](ts_features_info *i) { return ts_features_get_info(o.features.get(), i); });
       }},
      {"ts_features_get_occlusal",
       [](Objects &o) {
         double d[3];
         HOLDS(ts_features_get_occlusal(o.features.get(), d) == TS_OK);
         return bytes_of(d, 3);
       }},
      {"ts_features_get_arch",
       [](Objects &o) {
         return got<double>(
             [&](double *p, Index n, Index *c) { return ts_features_get_arch(o.features.get(), p, n, c); }, 3);
       }},
      {"ts_features_get_points",
       [](Objects &o) {
         return got<ts_feature_point>(
             [&](ts_feature_point *p, Index n, Index *c) { return ts_features_get_points(o.features.get(), p, n, c); });
       }},
      {"ts_features_get_groups",
       [](Objects &o) {
         return got<ts_feature_group>(
             [&](ts_feature_group *p, Index n, Index *c) { return ts_features_get_groups(o.features.get(), p, n, c); });
       }},
      {"ts_segmentation_create",
       [](Objects &o) {
         return made_bytes<ts_segmentation>(
             [&](ts_segmentation **out) { return ts_segmentation_create(o.features.get(), nullptr, nullptr, out); });
       }},
  };
}

std::vector<Rule> of_segmentations() {
  return {
      {"ts_propose_clicks",
       [](Objects &o) {
         return got<double>([&](double *p, Index n, Index *c) { return ts_propose_clicks(o.s(), p, n, c); }, 3);
       }},
      {"ts_get_click_count",
       [](Objects &o) {
         Index n = 0;
         HOLDS(ts_get_click_count(o.s(), &n) == TS_OK);
         return bytes_of(n);
       }},
      {"ts_get_click",
       [](Objects &o) { return info<ts_click_info>([&](ts_click_info *i) { return ts_get_click(o.s(), 0, i); }); }},
      {"ts_get_field",
       [](Objects &o) {
         return got<double>([&](double *p, Index n, Index *c) { return ts_get_field(o.s(), 0, p, n, c); });
       }},
      {"ts_get_histogram",
       [](Objects &o) {
         return got<Index>([&](Index *p, Index n, Index *c) { return ts_get_histogram(o.s(), 0, p, n, c); });
       }},
      {"ts_get_contours",
       [](Objects &o) {
         return got<ts_contour_info>(
             [&](ts_contour_info *p, Index n, Index *c) { return ts_get_contours(o.s(), 0, p, n, c); });
       }},
      {"ts_get_contour_points",
       [](Objects &o) {
         return got<ts_edge_point>([&](ts_edge_point *p, Index n, Index *c) {
           return ts_get_contour_points(o.s(), 0, 50, p, n, c, nullptr, nullptr);
         });
       }},
      {"ts_get_teeth",
       [](Objects &o) {
         return got<Index>([&](Index *p, Index n, Index *c) { return ts_get_teeth(o.s(), p, n, c); });
       }},
      {"ts_get_tooth",
       [](Objects &o) {
         return info<ts_tooth_info>([&](ts_tooth_info *i) { return ts_get_tooth(o.s(), o.teeth[0], i); });
       }},
      {"ts_get_tooth_faces",
       [](Objects &o) {
         return got<Index>([&](Index *p, Index n, Index *c) { return ts_get_tooth_faces(o.s(), o.teeth[0], p, n, c); });
       }},
      {"ts_get_tooth_vertices",
       [](Objects &o) {
         return got<Index>(
             [&](Index *p, Index n, Index *c) { return ts_get_tooth_vertices(o.s(), o.teeth[0], p, n, c); });
       }},
      {"ts_get_tooth_seeds",
       [](Objects &o) {
         return got<Index>([&](Index *p, Index n, Index *c) { return ts_get_tooth_seeds(o.s(), o.teeth[0], p, n, c); });
       }},
      {"ts_get_cut",
       [](Objects &o) {
         return got<ts_edge_point>(
             [&](ts_edge_point *p, Index n, Index *c) { return ts_get_cut(o.s(), o.teeth[0], 0, nullptr, p, n, c); });
       }},
      {"ts_get_labels",
       [](Objects &o) {
         return got<Index>([&](Index *p, Index n, Index *c) { return ts_get_labels(o.s(), p, n, c); });
       }},
      {"ts_get_prepare_times",
       [](Objects &o) {
         return info<ts_prepare_times>([&](ts_prepare_times *t) { return ts_get_prepare_times(o.s(), t); });
       }},
      {"ts_get_memory",
       [](Objects &o) {
         auto bytes = info<ts_memory_info>([&](ts_memory_info *i) { return ts_get_memory(o.s(), i); });
         return std::to_string(bytes.size());  // grows with what others ask for
       }},
      {"ts_get_review",
       [](Objects &o) {
         return got<ts_review_item>(
             [&](ts_review_item *p, Index n, Index *c) { return ts_get_review(o.s(), p, n, c); });
       }},
      {"ts_tooth_get_locked",
       [](Objects &o) {
         Index locked = 7;
         HOLDS(ts_tooth_get_locked(o.s(), o.teeth[0], &locked) == TS_OK);
         return bytes_of(locked);
       }},
      {"ts_get_overlaps",
       [](Objects &o) {
         return got<ts_overlap>([&](ts_overlap *p, Index n, Index *c) { return ts_get_overlaps(o.s(), p, n, c); });
       }},
      {"ts_get_history",
       [](Objects &o) { return info<ts_history_info>([&](ts_history_info *i) { return ts_get_history(o.s(), i); }); }},
      {"ts_get_changes",
       [](Objects &o) {
         return got<Index>([&](Index *p, Index n, Index *c) { return ts_get_changes(o.s(), p, n, c); });
       }},
      {"ts_session_write", [](Objects &o) { return session_text(o); }},
      {"ts_session_save",
       [](Objects &o) {
         const std::string path = o.path + ".saved";
         HOLDS(ts_session_save(o.s(), path.c_str()) == TS_OK);
         return content_of(path);
       }},
      {"ts_get_number",
       [](Objects &o) {
         return info<ts_number_info>([&](ts_number_info *i) { return ts_get_number(o.s(), o.teeth[0], i); });
       }},
      {"ts_get_jaw",
       [](Objects &o) { return info<ts_jaw_info>([&](ts_jaw_info *i) { return ts_get_jaw(o.s(), i); }); }},
      {"ts_get_cut_edits",
       [](Objects &o) {
         return got<ts_cut_edit>(
             [&](ts_cut_edit *p, Index n, Index *c) { return ts_get_cut_edits(o.s(), o.teeth[1], p, n, c); });
       }},
      {"ts_tooth_mesh_create",
       [](Objects &o) {
         ts_tooth_mesh_options closed;
         HOLDS(ts_tooth_mesh_options_init(&closed, sizeof closed) == TS_OK);
         closed.closed = 1;
         return made_bytes<ts_mesh>(
             [&](ts_mesh **out) { return ts_tooth_mesh_create(o.s(), o.teeth[0], &closed, nullptr, out); });
       }},
      {"ts_gingiva_mesh_create",
       [](Objects &o) {
         return made_bytes<ts_mesh>(
             [&](ts_mesh **out) { return ts_gingiva_mesh_create(o.s(), nullptr, nullptr, out); });
       }},
      {"ts_segmentation_save",
       [](Objects &o) {
         const std::string path = o.path + ".glb";
         HOLDS(ts_segmentation_save(o.s(), path.c_str(), TS_OUTPUT_GLB, nullptr, nullptr) == TS_OK);
         return content_of(path);
       }},
      {"ts_get_tooth_frame",
       [](Objects &o) {
         return info<ts_tooth_frame>([&](ts_tooth_frame *f) { return ts_get_tooth_frame(o.s(), o.teeth[0], f); });
       }},
  };
}

std::vector<Rule> of_meshes() {
  return {
      {"ts_mesh_get_info",
       [](Objects &o) {
         return info<ts_mesh_info>([&](ts_mesh_info *i) { return ts_mesh_get_info(o.mesh.get(), i); });
       }},
      {"ts_mesh_get_positions",
       [](Objects &o) {
         return got<double>([&](double *p, Index n, Index *c) { return ts_mesh_get_positions(o.mesh.get(), p, n, c); },
                            3);
       }},
      {"ts_mesh_get_normals",
       [](Objects &o) {
         return got<double>([&](double *p, Index n, Index *c) { return ts_mesh_get_normals(o.mesh.get(), p, n, c); },
                            3);
       }},
      {"ts_mesh_get_triangles",
       [](Objects &o) {
         return got<Index>([&](Index *p, Index n, Index *c) { return ts_mesh_get_triangles(o.mesh.get(), p, n, c); },
                           3);
       }},
      {"ts_mesh_get_faces",
       [](Objects &o) {
         return got<Index>([&](Index *p, Index n, Index *c) { return ts_mesh_get_faces(o.mesh.get(), p, n, c); });
       }},
      {"ts_mesh_get_vertex_flags",
       [](Objects &o) {
         return got<std::uint8_t>(
             [&](std::uint8_t *p, Index n, Index *c) { return ts_mesh_get_vertex_flags(o.mesh.get(), p, n, c); });
       }},
      {"ts_mesh_save",
       [](Objects &o) {
         const std::string path = o.path + ".stl";
         HOLDS(ts_mesh_save(o.mesh.get(), path.c_str(), TS_OUTPUT_STL, nullptr) == TS_OK);
         return content_of(path);
       }},
  };
}

}  // namespace

std::vector<Rule> concurrent_rules() {
  std::vector<Rule> all;
  for (const auto &part : {of_models(), of_features(), of_segmentations(), of_meshes()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}
