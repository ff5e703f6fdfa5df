// Every allocation fails once: of every public function, first those of the context's allocator, then all of the C
// heap. The call says TS_E_OUT_OF_MEMORY, nothing has changed, nothing leaks, and the same call works afterwards.
//   test_faults FOLDER [CALL]
//   test_faults FOLDER --quick: ever rarer ones, all of the first 200, then one in each half percent.
//   test_faults FOLDER --triangles N --sampled COUNT: some allocations of each long call, on a larger mesh.
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <string>

#include "check.h"
#include "faults_sampled.h"
#include "heap.h"
#include "scene.h"

namespace {

// ------------------------------------------------------------------------------------------------- the hook's memory

struct Hook {
  long taken = 0, live = 0;
  long fails_at = 0;  // 0: never
};
void *take(std::size_t bytes, void *user) {
  Hook &h = *static_cast<Hook *>(user);
  if (++h.taken == h.fails_at) return nullptr;
  void *p = nullptr;
  if (posix_memalign(&p, 16, bytes) != 0) return nullptr;
  ++h.live;
  return p;
}
void give(void *memory, void *user) {
  --static_cast<Hook *>(user)->live;
  std::free(memory);
}

// ------------------------------------------------------------------------------------------------------ what is there

struct Scene {
  explicit Scene(Hook &hook) : bumps(make_bumps(3, 4, 4)) {
    ts_context_options options;
    HOLDS(ts_context_options_init(&options, sizeof options) == TS_OK);
    options.threads = 1;
    options.alloc = take, options.free = give, options.alloc_user = &hook;
    context = made<ts_context>([&](ts_context **out) { return ts_context_create(&options, out); });
    model = model_of(context.get(), bumps);
    features = features_of(model.get(), bumps);
    segmentation = made<ts_segmentation>(
        [&](ts_segmentation **out) { return ts_segmentation_create(features.get(), nullptr, nullptr, out); });
    HOLDS(segmentation != nullptr);
    HOLDS(ts_segment_click(segmentation.get(), bumps.top[0].data(), nullptr, nullptr) == TS_OK);
    HOLDS(ts_assign_numbers(segmentation.get(), nullptr) == TS_OK);
    teeth = check::all<std::uint32_t>(
        [&](std::uint32_t *p, std::uint32_t n, std::uint32_t *c) { return ts_get_teeth(segmentation.get(), p, n, c); });
    HOLDS(teeth.size() == 2);
    HOLDS(ts_cut_smooth(segmentation.get(), teeth[1], 0.3, nullptr) == TS_OK);
    HOLDS(ts_segment_click(segmentation.get(), bumps.top[2].data(), nullptr, nullptr) == TS_OK);
    HOLDS(ts_undo(segmentation.get()) == TS_OK);
    session = text();
    for (const auto &p : check::all<ts_feature_point>([&](ts_feature_point *q, std::uint32_t n, std::uint32_t *c) {
           return ts_features_get_points(features.get(), q, n, c);
         }))
      if (p.group == teeth[0]) std::copy_n(p.position, 3, top.begin());
  }

  // On the surface, beside the feature point of the first tooth.
  std::array<double, 3> beside(double dx, double dy) const {
    const double above[3] = {top[0] + dx, top[1] + dy, 50}, down[3] = {0, 0, -1};
    ts_surface_point at;
    HOLDS(ts_model_raycast(model.get(), above, down, &at) == TS_OK);
    return {at.position[0], at.position[1], at.position[2]};
  }

  std::vector<char> text() const {
    return check::all<char>(
        [&](char *p, std::uint32_t n, std::uint32_t *c) { return ts_session_write(segmentation.get(), p, n, c); });
  }

