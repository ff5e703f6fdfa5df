// Meshes that are hard on the arithmetic: slivers, needles, faces without area, absurd units, places far away, points
// that are nearly the same, pieces in which nothing is held, weights over many orders of magnitude. What is expected of
// each is stated; whatever comes out has to be sound.
//   test_numbers [PART_OF_A_NAME]. SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include "arch.h"
#include "check.h"
#include "scene.h"

namespace {

using Index = std::uint32_t;

// How far a mesh is expected to come.
enum class Goes { to_teeth, to_sound_results };

struct Case {
  std::string name;
  Mesh mesh;
  ts_unit unit = TS_UNIT_MM;
  Goes goes = Goes::to_sound_results;
  double weld = 0;
  bool soup = false, floats = false;
  bool whole = false;  // the gingiva is closed and the session read as well, which takes as long as all else
};

struct Taken {
  Handle<ts_model> model;
  ts_status status = TS_OK;
  ts_intake_report report{};
};

Taken take_in(ts_context *context, const Case &c) {
  ts_mesh_input input;
  HOLDS(ts_mesh_input_init(&input, sizeof input) == TS_OK);
  std::vector<float> floats;
  if (c.floats) floats.assign(c.mesh.xyz.begin(), c.mesh.xyz.end());
  input.scalar = c.floats ? TS_FLOAT32 : TS_FLOAT64;
  input.positions = c.floats ? static_cast<const void *>(floats.data()) : c.mesh.xyz.data();
  input.vertex_count = static_cast<Index>(c.mesh.xyz.size() / 3);
  if (!c.soup) {
    input.triangles = c.mesh.triangles.data();
    input.triangle_count = static_cast<Index>(c.mesh.triangles.size() / 3);
  }
  ts_intake_options options;
  HOLDS(ts_intake_options_init(&options, sizeof options) == TS_OK);
  options.unit = c.unit;
  options.weld_tolerance = c.weld;
  Taken t;
  t.model = made<ts_model>([&](ts_model **out) { return ts_model_create(context, &input, &options, nullptr, out); },
                           &t.status);
  check::status(t.status, {4});
  HOLDS((t.model != nullptr) == (t.status == TS_OK));
  if (!t.model) return t;
  t.report.struct_size = sizeof t.report;
  HOLDS(ts_model_get_report(t.model.get(), &t.report) == TS_OK);
  check::model(t.model.get());
  // Each face is of the model or is told to be none.
  HOLDS(t.report.input_faces <= t.report.faces + t.report.degenerate_faces + t.report.duplicate_faces);
  return t;
}

// Where nothing looks like a tooth: by hand, a point each on a few vertices spread over the mesh.
Handle<ts_features> by_hand(const ts_model *model) {
  auto features = made<ts_features>([&](ts_features **out) { return ts_features_create(model, out); });
  HOLDS(features != nullptr);
  const double up[3] = {0, 0, 1};
  HOLDS(ts_features_set_occlusal(features.get(), up) == TS_OK);
  const auto xyz =
      check::all<double>([&](double *p, Index n, Index *k) { return ts_model_get_positions(model, p, n, k); }, 3);
  const std::size_t vertices = xyz.size() / 3;
  for (const double share : {0.1, 0.35, 0.6, 0.9})
    HOLDS(ts_features_add_point(features.get(), &xyz[3 * static_cast<std::size_t>(share * double(vertices - 1))],
                                TS_NONE, nullptr, nullptr) == TS_OK);
  return features;
}

Index teeth_of(const ts_segmentation *s) {
  Index count = 0;
  HOLDS(ts_get_teeth(s, nullptr, 0, &count) == TS_OK);
  return count;
}

// Everything that can be done with a segmentation; each call may refuse, for a reason of its kind.
void use(const ts_model *model, ts_segmentation *s, bool whole) {
  check::status(ts_segment_all(s, nullptr), {6});
  std::array<double, 3> at{};
  {
    const auto xyz =
        check::all<double>([&](double *p, Index n, Index *k) { return ts_model_get_positions(model, p, n, k); }, 3);
    std::copy_n(&xyz[3 * (xyz.size() / 6)], 3, at.begin());
  }
  check::status(ts_segment_click(s, at.data(), nullptr, nullptr), {6});
  const auto teeth = check::all<Index>([&](Index *p, Index n, Index *k) { return ts_get_teeth(s, p, n, k); });
  if (!teeth.empty()) {
    check::status(ts_cut_smooth(s, teeth[0], 0.5, nullptr), {6});
    check::status(ts_cut_offset(s, teeth[0], -0.3, nullptr), {6});
    check::status(ts_tooth_include(s, teeth[0], at.data(), nullptr), {6});
    if (teeth.size() > 1) check::status(ts_tooth_merge(s, teeth[0], teeth[1], nullptr), {6});
  }
  check::status(ts_assign_numbers(s, nullptr), {1, 7});
  check::segmentation(model, s, true, !whole);
  if (!whole) return;
  // It comes back from its own text.
  const auto text = check::all<char>([&](char *p, Index n, Index *k) { return ts_session_write(s, p, n, k); });
  ts_status got;
  const auto again = made<ts_segmentation>(
      [&](ts_segmentation **out) { return ts_session_read(model, text.data(), text.size(), nullptr, nullptr, out); },
      &got);
  HOLDS(got == TS_OK && teeth_of(again.get()) == teeth_of(s));
}

void walk(ts_context *context, const Case &c) {
  const Taken t = take_in(context, c);
  if (!t.model) {
    HOLDS(c.goes != Goes::to_teeth);
    std::printf("%-44s %s\n", c.name.c_str(), ts_status_name(t.status));
    return;
  }
  ts_status got;
  auto features = made<ts_features>(
      [&](ts_features **out) { return ts_detect_features(t.model.get(), nullptr, nullptr, out); }, &got);
  const bool found = got == TS_OK;
  HOLDS(found || got == TS_E_NO_TEETH);
  HOLDS(found || c.goes != Goes::to_teeth);
  if (!found) features = by_hand(t.model.get());
  check::features(t.model.get(), features.get());
  Index teeth = 0;
  struct Way {
    ts_preset preset;
    int weights;  // -1: the preset's
    double beta;  // 0: the preset's
  };
  // Both presets; cotangents without a bound; concavity over twelve orders of magnitude.
  static constexpr Way kWays[] = {{TS_PRESET_DEFAULT, -1, 0},
                                  {TS_PRESET_PAPER, -1, 0},
                                  {TS_PRESET_DEFAULT, TS_WEIGHTS_COTANGENT, 0},
                                  {TS_PRESET_DEFAULT, -1, 1e-12}};
  for (const Way &w : kWays) {
    ts_segment_options o;
    HOLDS(ts_segment_options_init(&o, sizeof o, w.preset) == TS_OK);
    if (w.weights >= 0) o.weights = static_cast<ts_weights>(w.weights);
    if (w.beta > 0) o.beta = w.beta;
    o.contours = 20;
    const auto s = made<ts_segmentation>(
        [&](ts_segmentation **out) { return ts_segmentation_create(features.get(), &o, nullptr, out); }, &got);
    HOLDS(got == TS_OK || got == TS_E_SOLVER);
    HOLDS(got == TS_OK || c.goes != Goes::to_teeth);
    if (!s) {
      std::printf("%-44s preset %d, weights %d: %s\n", c.name.c_str(), w.preset, w.weights, ts_last_error_message());
      continue;
    }
    if (&w == kWays) {
      use(t.model.get(), s.get(), c.whole);
      teeth = teeth_of(s.get());
    } else {  // what differs is the field
      const auto points = check::all<ts_feature_point>(
          [&](ts_feature_point *p, Index n, Index *k) { return ts_features_get_points(features.get(), p, n, k); });
      check::status(ts_segment_click(s.get(), points[points.size() / 2].position, nullptr, nullptr), {6});
      check::segmentation(t.model.get(), s.get(), true, true);
    }
  }
  std::printf("%-44s %6u faces, %5u components, %5u degenerate, %5u welded, features %s, %u teeth\n", c.name.c_str(),
              t.report.faces, t.report.components, t.report.degenerate_faces, t.report.welded_vertices,
              found ? "found" : "by hand", teeth);
  HOLDS(c.goes != Goes::to_teeth || teeth > 8);
}

// ---------------------------------------------------------------------------------------------------- the hard meshes

double *at(Mesh &m, Index v) {
  return &m.xyz[3 * std::size_t{v}];
}

// Every `step`-th face: one of its edges made `share` of its length, from either end's side.
Mesh with_short_edges(Mesh m, double share, std::size_t step) {
  std::vector<bool> moved(m.xyz.size() / 3);
  for (std::size_t t = 0; t + 2 < m.triangles.size(); t += 3 * step) {
    const Index a = m.triangles[t], b = m.triangles[t + 1];
    if (moved[a] || moved[b]) continue;
    moved[a] = moved[b] = true;
    for (int k = 0; k < 3; ++k) at(m, b)[k] = at(m, a)[k] + share * (at(m, b)[k] - at(m, a)[k]);
  }
  return m;
}

// Every `step`-th face is split at a point that is `height` of its own height away from an edge: a needle of aspect
// 1 / height.
Mesh with_needles(Mesh m, double height, std::size_t step) {
  const std::size_t end = m.triangles.size();
  for (std::size_t t = 0; t < end; t += 3 * step) {
    const Index a = m.triangles[t], b = m.triangles[t + 1], c = m.triangles[t + 2];
    const auto p = static_cast<Index>(m.xyz.size() / 3);
    for (int k = 0; k < 3; ++k)
      m.xyz.push_back((1 - height) * 0.5 * (at(m, a)[k] + at(m, b)[k]) + height * at(m, c)[k]);
    m.triangles[t + 2] = p;
    m.triangles.insert(m.triangles.end(), {b, c, p, c, a, p});
  }
  return m;
}

// Edges are split on one side only, and the gap is filled by a face without area; other faces name a corner twice.
Mesh with_flat_faces(Mesh m, std::size_t step) {
  const std::size_t end = m.triangles.size();
  for (std::size_t t = 0; t < end; t += 3 * step) {
    const Index a = m.triangles[t], b = m.triangles[t + 1], c = m.triangles[t + 2];
    const auto p = static_cast<Index>(m.xyz.size() / 3);
    for (int k = 0; k < 3; ++k) m.xyz.push_back(0.5 * (at(m, a)[k] + at(m, b)[k]));
    m.triangles[t + 1] = p;
    m.triangles.insert(m.triangles.end(), {p, b, c, a, b, p, a, a, c});
  }
  return m;
}

std::string with(const char *before, double value, const char *after) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return before + std::string(text) + after;
}

