// SPDX-License-Identifier: Apache-2.0
#include "long_calls.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>

#include "check.h"

namespace {

using Index = std::uint32_t;

template <class T>
void add(std::string &to, const std::vector<T> &items) {
  to.append(reinterpret_cast<const char *>(items.data()), items.size() * sizeof(T));
}

std::vector<char> text_of(const ts_segmentation *s) {
  return check::all<char>([&](char *p, Index n, Index *c) { return ts_session_write(s, p, n, c); });
}

void add_features(std::string &to, const ts_features *f) {
  add(to, check::all<ts_feature_point>(
              [&](ts_feature_point *p, Index n, Index *c) { return ts_features_get_points(f, p, n, c); }));
  add(to, check::all<ts_feature_group>(
              [&](ts_feature_group *p, Index n, Index *c) { return ts_features_get_groups(f, p, n, c); }));
  add(to, check::all<double>([&](double *p, Index n, Index *c) { return ts_features_get_arch(f, p, n, c); }, 3));
}

void add_segmentation(std::string &to, const ts_segmentation *s) {
  add(to, text_of(s));
  add(to, check::all<Index>([&](Index *p, Index n, Index *c) { return ts_get_labels(s, p, n, c); }));
  add(to, check::all<Index>([&](Index *p, Index n, Index *c) { return ts_get_changes(s, p, n, c); }));
  ts_history_info history;
  history.struct_size = sizeof history;
  HOLDS(ts_get_history(s, &history) == TS_OK);
  to += std::to_string(history.undo) + " " + std::to_string(history.redo) + " " + std::to_string(history.complete);
}

void add_bytes(std::string &to, const ts_model *m) {
  add(to, check::all<double>([&](double *p, Index n, Index *c) { return ts_model_get_positions(m, p, n, c); }, 3));
  add(to, check::all<Index>([&](Index *p, Index n, Index *c) { return ts_model_get_triangles(m, p, n, c); }, 3));
  add(to, check::all<Index>([&](Index *p, Index n, Index *c) { return ts_model_get_vertex_map(m, p, n, c); }));
}
void add_bytes(std::string &to, const ts_features *f) {
  add_features(to, f);
}
void add_bytes(std::string &to, const ts_segmentation *s) {
  add_segmentation(to, s);
}
void add_bytes(std::string &to, const ts_mesh *m) {
  add(to, check::all<double>([&](double *p, Index n, Index *c) { return ts_mesh_get_positions(m, p, n, c); }, 3));
  add(to, check::all<Index>([&](Index *p, Index n, Index *c) { return ts_mesh_get_triangles(m, p, n, c); }, 3));
}

// Calls that make something, which goes again at once.
template <class T, class Make>
LongCall maker(const char *function, const char *how, Make make) {
  LongCall c{function, how, {}};
  c.run = [make](Stage &s, ts_job *job, std::string *result) {
    T *const untouched = reinterpret_cast<T *>(1);
    T *out = untouched;
    const ts_status got = make(s, job, &out);
    if (got != TS_OK) {
      HOLDS(out == untouched);
      return got;
    }
    const Handle<T> owner(out);
    if (result) add_bytes(*result, out);
    return got;
  };
  return c;
}

template <class Run>
LongCall step(const char *function, Run run) {
  LongCall c{function, "", {}};
  c.run = [run](Stage &s, ts_job *job, std::string *result) {
    const ts_status got = run(s, s.segmentation.get(), job);
    if (got == TS_OK && result) *result = s.state();
    return got;
  };
  c.is_step = true;
  return c;
}

template <class Run>
LongCall writer(const char *function, const char *how, const char *file, Run run) {
  LongCall c{function, how, {}};
  c.file = file;
  c.run = [run, file](Stage &s, ts_job *job, std::string *result) {
    const ts_status got = run(s, s.path(file), job);
    if (got == TS_OK && result) *result = bytes_of_file(s.path(file));
    return got;
  };
  return c;
}

ts_mesh_input input_of(const Mesh &mesh) {
  ts_mesh_input input;
  HOLDS(ts_mesh_input_init(&input, sizeof input) == TS_OK);
  input.scalar = TS_FLOAT64;
  input.positions = mesh.xyz.data(), input.vertex_count = static_cast<Index>(mesh.xyz.size() / 3);
  input.triangle_count = static_cast<Index>(mesh.triangles.size() / 3);
  if (!mesh.triangles.empty()) input.triangles = mesh.triangles.data();
  return input;
}

ts_status create(Stage &s, const Mesh &mesh, double weld, ts_job *job, ts_model **out) {
  const ts_mesh_input input = input_of(mesh);
  ts_intake_options options;
  HOLDS(ts_intake_options_init(&options, sizeof options) == TS_OK);
  options.weld_tolerance = weld;
  return ts_model_create(s.context.get(), &input, &options, job, out);
}

ts_tooth_mesh_options closed() {
  ts_tooth_mesh_options o;
  HOLDS(ts_tooth_mesh_options_init(&o, sizeof o) == TS_OK);
  o.closed = 1;
  return o;
}

std::string off_of(const Mesh &m) {
  std::string text = "OFF\n" + std::to_string(m.xyz.size() / 3) + " " + std::to_string(m.triangles.size() / 3) + " 0\n";
  char line[96];
  for (std::size_t v = 0; v < m.xyz.size(); v += 3)
    text.append(line, std::snprintf(line, sizeof line, "%.6f %.6f %.6f\n", m.xyz[v], m.xyz[v + 1], m.xyz[v + 2]));
  for (std::size_t t = 0; t < m.triangles.size(); t += 3)
    text.append(
        line, std::snprintf(line, sizeof line, "3 %u %u %u\n", m.triangles[t], m.triangles[t + 1], m.triangles[t + 2]));
  return text;
}

}  // namespace

