// SPDX-License-Identifier: Apache-2.0
#include "thread_rules.h"

namespace {

using Index = std::uint32_t;

ts_segmentation *own(Objects &o) {
  return o.segmentation.get();
}

// The status of a call that may refuse, and what stands after it.
std::string after(Objects &o, ts_status status) {
  check::status(status, {6, 7});
  return ts_status_name(status) + all_of(o.s());
}
std::string after(const ts_features *f, ts_status status) {
  HOLDS(status == TS_OK);
  return all_of(f);
}

// On the surface, beside the top of a bump.
std::array<double, 3> beside(const Objects &o, std::size_t bump, double dx, double dy) {
  const auto &top = rule_bumps().top[bump];
  const double above[3] = {top[0] + dx, top[1] + dy, 50}, down[3] = {0, 0, -1};
  ts_surface_point p;
  HOLDS(ts_model_raycast(o.model, above, down, &p) == TS_OK);
  return {p.position[0], p.position[1], p.position[2]};
}

ts_feature_point first_point(const Objects &o) {
  return check::all<ts_feature_point>(
      [&](ts_feature_point *p, Index n, Index *c) { return ts_features_get_points(o.features.get(), p, n, c); })[0];
}

std::vector<ts_edge_point> cut_of(const Objects &o, Index tooth) {
  return check::all<ts_edge_point>(
      [&](ts_edge_point *p, Index n, Index *c) { return ts_get_cut(o.s(), tooth, 0, nullptr, p, n, c); });
}

void count_changes(void *user, const std::uint32_t *, std::uint32_t count) {
  *static_cast<std::uint32_t *>(user) += count;
}

std::vector<Rule> destroyers() {
  return {
      {"ts_context_destroy",
       [](Objects &) {
         ts_context *context = nullptr;
         HOLDS(ts_context_create(nullptr, &context) == TS_OK);
         ts_context_destroy(context);
         return std::string("gone");
       }},
      {"ts_job_reset",
       [](Objects &o) {
         ts_job_cancel(o.job.get());
         ts_job_reset(o.job.get());
         return after(o, ts_segment_all(own(o), o.job.get()));
       }},
      {"ts_job_destroy",
       [](Objects &o) {
         o.job.reset();
         return std::string("gone");
       }},
      {"ts_model_destroy",
       [](Objects &o) {
         return all_of(model_of(o.context, rule_bumps()).get());  // which then goes
       }},
      {"ts_features_destroy",
       [](Objects &o) {
         o.features.reset();
         return all_of(o.s());
       }},
      {"ts_segmentation_destroy",
       [](Objects &o) {
         o.segmentation.reset();
         return all_of(o.mesh.get());
       }},
      {"ts_mesh_destroy",
       [](Objects &o) {
         o.mesh.reset();
         return all_of(o.s());
       }},
  };
}

std::vector<Rule> of_features() {
  return {
      {"ts_features_set_occlusal",
       [](Objects &o) {
         const double d[3] = {0.1, 0, 1};
         return after(o.features.get(), ts_features_set_occlusal(o.features.get(), d));
       }},
      {"ts_features_add_point",
       [](Objects &o) {
         const auto at = beside(o, 1, 1, 1);
         return after(o.features.get(), ts_features_add_point(o.features.get(), at.data(), TS_NONE, nullptr, nullptr));
       }},
      {"ts_features_move_point",
       [](Objects &o) {
         const auto at = beside(o, 0, 0.5, 0.5);
         return after(o.features.get(), ts_features_move_point(o.features.get(), first_point(o).id, at.data()));
       }},
      {"ts_features_set_group",
       [](Objects &o) {
         return after(o.features.get(), ts_features_set_group(o.features.get(), first_point(o).id, TS_NONE, nullptr));
       }},
      {"ts_features_remove_point",
       [](Objects &o) {
         return after(o.features.get(), ts_features_remove_point(o.features.get(), first_point(o).id));
       }},
      {"ts_features_remove_group",
       [](Objects &o) {
         return after(o.features.get(), ts_features_remove_group(o.features.get(), first_point(o).group));
       }},
  };
}

std::vector<Rule> of_segmentations() {
  return {
      {"ts_segment_click",
       [](Objects &o) { return after(o, ts_segment_click(own(o), rule_bumps().top[2].data(), nullptr, nullptr)); }},
      {"ts_segment_clicks",
       [](Objects &o) {
         std::vector<double> at;
         for (const auto &top : rule_bumps().top) at.insert(at.end(), top.begin(), top.end());
         return after(o, ts_segment_clicks(own(o), at.data(), static_cast<Index>(at.size() / 3), nullptr, nullptr));
       }},
      {"ts_segment_all", [](Objects &o) { return after(o, ts_segment_all(own(o), nullptr)); }},
      {"ts_tooth_include",
       [](Objects &o) { return after(o, ts_tooth_include(own(o), o.teeth[0], beside(o, 0, 2, 1).data(), nullptr)); }},
      {"ts_tooth_exclude",
       [](Objects &o) { return after(o, ts_tooth_exclude(own(o), o.teeth[0], beside(o, 0, 2, 0).data(), nullptr)); }},
      {"ts_tooth_split",
       [](Objects &o) {
         return after(o, ts_tooth_split(own(o), o.teeth[0], beside(o, 0, -1, 0).data(), beside(o, 0, 1.5, 1).data(),
                                        nullptr, nullptr));
       }},
      {"ts_tooth_move_point",
       [](Objects &o) {
         return after(o, ts_tooth_move_point(own(o), o.teeth[0], rule_bumps().top[0].data(),
                                             beside(o, 0, 0.5, 0.5).data(), nullptr));
       }},
      {"ts_tooth_merge", [](Objects &o) { return after(o, ts_tooth_merge(own(o), o.teeth[0], o.teeth[1], nullptr)); }},
      {"ts_tooth_remove", [](Objects &o) { return after(o, ts_tooth_remove(own(o), o.teeth[0])); }},
      {"ts_tooth_set_locked", [](Objects &o) { return after(o, ts_tooth_set_locked(own(o), o.teeth[0], 1)); }},
      {"ts_undo", [](Objects &o) { return after(o, ts_undo(own(o))); }},
      {"ts_redo",
       [](Objects &o) {
         HOLDS(ts_undo(own(o)) == TS_OK);
         return after(o, ts_redo(own(o)));
       }},
      {"ts_set_history_limit", [](Objects &o) { return after(o, ts_set_history_limit(own(o), 1000)); }},
      {"ts_set_change_callback",
       [](Objects &o) {
         std::uint32_t changes = 0;
         HOLDS(ts_set_change_callback(own(o), count_changes, &changes) == TS_OK);
         HOLDS(ts_undo(own(o)) == TS_OK);
         HOLDS(ts_set_change_callback(own(o), nullptr, nullptr) == TS_OK);
         return bytes_of(changes);
       }},
      {"ts_assign_numbers", [](Objects &o) { return after(o, ts_assign_numbers(own(o), nullptr)); }},
      {"ts_set_number", [](Objects &o) { return after(o, ts_set_number(own(o), o.teeth[0], 33)); }},
      {"ts_cut_drag",
       [](Objects &o) {
         const auto cut = cut_of(o, o.teeth[0]);
         const std::size_t k = cut.size() / 2;
         const double to[3] = {cut[k].position[0] + 0.5, cut[k].position[1] + 0.3, cut[k].position[2]};
         return after(o, ts_cut_drag(own(o), o.teeth[0], 0, static_cast<Index>(k), to, 0, nullptr));
       }},
      {"ts_cut_draw",
       [](Objects &o) {
         const auto cut = cut_of(o, o.teeth[0]);
         const double *const a = cut[0].position, *const b = cut[cut.size() / 4].position;
         const double stroke[6] = {a[0], a[1], a[2], b[0], b[1], b[2]};
         return after(o, ts_cut_draw(own(o), o.teeth[0], stroke, 2, nullptr));
       }},
      {"ts_cut_offset", [](Objects &o) { return after(o, ts_cut_offset(own(o), o.teeth[0], 0.3, nullptr)); }},
      {"ts_cut_smooth", [](Objects &o) { return after(o, ts_cut_smooth(own(o), o.teeth[0], 0.5, nullptr)); }},
      {"ts_cut_reset", [](Objects &o) { return after(o, ts_cut_reset(own(o), o.teeth[1])); }},
  };
}

}  // namespace

std::vector<Rule> exclusive_rules() {
  std::vector<Rule> all;
  for (const auto &part : {destroyers(), of_features(), of_segmentations()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}