Mesh moved(Mesh m, double scale, double offset) {
  for (double &x : m.xyz) x = scale * x + offset;
  return m;
}

// Corners of its own for every face, each coordinate off by up to `jitter`.
Mesh soup_of(const Mesh &m, double jitter) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> off(-jitter, jitter);
  Mesh s;
  for (const Index v : m.triangles)
    for (int k = 0; k < 3; ++k)
      s.xyz.push_back(m.xyz[3 * std::size_t{v} + std::size_t(k)] + (jitter > 0 ? off(random) : 0));
  return s;
}

void slivers(ts_context *context, const Mesh &arch) {
  for (const double share : {1e-6, 1e-9, 1e-12, 0.0})
    walk(context,
         {with("edges of ", share, " of their length"), with_short_edges(arch, share, 5), TS_UNIT_MM, Goes::to_teeth});
  for (const double height : {1e-6, 1e-13}) {
    walk(context,
         {with("needles of aspect ", 1 / height, ""), with_needles(arch, height, 5), TS_UNIT_MM, Goes::to_teeth});
  }
  walk(context, {"faces without area", with_flat_faces(arch, 7), TS_UNIT_MM, Goes::to_teeth, 0, false, false, true});
}

void units(ts_context *context, const Mesh &arch) {
  const Bumps made_up = make_bumps(4, 8, 5);
  const Mesh bumps{made_up.xyz, made_up.triangles};
  const auto status_at = [&](double scale, ts_unit unit) {
    return take_in(context, {"", moved(arch, scale, 0), unit}).status;
  };
  // Undeclared: told by the size. Declared: taken at the caller's word, as far as coordinates may go.
  for (const double scale : {1e-6, 1e-3, 1e-2, 10.0, 1000.0, 1e6})
    HOLDS(status_at(scale, TS_UNIT_CHECKED_MM) == TS_E_MESH_UNITS);
  HOLDS(status_at(1e-2, TS_UNIT_CM) == TS_OK);
  for (const double scale : {1e9, 1e30, 1e150, 1e300}) HOLDS(status_at(scale, TS_UNIT_MM) == TS_E_MESH_TOO_LARGE);
  HOLDS(status_at(1e6, TS_UNIT_M) == TS_E_MESH_TOO_LARGE);
  HOLDS(status_at(std::numeric_limits<double>::infinity(), TS_UNIT_MM) == TS_E_MESH_NON_FINITE);
  walk(context, {"in m, declared", moved(arch, 1e-3, 0), TS_UNIT_M, Goes::to_teeth});
  walk(context, {"in inches, floats", moved(arch, 1 / 25.4, 0), TS_UNIT_INCH, Goes::to_teeth, 0, false, true});
  for (const double scale : {1e-300, 1e-200, 1e-155, 1e-100, 1e-30, 1e-6, 1e-3, 3.0, 1e3, 1e6}) {
    // Where a disc of seed_radius is larger than the mesh, everything is a constraint of every tooth: work that grows
    // with the square of the mesh.
    const Mesh &m = scale < 1 ? bumps : arch;
    const Case c{with("", scale, " times as large, said to be mm"), moved(m, scale, 0)};
    const Taken t = take_in(context, c), plain = take_in(context, {"", m});
    if (t.model && scale > 1e-100) {  // the report is truthful
      HOLDS(t.report.faces == plain.report.faces && t.report.components == plain.report.components);
      HOLDS(std::abs(t.report.diagonal / scale / plain.report.diagonal - 1) < 1e-9);
      HOLDS(std::abs(t.report.area / scale / scale / plain.report.area - 1) < 1e-9);
    }
    walk(context, c);
  }
}