  // All that a caller could see of the state.
  std::string state() const {
    const auto labels = check::all<std::uint32_t>([&](std::uint32_t *p, std::uint32_t n, std::uint32_t *c) {
      return ts_get_labels(segmentation.get(), p, n, c);
    });
    const auto points = check::all<ts_feature_point>([&](ts_feature_point *p, std::uint32_t n, std::uint32_t *c) {
      return ts_features_get_points(features.get(), p, n, c);
    });
    const auto groups = check::all<ts_feature_group>([&](ts_feature_group *p, std::uint32_t n, std::uint32_t *c) {
      return ts_features_get_groups(features.get(), p, n, c);
    });
    ts_history_info history;
    history.struct_size = sizeof history;
    HOLDS(ts_get_history(segmentation.get(), &history) == TS_OK);
    std::string all(text().data(), text().size());
    const auto add = [&](const void *data, std::size_t size) { all.append(static_cast<const char *>(data), size); };
    add(labels.data(), labels.size() * sizeof labels[0]);
    add(points.data(), points.size() * sizeof points[0]);
    add(groups.data(), groups.size() * sizeof groups[0]);
    add(&history.undo, 3 * sizeof history.undo);
    return all;
  }

  Bumps bumps;
  Handle<ts_context> context;
  Handle<ts_model> model;
  Handle<ts_features> features;
  Handle<ts_segmentation> segmentation;
  std::vector<std::uint32_t> teeth;
  std::vector<char> session;
  std::array<double, 3> top{};  // of the first tooth
};

// ----------------------------------------------------------------------------------------------------------- the calls

struct Call {
  const char *name;
  std::function<ts_status(Scene &)> run;
  std::function<void(Scene &)> back;  // makes undone what it did
};

// One that makes something, which goes again at once.
template <class T, class Make>
Call maker(const char *name, Make make) {
  return {name,
          [make](Scene &s) {
            T *const untouched = reinterpret_cast<T *>(1);
            T *out = untouched;
            const ts_status got = make(s, &out);
            if (got != TS_OK)
              HOLDS(out == untouched);
            else
              Destroy()(out);
            return got;
          },
          nullptr};
}

std::vector<Call> calls(const std::string &folder) {
  const auto undone = [](Scene &s) { HOLDS(ts_undo(s.segmentation.get()) == TS_OK); };
  // The features as they were: made anew, and the scene forgets the others.
  const auto anew = [](Scene &s) { s.features = features_of(s.model.get(), s.bumps); };
  static std::vector<double> d(1 << 14);
  static std::vector<std::uint32_t> u(1 << 14);
  static std::vector<ts_edge_point> e(1 << 12);
  static std::vector<std::uint8_t> bytes(1 << 14);
  const std::uint32_t many = 1 << 12;
  static std::uint32_t n;
  std::vector<Call> c;
  const auto reads = [&](const char *name, auto run) { c.push_back({name, run, [](Scene &) {}}); };

  c.push_back(maker<ts_context>("ts_context_create",
                                [](Scene &, ts_context **out) { return ts_context_create(nullptr, out); }));
  c.push_back(maker<ts_job>(
      "ts_job_create", [](Scene &s, ts_job **out) { return ts_job_create(s.context.get(), nullptr, nullptr, out); }));
  c.push_back(maker<ts_model>("ts_model_create", [](Scene &s, ts_model **out) {
    const ts_mesh_input input = input_of(s.bumps);
    return ts_model_create(s.context.get(), &input, nullptr, nullptr, out);
  }));
  static const std::string scan = folder + "/faults.ply", session = folder + "/faults.json",
                           written = folder + "/faults.out";
  c.push_back(maker<ts_model>("ts_model_load", [](Scene &s, ts_model **out) {
    return ts_model_load(s.context.get(), scan.c_str(), nullptr, nullptr, out);
  }));
  c.push_back(maker<ts_model>("ts_model_read", [](Scene &s, ts_model **out) {
    static const char off[] = "OFF\n4 4 0\n0 0 0\n20 0 0\n0 20 0\n0 0 20\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
    return ts_model_read(s.context.get(), off, sizeof off - 1, TS_FORMAT_AUTO, nullptr, nullptr, out);
  }));
  c.push_back(maker<ts_features>("ts_detect_features", [](Scene &s, ts_features **out) {
    return ts_detect_features(s.model.get(), nullptr, nullptr, out);
  }));
  c.push_back(maker<ts_features>("ts_features_create",
                                 [](Scene &s, ts_features **out) { return ts_features_create(s.model.get(), out); }));
  c.push_back(maker<ts_features>("ts_features_clone",
                                 [](Scene &s, ts_features **out) { return ts_features_clone(s.features.get(), out); }));
  c.push_back(maker<ts_segmentation>("ts_segmentation_create", [](Scene &s, ts_segmentation **out) {
    return ts_segmentation_create(s.features.get(), nullptr, nullptr, out);
  }));
  c.push_back(maker<ts_segmentation>("ts_session_read", [](Scene &s, ts_segmentation **out) {
    return ts_session_read(s.model.get(), s.session.data(), s.session.size(), nullptr, nullptr, out);
  }));
  c.push_back(maker<ts_segmentation>("ts_session_load", [](Scene &s, ts_segmentation **out) {
    return ts_session_load(s.model.get(), session.c_str(), nullptr, nullptr, out);
  }));
  static const auto closed = [](std::uint32_t yes) {
    ts_tooth_mesh_options o;
    HOLDS(ts_tooth_mesh_options_init(&o, sizeof o) == TS_OK);
    o.closed = yes;
    return o;
  };
  c.push_back(maker<ts_mesh>("ts_tooth_mesh_create", [](Scene &s, ts_mesh **out) {
    return ts_tooth_mesh_create(s.segmentation.get(), s.teeth[0], nullptr, nullptr, out);
  }));
  c.push_back(maker<ts_mesh>("ts_tooth_mesh_create, closed", [](Scene &s, ts_mesh **out) {
    const auto o = closed(1);
    const ts_status got = ts_tooth_mesh_create(s.segmentation.get(), s.teeth[0], &o, nullptr, out);
    return got;
  }));
  c.push_back(maker<ts_mesh>("ts_gingiva_mesh_create", [](Scene &s, ts_mesh **out) {
    return ts_gingiva_mesh_create(s.segmentation.get(), nullptr, nullptr, out);
  }));

  c.push_back({"ts_features_set_occlusal",
               [](Scene &s) {
                 const double up[3] = {0, 0.1, 1};
                 return ts_features_set_occlusal(s.features.get(), up);
               },
               anew});
  c.push_back({"ts_features_add_point",
               [](Scene &s) {
                 const double at[3] = {4, 1, 2};
                 return ts_features_add_point(s.features.get(), at, TS_NONE, nullptr, nullptr);
               },
               anew});
  static const auto point = [](Scene &s) {
    static ts_feature_point p[16];
    HOLDS(ts_features_get_points(s.features.get(), p, 16, nullptr) == TS_OK);
    return p[0];
  };
  c.push_back({"ts_features_move_point",
               [](Scene &s) {
                 const double at[3] = {4, 1, 2};
                 return ts_features_move_point(s.features.get(), point(s).id, at);
               },
               anew});
  c.push_back({"ts_features_set_group",
               [](Scene &s) { return ts_features_set_group(s.features.get(), point(s).id, TS_NONE, nullptr); }, anew});
  c.push_back({"ts_features_remove_point",
               [](Scene &s) { return ts_features_remove_point(s.features.get(), point(s).id); }, anew});
  c.push_back({"ts_features_remove_group",
               [](Scene &s) { return ts_features_remove_group(s.features.get(), point(s).group); }, anew});

  const auto step = [&](const char *name, auto run) {
    c.push_back({name, [run](Scene &s) { return run(s, s.segmentation.get()); }, undone});
  };
  step("ts_segment_click",
       [](Scene &s, ts_segmentation *h) { return ts_segment_click(h, s.bumps.top[2].data(), nullptr, nullptr); });
  step("ts_segment_clicks", [](Scene &s, ts_segmentation *h) {
    double at[6];
    std::copy_n(s.bumps.top[2].data(), 3, at), std::copy_n(s.bumps.top[1].data(), 3, at + 3);
    ts_status each[2] = {TS_OK, TS_OK};
    const ts_status got = ts_segment_clicks(h, at, 2, nullptr, each);
    // A click for which there is no memory is one that failed.
    return got != TS_OK ? got : each[0] != TS_OK ? each[0] : each[1];
  });
  step("ts_segment_all", [](Scene &, ts_segmentation *h) { return ts_segment_all(h, nullptr); });
  step("ts_tooth_include",
       [](Scene &s, ts_segmentation *h) { return ts_tooth_include(h, s.teeth[0], s.beside(1.6, 1).data(), nullptr); });
  step("ts_tooth_exclude", [](Scene &s, ts_segmentation *h) {
    return ts_tooth_exclude(h, s.teeth[0], s.beside(1.6, 0.5).data(), nullptr);
  });
  step("ts_tooth_split", [](Scene &s, ts_segmentation *h) {
    return ts_tooth_split(h, s.teeth[0], s.beside(0, 0).data(), s.beside(-1.6, 1).data(), nullptr, nullptr);
  });
  step("ts_tooth_move_point", [](Scene &s, ts_segmentation *h) {
    return ts_tooth_move_point(h, s.teeth[0], s.beside(0, 0).data(), s.beside(-1, 1.2).data(), nullptr);
  });
  step("ts_tooth_merge",
       [](Scene &s, ts_segmentation *h) { return ts_tooth_merge(h, s.teeth[0], s.teeth[1], nullptr); });
  step("ts_tooth_remove", [](Scene &s, ts_segmentation *h) { return ts_tooth_remove(h, s.teeth[0]); });
  step("ts_tooth_set_locked", [](Scene &s, ts_segmentation *h) { return ts_tooth_set_locked(h, s.teeth[0], 1); });
  step("ts_assign_numbers", [](Scene &, ts_segmentation *h) { return ts_assign_numbers(h, nullptr); });
  step("ts_set_number", [](Scene &s, ts_segmentation *h) { return ts_set_number(h, s.teeth[0], 33); });
  step("ts_cut_drag", [](Scene &s, ts_segmentation *h) {
    ts_edge_point p[1 << 10];
    HOLDS(ts_get_cut(h, s.teeth[0], 0, nullptr, p, 1 << 10, nullptr) == TS_OK);
    const double to[3] = {p[2].position[0], p[2].position[1] - 0.6, p[2].position[2]};
    return ts_cut_drag(h, s.teeth[0], 0, 2, to, 0, nullptr);
  });
  step("ts_cut_draw", [](Scene &s, ts_segmentation *h) {
    ts_edge_point p[1 << 10];
    std::uint32_t points;
    HOLDS(ts_get_cut(h, s.teeth[0], 0, nullptr, p, 1 << 10, &points) == TS_OK);
    double at[9];  // from one place of the line to another, over the crown
    for (const std::uint32_t k : {0u, 1u, 2u})
      std::copy_n(p[(points / 2 + 6 * k - 6) % points].position, 3, at + 3 * k);
    for (std::size_t k = 0; k < 3; ++k) at[3 + k] += (s.top[k] - at[3 + k]) / 2;
    return ts_cut_draw(h, s.teeth[0], at, 3, nullptr);
  });
  step("ts_cut_offset", [](Scene &s, ts_segmentation *h) { return ts_cut_offset(h, s.teeth[0], -0.3, nullptr); });
  step("ts_cut_smooth", [](Scene &s, ts_segmentation *h) { return ts_cut_smooth(h, s.teeth[0], 0.5, nullptr); });
  step("ts_cut_reset", [](Scene &s, ts_segmentation *h) { return ts_cut_reset(h, s.teeth[1]); });
  c.push_back({"ts_undo", [](Scene &s) { return ts_undo(s.segmentation.get()); },
               [](Scene &s) { HOLDS(ts_redo(s.segmentation.get()) == TS_OK); }});
  c.push_back({"ts_redo", [](Scene &s) { return ts_redo(s.segmentation.get()); }, undone});

  reads("ts_model_get_report", [](Scene &s) {
    ts_intake_report r;
    r.struct_size = sizeof r;
    return ts_model_get_report(s.model.get(), &r);
  });
  reads("ts_model_get_positions", [=](Scene &s) { return ts_model_get_positions(s.model.get(), d.data(), many, &n); });
  reads("ts_model_get_triangles", [=](Scene &s) { return ts_model_get_triangles(s.model.get(), u.data(), many, &n); });
  reads("ts_model_get_face_sources",
        [=](Scene &s) { return ts_model_get_face_sources(s.model.get(), u.data(), many, &n); });
  reads("ts_model_get_vertex_map",
        [=](Scene &s) { return ts_model_get_vertex_map(s.model.get(), u.data(), many, &n); });
  reads("ts_model_nearest", [](Scene &s) {
    ts_surface_point p;
    return ts_model_nearest(s.model.get(), s.bumps.top[0].data(), &p);
  });
  reads("ts_model_raycast", [](Scene &s) {
    ts_surface_point p;
    const double from[3] = {3, 0, 30}, down[3] = {0, 0, -1};
    return ts_model_raycast(s.model.get(), from, down, &p);
  });
  reads("ts_features_get_info", [](Scene &s) {
    ts_features_info i;
    i.struct_size = sizeof i;
    return ts_features_get_info(s.features.get(), &i);
  });
  reads("ts_features_get_occlusal", [](Scene &s) { return ts_features_get_occlusal(s.features.get(), d.data()); });
  reads("ts_features_get_arch", [=](Scene &s) { return ts_features_get_arch(s.features.get(), d.data(), many, &n); });
  reads("ts_features_get_points", [](Scene &s) {
    static ts_feature_point p[64];
    return ts_features_get_points(s.features.get(), p, 64, &n);
  });
  reads("ts_features_get_groups", [](Scene &s) {
    static ts_feature_group p[64];
    return ts_features_get_groups(s.features.get(), p, 64, &n);
  });
  reads("ts_propose_clicks", [=](Scene &s) { return ts_propose_clicks(s.segmentation.get(), d.data(), many, &n); });
  reads("ts_get_click", [](Scene &s) {
    ts_click_info i;
    i.struct_size = sizeof i;
    return ts_get_click(s.segmentation.get(), 0, &i);
  });
  reads("ts_get_field", [=](Scene &s) { return ts_get_field(s.segmentation.get(), 0, d.data(), many, &n); });
  reads("ts_get_histogram", [=](Scene &s) { return ts_get_histogram(s.segmentation.get(), 0, u.data(), many, &n); });
  reads("ts_get_contours", [](Scene &s) {
    static ts_contour_info p[128];
    return ts_get_contours(s.segmentation.get(), 0, p, 128, &n);
  });
  reads("ts_get_contour_points", [=](Scene &s) {
    return ts_get_contour_points(s.segmentation.get(), 0, 50, e.data(), many, &n, nullptr, nullptr);
  });
  reads("ts_get_teeth", [=](Scene &s) { return ts_get_teeth(s.segmentation.get(), u.data(), many, &n); });
  reads("ts_get_tooth", [](Scene &s) {
    ts_tooth_info i;
    i.struct_size = sizeof i;
    return ts_get_tooth(s.segmentation.get(), s.teeth[0], &i);
  });
  reads("ts_get_tooth_faces",
        [=](Scene &s) { return ts_get_tooth_faces(s.segmentation.get(), s.teeth[0], u.data(), many, &n); });
  reads("ts_get_tooth_vertices",
        [=](Scene &s) { return ts_get_tooth_vertices(s.segmentation.get(), s.teeth[0], u.data(), many, &n); });
  reads("ts_get_tooth_seeds",
        [=](Scene &s) { return ts_get_tooth_seeds(s.segmentation.get(), s.teeth[0], u.data(), many, &n); });
  reads("ts_get_cut",
        [=](Scene &s) { return ts_get_cut(s.segmentation.get(), s.teeth[0], 0, nullptr, e.data(), many, &n); });
  reads("ts_get_labels", [=](Scene &s) { return ts_get_labels(s.segmentation.get(), u.data(), many, &n); });
  reads("ts_get_review", [](Scene &s) {
    static ts_review_item p[64];
    return ts_get_review(s.segmentation.get(), p, 64, &n);
  });
  reads("ts_get_overlaps", [](Scene &s) {
    static ts_overlap p[64];
    return ts_get_overlaps(s.segmentation.get(), p, 64, &n);
  });
  reads("ts_get_changes", [=](Scene &s) { return ts_get_changes(s.segmentation.get(), u.data(), many, &n); });
  reads("ts_get_cut_edits", [](Scene &s) {
    static ts_cut_edit p[8];
    return ts_get_cut_edits(s.segmentation.get(), s.teeth[1], p, 8, &n);
  });
  reads("ts_get_number", [](Scene &s) {
    ts_number_info i;
    i.struct_size = sizeof i;
    return ts_get_number(s.segmentation.get(), s.teeth[0], &i);
  });
  reads("ts_get_jaw", [](Scene &s) {
    ts_jaw_info i;
    i.struct_size = sizeof i;
    return ts_get_jaw(s.segmentation.get(), &i);
  });
  reads("ts_get_memory", [](Scene &s) {
    ts_memory_info i;
    i.struct_size = sizeof i;
    return ts_get_memory(s.segmentation.get(), &i);
  });
  reads("ts_get_tooth_frame", [](Scene &s) {
    ts_tooth_frame i;
    i.struct_size = sizeof i;
    return ts_get_tooth_frame(s.segmentation.get(), s.teeth[0], &i);
  });
  reads("ts_session_write", [](Scene &s) {
    static char text[1 << 16];
    return ts_session_write(s.segmentation.get(), text, sizeof text, &n);
  });
  reads("ts_session_save", [](Scene &s) { return ts_session_save(s.segmentation.get(), session.c_str()); });
  reads("ts_segmentation_save", [](Scene &s) {
    return ts_segmentation_save(s.segmentation.get(), written.c_str(), TS_OUTPUT_GLB, nullptr, nullptr);
  });
  // A mesh that is there already.
  static const auto with_mesh = [](Scene &s) {
    static std::map<Scene *, Handle<ts_mesh>> meshes;
    auto &m = meshes[&s];
    if (!m)
      m = made<ts_mesh>(
          [&](ts_mesh **out) { return ts_tooth_mesh_create(s.segmentation.get(), s.teeth[0], nullptr, nullptr, out); });
    HOLDS(m != nullptr);
    return m.get();
  };
  reads("ts_mesh_get_positions", [=](Scene &s) { return ts_mesh_get_positions(with_mesh(s), d.data(), many, &n); });
  reads("ts_mesh_get_normals", [=](Scene &s) { return ts_mesh_get_normals(with_mesh(s), d.data(), many, &n); });
  reads("ts_mesh_get_triangles", [=](Scene &s) { return ts_mesh_get_triangles(with_mesh(s), u.data(), many, &n); });
  reads("ts_mesh_get_faces", [=](Scene &s) { return ts_mesh_get_faces(with_mesh(s), u.data(), many, &n); });
  reads("ts_mesh_get_vertex_flags",
        [=](Scene &s) { return ts_mesh_get_vertex_flags(with_mesh(s), bytes.data(), many, &n); });
  reads("ts_mesh_save", [](Scene &s) { return ts_mesh_save(with_mesh(s), written.c_str(), TS_OUTPUT_STL, nullptr); });
  return c;
}

int passed = 0, failed = 0;
long all_up_to = LONG_MAX;  // allocations of a call; later ones ever rarer
bool good(bool condition, const Call &call, const char *memory, long n, long whole, const char *what) {
  ++(condition ? passed : failed);
  if (!condition)
    std::printf("%s, allocation %ld of %ld of the %s: %s (%s)\n", call.name, n, whole, memory, what,
                ts_last_error_message());
  return condition;
}

// `count()` allocations so far, `fail_at(n)`: the n-th from now on fails; 0: none.
template <class Count, class FailAt>
void each_allocation_fails(Scene &s, const Hook &hook, const Call &call, const char *memory, const Count &count,
                           const FailAt &fail_at) {
  // Once for what is set up at the first use of all; then what it takes when all goes well.
  long whole = 0;
  for (int k = 0; k < 2; ++k) {
    const long before = count();
    const ts_status got = call.run(s);
    whole = count() - before;
    const bool may_refuse = got == TS_E_NOT_CLOSED || got == TS_E_NO_TEETH;
    if (!good(got == TS_OK || may_refuse, call, memory, 0, whole, "fails with all memory there is")) return;
    if (got == TS_OK && call.back) call.back(s);
  }
  const std::string before = s.state();
  const long live = hook.live;
  for (long n = 1; n <= whole; n += 1 + n / all_up_to) {
    fail_at(n);
    const ts_status got = call.run(s);
    fail_at(0);
    if (got == TS_OK) {  // the library did without; nothing is lost by that
      ++passed;
      if (call.back) call.back(s);
      continue;
    }
    if (!good(got == TS_E_OUT_OF_MEMORY, call, memory, n, whole, ts_status_name(got))) return;
    if (!good(hook.live == live, call, memory, n, whole, "leaks")) return;
    if (!good(s.state() == before, call, memory, n, whole, "has changed something")) return;
  }
  const ts_status after = call.run(s);
  if (good(after == TS_OK || after == TS_E_NOT_CLOSED || after == TS_E_NO_TEETH, call, memory, whole, whole,
           "does not work afterwards") &&
      after == TS_OK && call.back)
    call.back(s);
  std::printf("%-30s %-8s %6ld\n", call.name, memory, whole);
}

}  // namespace