std::string bytes_of_file(const std::string &path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

Stage::Stage(Handle<ts_context> c, Mesh m, std::string f)
    : context(std::move(c)), mesh(std::move(m)), folder(std::move(f)) {
  for (const Index v : mesh.triangles)
    soup.xyz.insert(soup.xyz.end(), mesh.xyz.begin() + 3 * std::ptrdiff_t{v},
                    mesh.xyz.begin() + 3 * std::ptrdiff_t{v} + 3);
  ts_model *made_model = nullptr;
  HOLDS(create(*this, mesh, 0, nullptr, &made_model) == TS_OK);
  model.reset(made_model);
  features =
      made<ts_features>([&](ts_features **out) { return ts_detect_features(model.get(), nullptr, nullptr, out); });
  HOLDS(features != nullptr);
  segmentation = made<ts_segmentation>(
      [&](ts_segmentation **out) { return ts_segmentation_create(features.get(), nullptr, nullptr, out); });
  HOLDS(segmentation != nullptr);
  ts_segmentation *const s = segmentation.get();
  const auto proposed = [&] {
    return check::all<double>([&](double *p, Index n, Index *k) { return ts_propose_clicks(s, p, n, k); }, 3);
  };
  clicks = proposed();
  HOLDS(clicks.size() > 6);
  HOLDS(ts_segment_click(s, &clicks[3], nullptr, nullptr) == TS_OK);
  HOLDS(ts_assign_numbers(s, nullptr) == TS_OK);
  clicks = proposed();
  HOLDS(clicks.size() > 6);
  teeth = check::all<Index>([&](Index *p, Index n, Index *k) { return ts_get_teeth(s, p, n, k); });
  HOLDS(teeth.size() == 2);
  find_places();
  HOLDS(ts_cut_smooth(s, teeth[1], 0.3, nullptr) == TS_OK);  // an edit that is made again
  const auto text = text_of(s);
  session.assign(text.begin(), text.end());
  std::ofstream(path("session.json"), std::ios::binary) << session;
  tooth = made<ts_mesh>([&](ts_mesh **out) { return ts_tooth_mesh_create(s, teeth[0], nullptr, nullptr, out); });
  HOLDS(tooth != nullptr);
  const auto saved = [&](const char *name, ts_output_format format) {
    HOLDS(ts_segmentation_save(s, path(name).c_str(), format, nullptr, nullptr) == TS_OK);
    return bytes_of_file(path(name));
  };
  ply = saved("scan.ply", TS_OUTPUT_PLY), stl = saved("scan.stl", TS_OUTPUT_STL),
  obj = saved("scan.obj", TS_OUTPUT_OBJ);
  off = off_of(mesh);
}

// The first places, in a fixed order, at which each correction is possible.
void Stage::find_places() {
  ts_segmentation *const s = segmentation.get();
  const Index t = teeth[0];
  const auto cut = check::all<ts_edge_point>(
      [&](ts_edge_point *p, Index n, Index *k) { return ts_get_cut(s, t, 0, nullptr, p, n, k); });
  const auto vertices =
      check::all<Index>([&](Index *p, Index n, Index *k) { return ts_get_tooth_vertices(s, t, p, n, k); });
  const auto xyz =
      check::all<double>([&](double *p, Index n, Index *k) { return ts_model_get_positions(model.get(), p, n, k); }, 3);
  std::vector<Place> rim, crown;
  Place centre{};
  for (std::size_t i = 0; i < 24; ++i) {
    const double *const p = cut[i * cut.size() / 24].position;
    rim.push_back({p[0], p[1], p[2]});
    const double *const q = &xyz[3 * std::size_t{vertices[i * vertices.size() / 24]}];
    crown.push_back({q[0], q[1], q[2]});
    for (std::size_t k = 0; k < 3; ++k) centre[k] += p[k] / 24;
  }
  const auto outwards = [&](const Place &p, double mm) {
    double length = 0;
    for (std::size_t k = 0; k < 3; ++k) length += (p[k] - centre[k]) * (p[k] - centre[k]);
    Place q = p;
    for (std::size_t k = 0; k < 3; ++k) q[k] += mm * (p[k] - centre[k]) / std::sqrt(length);
    ts_surface_point at;
    HOLDS(ts_model_nearest(model.get(), q.data(), &at) == TS_OK);
    return Place{at.position[0], at.position[1], at.position[2]};
  };
  const auto first = [&](const char *what, const std::vector<Place> &among, const auto &attempt) {
    for (const Place &p : among)
      if (attempt(p) == TS_OK) {
        HOLDS(ts_undo(s) == TS_OK);
        return;
      }
    std::fprintf(stderr, "no place for %s: %s\n", what, ts_last_error_message());
    HOLDS(false);
  };
  Place point{};
  for (const auto &p : check::all<ts_feature_point>(
           [&](ts_feature_point *q, Index n, Index *k) { return ts_features_get_points(features.get(), q, n, k); }))
    if (p.group == t) std::copy_n(p.position, 3, point.begin());
  first("inclusion", rim,
        [&](const Place &p) { return ts_tooth_include(s, t, (inside = outwards(p, 0.3)).data(), nullptr); });
  first("exclusion", rim,
        [&](const Place &p) { return ts_tooth_exclude(s, t, (excluded = outwards(p, -0.3)).data(), nullptr); });
  keep = from = point;
  first("a split", crown,
        [&](const Place &p) { return ts_tooth_split(s, t, keep.data(), (part = p).data(), nullptr, nullptr); });
  first("a moved point", crown,
        [&](const Place &p) { return ts_tooth_move_point(s, t, from.data(), (to = p).data(), nullptr); });
  first("a drag", rim, [&](const Place &p) {
    for (dragged_point = 0; !std::equal(p.begin(), p.end(), cut[dragged_point].position);) ++dragged_point;
    return ts_cut_drag(s, t, 0, dragged_point, (dragged = outwards(p, -0.4)).data(), 0, nullptr);
  });
  first("a stroke", rim, [&](const Place &p) {
    std::size_t k = 0;
    while (!std::equal(p.begin(), p.end(), cut[k].position)) ++k;
    for (std::size_t i = 0; i < 3; ++i) {
      const double *const q = cut[(k + i * cut.size() / 16) % cut.size()].position;
      stroke[i] = {q[0], q[1], q[2]};
    }
    stroke[1] = outwards(stroke[1], -0.3);
    return ts_cut_draw(s, t, stroke[0].data(), 3, nullptr);
  });
}

std::string Stage::state() const {
  std::string all;
  add_segmentation(all, segmentation.get());
  add_features(all, features.get());
  return all;
}

std::vector<LongCall> long_calls() {
  std::vector<LongCall> c;
  const auto model = [&](const char *function, const char *how, auto make) {
    c.push_back(maker<ts_model>(function, how, make));
  };
  model("ts_model_create", "", [](Stage &s, ts_job *j, ts_model **out) { return create(s, s.mesh, 0, j, out); });
  model("ts_model_create", "soup", [](Stage &s, ts_job *j, ts_model **out) { return create(s, s.soup, 0, j, out); });
  model("ts_model_create", "soup, tolerance",
        [](Stage &s, ts_job *j, ts_model **out) { return create(s, s.soup, 1e-4, j, out); });
  model("ts_model_load", "", [](Stage &s, ts_job *j, ts_model **out) {
    return ts_model_load(s.context.get(), s.path("scan.ply").c_str(), nullptr, j, out);
  });
  const auto read = [&](const char *how, std::string Stage::*bytes) {
    model("ts_model_read", how, [bytes](Stage &s, ts_job *j, ts_model **out) {
      return ts_model_read(s.context.get(), (s.*bytes).data(), (s.*bytes).size(), TS_FORMAT_AUTO, nullptr, j, out);
    });
  };
  read("PLY", &Stage::ply), read("STL", &Stage::stl), read("OBJ", &Stage::obj), read("OFF", &Stage::off);
  c.push_back(maker<ts_features>("ts_detect_features", "", [](Stage &s, ts_job *j, ts_features **out) {
    return ts_detect_features(s.model.get(), nullptr, j, out);
  }));
  const auto prepare = [&](const char *how, ts_preset preset) {
    c.push_back(
        maker<ts_segmentation>("ts_segmentation_create", how, [preset](Stage &s, ts_job *j, ts_segmentation **out) {
          ts_segment_options o;
          HOLDS(ts_segment_options_init(&o, sizeof o, preset) == TS_OK);
          return ts_segmentation_create(s.features.get(), &o, j, out);
        }));
  };
  prepare("", TS_PRESET_DEFAULT), prepare("paper", TS_PRESET_PAPER);
  const auto session = [&](const char *function, auto get) {
    c.push_back(maker<ts_segmentation>(function, "", [get](Stage &s, ts_job *j, ts_segmentation **out) {
      ts_features *const untouched = reinterpret_cast<ts_features *>(1);
      ts_features *f = untouched;
      const ts_status got = get(s, j, &f, out);
      if (got != TS_OK)
        HOLDS(f == untouched);
      else
        ts_features_destroy(f);
      return got;
    }));
  };
  session("ts_session_read", [](Stage &s, ts_job *j, ts_features **f, ts_segmentation **out) {
    return ts_session_read(s.model.get(), s.session.data(), s.session.size(), j, f, out);
  });
  session("ts_session_load", [](Stage &s, ts_job *j, ts_features **f, ts_segmentation **out) {
    return ts_session_load(s.model.get(), s.path("session.json").c_str(), j, f, out);
  });

  c.push_back(step("ts_segment_click", [](Stage &s, ts_segmentation *h, ts_job *j) {
    Index click = TS_NONE;
    const ts_status got = ts_segment_click(h, s.clicks.data(), j, &click);
    HOLDS((got == TS_OK) == (click != TS_NONE));
    return got;
  }));
  c.push_back(step("ts_segment_clicks", [](Stage &s, ts_segmentation *h, ts_job *j) {
    std::vector<ts_status> each(s.clicks.size() / 3, TS_E_INTERNAL);
    const ts_status got = ts_segment_clicks(h, s.clicks.data(), static_cast<Index>(each.size()), j, each.data());
    for (const ts_status e : each) HOLDS((got == TS_OK) == (e != TS_E_INTERNAL));
    return std::find(each.begin(), each.end(), TS_E_OUT_OF_MEMORY) != each.end() ? TS_E_OUT_OF_MEMORY : got;
  }));
  c.push_back(step("ts_segment_all", [](Stage &, ts_segmentation *h, ts_job *j) { return ts_segment_all(h, j); }));
  c.push_back(step("ts_tooth_include", [](Stage &s, ts_segmentation *h, ts_job *j) {
    return ts_tooth_include(h, s.teeth[0], s.inside.data(), j);
  }));
  c.push_back(step("ts_tooth_exclude", [](Stage &s, ts_segmentation *h, ts_job *j) {
    return ts_tooth_exclude(h, s.teeth[0], s.excluded.data(), j);
  }));
  c.push_back(step("ts_tooth_split", [](Stage &s, ts_segmentation *h, ts_job *j) {
    Index second = 77;
    const ts_status got = ts_tooth_split(h, s.teeth[0], s.keep.data(), s.part.data(), j, &second);
    HOLDS((got == TS_OK) == (second != 77));
    return got;
  }));
  c.push_back(step("ts_tooth_move_point", [](Stage &s, ts_segmentation *h, ts_job *j) {
    return ts_tooth_move_point(h, s.teeth[0], s.from.data(), s.to.data(), j);
  }));
  c.push_back(step("ts_tooth_merge", [](Stage &s, ts_segmentation *h, ts_job *j) {
    return ts_tooth_merge(h, s.teeth[0], s.teeth[1], j);
  }));
  c.push_back(step("ts_cut_drag", [](Stage &s, ts_segmentation *h, ts_job *j) {
    return ts_cut_drag(h, s.teeth[0], 0, s.dragged_point, s.dragged.data(), 0, j);
  }));
  c.push_back(step("ts_cut_draw", [](Stage &s, ts_segmentation *h, ts_job *j) {
    return ts_cut_draw(h, s.teeth[0], s.stroke[0].data(), 3, j);
  }));
  c.push_back(step("ts_cut_offset",
                   [](Stage &s, ts_segmentation *h, ts_job *j) { return ts_cut_offset(h, s.teeth[0], -0.3, j); }));
  c.push_back(step("ts_cut_smooth",
                   [](Stage &s, ts_segmentation *h, ts_job *j) { return ts_cut_smooth(h, s.teeth[0], 0.5, j); }));

  const auto part = [&](const char *function, const char *how, auto make) {
    c.push_back(maker<ts_mesh>(function, how, make));
  };
  part("ts_tooth_mesh_create", "", [](Stage &s, ts_job *j, ts_mesh **out) {
    return ts_tooth_mesh_create(s.segmentation.get(), s.teeth[0], nullptr, j, out);
  });
  part("ts_tooth_mesh_create", "closed", [](Stage &s, ts_job *j, ts_mesh **out) {
    const auto o = closed();
    return ts_tooth_mesh_create(s.segmentation.get(), s.teeth[0], &o, j, out);
  });
  part("ts_gingiva_mesh_create", "", [](Stage &s, ts_job *j, ts_mesh **out) {
    return ts_gingiva_mesh_create(s.segmentation.get(), nullptr, j, out);
  });
  part("ts_gingiva_mesh_create", "closed", [](Stage &s, ts_job *j, ts_mesh **out) {
    const auto o = closed();
    return ts_gingiva_mesh_create(s.segmentation.get(), &o, j, out);
  });
  const auto save = [&](const char *how, ts_output_format format, Index whole) {
    c.push_back(writer("ts_segmentation_save", how, "written.scan", [=](Stage &s, const std::string &path, ts_job *j) {
      ts_save_options o;
      HOLDS(ts_save_options_init(&o, sizeof o) == TS_OK);
      o.whole_faces = whole;
      return ts_segmentation_save(s.segmentation.get(), path.c_str(), format, &o, j);
    }));
  };
  save("STL", TS_OUTPUT_STL, 0), save("PLY", TS_OUTPUT_PLY, 1), save("OBJ", TS_OUTPUT_OBJ, 0),
      save("GLB", TS_OUTPUT_GLB, 0);
  c.push_back(writer("ts_mesh_save", "GLB", "written.tooth", [](Stage &s, const std::string &path, ts_job *j) {
    return ts_mesh_save(s.tooth.get(), path.c_str(), TS_OUTPUT_GLB, j);
  }));
  return c;
}

std::vector<std::string> functions_with_a_job(const std::string &description) {
  const std::string text = bytes_of_file(description);
  const std::size_t begin = text.find("\n \"functions\"");
  HOLDS(begin != std::string::npos);
  std::vector<std::string> names;
  const std::string function = "\n   \"name\": \"", job = "\"spelling\": \"ts_job *\"";
  for (std::size_t at = text.find(function, begin); at != std::string::npos;) {
    const std::size_t next = text.find(function, at + 1), from = at + function.size();
    const std::string name = text.substr(from, text.find('"', from) - from);
    if (text.substr(at, next - at).find(job) != std::string::npos && name.rfind("ts_job_", 0) != 0)
      names.push_back(name);
    at = next;
  }
  HOLDS(!names.empty());
  return names;
}