void far_away(ts_context *context, const Mesh &arch) {
  walk(context, {"1e5 mm away", moved(arch, 1, 1e5), TS_UNIT_MM, Goes::to_teeth, 0, false, false, true});
  walk(context, {"1e5 mm away, floats", moved(arch, 1, 1e5), TS_UNIT_MM, Goes::to_teeth, 0, false, true});
  walk(context, {"1e8 mm away", moved(arch, 1, 1e8), TS_UNIT_MM, Goes::to_teeth});
  walk(context, {"1e8 mm away, floats", moved(arch, 1, 1e8), TS_UNIT_MM, Goes::to_sound_results, 0, false, true});
}

void duplicates(ts_context *context, const Mesh &arch, const Mesh &small) {
  const ts_intake_report plain = take_in(context, {"", arch}).report;
  walk(context, {"a soup", soup_of(arch, 0), TS_UNIT_MM, Goes::to_teeth, 0, true, false, true});
  for (const double jitter : {1e-9, 1e-3}) {
    // A corner is within jitter x sqrt(3) of where it was, two of them within twice that.
    const Case welded{with("a soup jittered by ", jitter, " mm, welded"),
                      soup_of(arch, jitter),
                      TS_UNIT_MM,
                      Goes::to_teeth,
                      4 * jitter,
                      true};
    const ts_intake_report r = take_in(context, welded).report;
    HOLDS(r.vertices == plain.vertices && r.faces == plain.faces && r.components == plain.components);
    walk(context, welded);
    // Each face is a piece of its own.
    const Mesh loose = soup_of(small, jitter);
    const Case apart{"the same, not welded", loose, TS_UNIT_MM, Goes::to_sound_results, 0, true};
    HOLDS(take_in(context, apart).report.components == loose.xyz.size() / 9);
    walk(context, apart);
  }
  // A tolerance that takes some of the points and not others.
  walk(context, {"a soup, welded in part", soup_of(arch, 1e-6), TS_UNIT_MM, Goes::to_sound_results, 1e-6, true});
}