int main(int argc, char **argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 1024);
  if ((argc == 6 || argc == 7) && !std::strcmp(argv[2], "--triangles") && !std::strcmp(argv[4], "--sampled"))
    return sampled_faults(argv[1], static_cast<unsigned>(std::strtoul(argv[3], nullptr, 10)), std::atoi(argv[5]),
                          argc == 7 ? argv[6] : "");
  if (argc < 2 || argc > 3)
    return std::fprintf(stderr,
                        "usage: test_faults FOLDER [--quick | CALL] | FOLDER --triangles N --sampled COUNT "
                        "[CALL]\n"),
           2;
  static Hook hook;
  const std::vector<Call> all = calls(argv[1]);
  Scene s(hook);
  HOLDS(ts_segmentation_save(s.segmentation.get(), (std::string(argv[1]) + "/faults.ply").c_str(), TS_OUTPUT_PLY,
                             nullptr, nullptr) == TS_OK);
  HOLDS(ts_session_save(s.segmentation.get(), (std::string(argv[1]) + "/faults.json").c_str()) == TS_OK);
  const char *only = argc > 2 ? argv[2] : nullptr;
  if (only && !std::strcmp(only, "--quick")) {
    only = nullptr;
    all_up_to = heap::can_fail ? 200 : 8;  // where a sanitizer has the heap, all takes ten times as long
  }
  for (const Call &call : all) {
    if (only && std::strcmp(call.name, only) != 0) continue;
    each_allocation_fails(
        s, hook, call, "hook", [&] { return hook.taken; }, [&](long n) { hook.fails_at = n ? hook.taken + n : 0; });
    if (heap::can_fail) each_allocation_fails(s, hook, call, "C heap", heap::taken, heap::fail_at);
  }
  std::printf("%d passed, %d failed\n", passed, failed);
  return failed != 0;
}