// ------------------------------------------------------------------------------------------------------------- pieces

// A bump on a plate of 6 x 12 mm, `height` high.
void add_plate(Mesh &m, double x, double y, double z, double height) {
  const Bumps b = make_bumps(1, 12, height);
  const auto base = static_cast<Index>(m.xyz.size() / 3);
  for (std::size_t v = 0; v < b.xyz.size(); v += 3)
    m.xyz.insert(m.xyz.end(), {b.xyz[v] + x, b.xyz[v + 1] + y, b.xyz[v + 2] + z});
  for (const Index v : b.triangles) m.triangles.push_back(base + v);
}

// Of each vertex of the model the lowest vertex of its piece.
std::vector<Index> pieces_of(const ts_model *model, std::vector<Index> &triangles) {
  triangles = check::all<Index>([&](Index *p, Index n, Index *k) { return ts_model_get_triangles(model, p, n, k); }, 3);
  std::vector<Index> of(*std::max_element(triangles.begin(), triangles.end()) + std::size_t{1});
  for (Index v = 0; v < of.size(); ++v) of[v] = v;
  const auto root = [&](Index v) {
    while (of[v] != v) v = of[v] = of[of[v]];
    return v;
  };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Index a = root(triangles[t]), b = root(triangles[t / 3 * 3]);
    of[std::max(a, b)] = std::min(a, b);
  }
  for (Index v = 0; v < of.size(); ++v) of[v] = root(v);
  return of;
}

// Pieces without a feature point: their block of Eq. 3 is singular. NaN there, and a value everywhere else; no tooth,
// label 0; clicks and corrections on them are refused.
void nothing_held(ts_context *context, Mesh m) {
  double top = -1e9, low = 1e9;
  for (std::size_t v = 2; v < m.xyz.size(); v += 3) top = std::max(top, m.xyz[v]), low = std::min(low, m.xyz[v]);
  const auto arch_faces = m.triangles.size() / 3;
  for (int k = 0; k < 3; ++k) add_plate(m, 8.0 * k - 12, 0, low - 15, 5);
  const auto base = static_cast<Index>(m.xyz.size() / 3);
  for (Index k = 0; k < 40; ++k) {  // and single triangles
    for (int c = 0; c < 3; ++c) m.xyz.insert(m.xyz.end(), {0.5 * k + 0.3 * (c == 1), 20 + 0.3 * (c == 2), low - 10});
    m.triangles.insert(m.triangles.end(), {base + 3 * k, base + 3 * k + 1, base + 3 * k + 2});
  }
  const Taken t = take_in(context, {"", m});
  HOLDS(t.report.components == 44);
  ts_status got;
  auto features = made<ts_features>(
      [&](ts_features **out) { return ts_detect_features(t.model.get(), nullptr, nullptr, out); }, &got);
  HOLDS(got == TS_OK);
  std::vector<Index> triangles;
  const std::vector<Index> piece = pieces_of(t.model.get(), triangles);
  std::vector<bool> held(piece.size());
  for (const auto &p : check::all<ts_feature_point>(
           [&](ts_feature_point *q, Index n, Index *k) { return ts_features_get_points(features.get(), q, n, k); }))
    held[piece[p.vertex]] = true;
  HOLDS(std::count(held.begin(), held.end(), true) == 1);
  for (const ts_preset preset : {TS_PRESET_DEFAULT, TS_PRESET_PAPER}) {
    ts_segment_options o;
    HOLDS(ts_segment_options_init(&o, sizeof o, preset) == TS_OK);
    o.contours = 20;
    const auto s = made<ts_segmentation>(
        [&](ts_segmentation **out) { return ts_segmentation_create(features.get(), &o, nullptr, out); });
    HOLDS(s != nullptr && ts_segment_all(s.get(), nullptr) == TS_OK && teeth_of(s.get()) > 8);
    const auto before = check::all<Index>([&](Index *p, Index n, Index *k) { return ts_get_labels(s.get(), p, n, k); });
    const Index tooth =
        check::all<Index>([&](Index *p, Index n, Index *k) { return ts_get_teeth(s.get(), p, n, k); })[0];
    const double on_plate[3] = {-9, 0, low - 10}, on_triangle[3] = {0.05, 20.05, low - 10};
    for (const double *const p : {on_plate, on_triangle}) {
      HOLDS(ts_segment_click(s.get(), p, nullptr, nullptr) == TS_E_CLICK_ON_GINGIVA);
      HOLDS(ts_tooth_include(s.get(), tooth, p, nullptr) == TS_E_CLICK_ON_GINGIVA);
      HOLDS(ts_tooth_exclude(s.get(), tooth, p, nullptr) == TS_E_CLICK_ON_GINGIVA);
      const auto seeds =
          check::all<Index>([&](Index *q, Index n, Index *k) { return ts_get_tooth_seeds(s.get(), tooth, q, n, k); });
      const auto xyz = check::all<double>(
          [&](double *q, Index n, Index *k) { return ts_model_get_positions(t.model.get(), q, n, k); }, 3);
      const double *const seed = &xyz[3 * std::size_t{seeds[0]}];
      HOLDS(ts_tooth_split(s.get(), tooth, seed, p, nullptr, nullptr) == TS_E_CLICK_ON_GINGIVA);
    }
    use(t.model.get(), s.get(), preset == TS_PRESET_DEFAULT);
    const auto labels = check::all<Index>([&](Index *p, Index n, Index *k) { return ts_get_labels(s.get(), p, n, k); });
    for (std::size_t f = arch_faces; f < labels.size(); ++f) HOLDS(labels[f] == 0 && before[f] == 0);
    Index clicks = 0;
    HOLDS(ts_get_click_count(s.get(), &clicks) == TS_OK && clicks > 4);
    for (Index c = 0; c < clicks; ++c) {
      const auto u =
          check::all<double>([&](double *p, Index n, Index *k) { return ts_get_field(s.get(), c, p, n, k); });
      for (Index v = 0; v < u.size(); ++v) HOLDS(std::isnan(u[v]) == !held[piece[v]]);
    }
  }
  // Two more pieces, joined by no way, with a point of a group each, by hand; and one of them has its own two.
  Index group = TS_NONE;
  const double a[3] = {-9, 0, low - 10}, b[3] = {-1, 0, low - 10}, c[3] = {-1, 2.5, low - 12};
  HOLDS(ts_features_add_point(features.get(), a, TS_NONE, nullptr, &group) == TS_OK);
  HOLDS(ts_features_add_point(features.get(), b, TS_NONE, nullptr, &group) == TS_OK);
  HOLDS(ts_features_add_point(features.get(), c, group, nullptr, nullptr) == TS_OK);
  const auto s = made<ts_segmentation>(
      [&](ts_segmentation **out) { return ts_segmentation_create(features.get(), nullptr, nullptr, out); });
  HOLDS(s != nullptr);
  use(t.model.get(), s.get(), false);
}

// Target and background in separate pieces: each tooth a piece of its own.
void apart(ts_context *context) {
  Mesh m;
  for (int k = 0; k < 4; ++k) add_plate(m, 8.0 * k, 0, 0, 5);
  const Taken t = take_in(context, {"", m, TS_UNIT_MM});
  HOLDS(t.report.components == 4);
  std::vector<Index> triangles;
  const std::vector<Index> piece = pieces_of(t.model.get(), triangles);
  const auto features = made<ts_features>([&](ts_features **out) { return ts_features_create(t.model.get(), out); });
  const double up[3] = {0, 0, 1};
  HOLDS(ts_features_set_occlusal(features.get(), up) == TS_OK);
  for (int k = 0; k < 3; ++k) {  // the fourth holds nothing
    const double top[3] = {8.0 * k + 3, 0, 5};
    HOLDS(ts_features_add_point(features.get(), top, TS_NONE, nullptr, nullptr) == TS_OK);
  }
  int cut = 0, refused = 0;
  for (const ts_preset preset : {TS_PRESET_DEFAULT, TS_PRESET_PAPER})
    for (int background = TS_BACKGROUND_NEIGHBOUR; background <= TS_BACKGROUND_ALL; ++background)
      for (int rule = TS_CUT_GRADIENT; rule <= TS_CUT_HALF; ++rule)
        for (const double alpha : {1e8, 0.0}) {
          ts_segment_options o;
          HOLDS(ts_segment_options_init(&o, sizeof o, preset) == TS_OK);
          o.background = static_cast<ts_background>(background);
          o.cut_rule = static_cast<ts_cut_rule>(rule);
          o.alpha = alpha, o.gingiva_distance = 4, o.contours = 20;
          const auto s = made<ts_segmentation>(
              [&](ts_segmentation **out) { return ts_segmentation_create(features.get(), &o, nullptr, out); });
          HOLDS(s != nullptr);
          for (int k = 0; k < 4; ++k) {
            const double at[3] = {8.0 * k + 3.4, 0.3, 5};
            const ts_status got = ts_segment_click(s.get(), at, nullptr, nullptr);
            HOLDS(got == TS_OK || got == TS_E_NO_CUT || got == TS_E_CLICK_ON_GINGIVA);
            HOLDS(k < 3 || got == TS_E_CLICK_ON_GINGIVA);
            ++(got == TS_OK ? cut : refused);
          }
          check::segmentation(t.model.get(), s.get(), true);
          // A tooth is of one piece, its own.
          for (const Index id :
               check::all<Index>([&](Index *p, Index n, Index *q) { return ts_get_teeth(s.get(), p, n, q); })) {
            const auto seeds = check::all<Index>(
                [&](Index *p, Index n, Index *q) { return ts_get_tooth_seeds(s.get(), id, p, n, q); });
            for (const Index v : check::all<Index>(
                     [&](Index *p, Index n, Index *q) { return ts_get_tooth_vertices(s.get(), id, p, n, q); }))
              HOLDS(piece[v] == piece[seeds[0]]);
          }
        }
  std::printf("%-44s %d teeth cut, %d refused\n", "each tooth a piece of its own", cut, refused);
  HOLDS(cut > 0);
}

}  // namespace

int main(int argc, char **argv) {
  if (argc > 2) return std::fprintf(stderr, "usage: test_numbers [PART_OF_A_NAME]\n"), 2;
  std::setvbuf(stdout, nullptr, _IOLBF, 1024);
  const auto context = one_thread();
  const Mesh arch = arch_mesh(5200, 1), small = arch_mesh(5000, 2);
  const std::string only = argc > 1 ? argv[1] : "";
  const auto part = [&](const char *name, const auto &run) {
    if (std::string(name).find(only) == std::string::npos) return;
    run();
    std::printf("-- %s: passed\n", name);
  };
  part("slivers", [&] { slivers(context.get(), arch); });
  part("units", [&] { units(context.get(), arch); });
  part("far away", [&] { far_away(context.get(), arch); });
  part("duplicates", [&] { duplicates(context.get(), arch, small); });
  part("nothing held", [&] { nothing_held(context.get(), arch); });
  part("apart", [&] { apart(context.get()); });
}
