// SPDX-License-Identifier: Apache-2.0
#include "check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <set>

namespace check {
namespace {

using Index = std::uint32_t;

bool finite(const double *values, std::size_t n) {
  return std::all_of(values, values + n, [](double x) { return std::isfinite(x); });
}

template <class T>
T sized() {
  T t;
  std::memset(&t, 0, sizeof t);
  t.struct_size = sizeof t;
  return t;
}

using Edge = std::pair<Index, Index>;
Edge edge(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

// Faces on either side of each edge.
std::map<Edge, std::vector<Index>> edges_of(const std::vector<Index> &triangles) {
  std::map<Edge, std::vector<Index>> edges;
  for (Index f = 0; f < triangles.size() / 3; ++f)
    for (int k = 0; k < 3; ++k) edges[edge(triangles[3 * f + k], triangles[3 * f + (k + 1) % 3])].push_back(f);
  return edges;
}

// The edges of a model, kept from one call to the next: a session is looked at many times.
struct Surface {
  std::vector<double> xyz;
  std::vector<Index> triangles;
  std::map<Edge, std::vector<Index>> edges;
};
Surface surface_of(const ts_model *m) {
  Surface s;
  s.xyz = all<double>([&](double *p, Index n, Index *c) { return ts_model_get_positions(m, p, n, c); }, 3);
  s.triangles = all<Index>([&](Index *p, Index n, Index *c) { return ts_model_get_triangles(m, p, n, c); }, 3);
  s.edges = edges_of(s.triangles);
  return s;
}

// On edges of the mesh, and each point in a triangle with the next.
void polyline(const Surface &s, const std::vector<ts_edge_point> &points, bool closed) {
  HOLDS(points.size() >= 2);
  std::vector<const std::vector<Index> *> faces;
  for (const ts_edge_point &p : points) {
    HOLDS(3 * std::size_t{p.a} < s.xyz.size() && 3 * std::size_t{p.b} < s.xyz.size());
    HOLDS(p.t >= 0 && p.t <= 1);
    const auto at = s.edges.find(edge(p.a, p.b));
    HOLDS(at != s.edges.end());
    faces.push_back(&at->second);
    for (int k = 0; k < 3; ++k) {
      const double a = s.xyz[3 * p.a + k], b = s.xyz[3 * p.b + k];
      HOLDS(std::abs((1 - p.t) * a + p.t * b - p.position[k]) <= 1e-9 * (1 + std::abs(a) + std::abs(b)));
    }
  }
  const std::size_t n = points.size();
  for (std::size_t i = 0; i + 1 < n + (closed ? 1 : 0); ++i) {
    const auto &here = *faces[i], &next = *faces[(i + 1) % n];
    HOLDS(std::any_of(here.begin(), here.end(),
                      [&](Index f) { return std::find(next.begin(), next.end(), f) != next.end(); }));
  }
}

void tooth(const ts_model *m, const Surface &s, const ts_segmentation *seg, Index id,
           std::vector<std::uint32_t> &labels_seen) {
  auto info = sized<ts_tooth_info>();
  HOLDS(ts_get_tooth(seg, id, &info) == TS_OK);
  HOLDS(info.id == id && info.label > 0);
  HOLDS(std::isfinite(info.area) && info.area >= 0 && info.confidence >= 0 && info.confidence <= 1);
  HOLDS(std::isfinite(info.iso) && info.iso >= 0 && info.iso <= 1 && std::isfinite(info.gradient));
  labels_seen.push_back(info.label);
  const auto faces = all<Index>([&](Index *p, Index n, Index *c) { return ts_get_tooth_faces(seg, id, p, n, c); });
  HOLDS(faces.size() == info.faces && !faces.empty());
  for (std::size_t i = 0; i < faces.size(); ++i)
    HOLDS(3 * std::size_t{faces[i]} < s.triangles.size() && (i == 0 || faces[i - 1] < faces[i]));
  const auto vertices =
      all<Index>([&](Index *p, Index n, Index *c) { return ts_get_tooth_vertices(seg, id, p, n, c); });
  std::set<Index> corners;
  for (const Index f : faces) corners.insert(s.triangles.begin() + 3 * f, s.triangles.begin() + 3 * f + 3);
  HOLDS(vertices.size() == info.vertices &&
        std::equal(vertices.begin(), vertices.end(), corners.begin(), corners.end()));
  for (const Index v : all<Index>([&](Index *p, Index n, Index *c) { return ts_get_tooth_seeds(seg, id, p, n, c); }))
    HOLDS(3 * std::size_t{v} < s.xyz.size());
  std::set<std::pair<Edge, double>> taken;
  for (Index loop = 0; loop < info.loops; ++loop) {
    auto cut = sized<ts_cut_info>();
    const auto points = all<ts_edge_point>(
        [&](ts_edge_point *p, Index n, Index *c) { return ts_get_cut(seg, id, loop, &cut, p, n, c); });
    HOLDS(points.size() == cut.points && std::isfinite(cut.length) && cut.length >= 0);
    HOLDS(std::isfinite(cut.gradient) && cut.concavity >= 0 && cut.concavity <= 1 + 1e-9);
    polyline(s, points, cut.closed == 1);
    // Simple: no point of a cut is there twice.
    for (const ts_edge_point &p : points) HOLDS(taken.insert({edge(p.a, p.b), p.a < p.b ? p.t : 1 - p.t}).second);
  }
  auto frame = sized<ts_tooth_frame>();
  if (ts_get_tooth_frame(seg, id, &frame) == TS_OK) HOLDS(finite(frame.centre, 15));
  for (const auto &e :
       all<ts_cut_edit>([&](ts_cut_edit *p, Index n, Index *c) { return ts_get_cut_edits(seg, id, p, n, c); }))
    HOLDS(std::isfinite(e.amount) && finite(e.from, 6));
  static_cast<void>(m);
}

// A piece of the mesh holds a constraint, and has values everywhere, or does not, and has none.
void whole_pieces(const Surface &s, const std::vector<double> &u) {
  for (std::size_t t = 0; t < s.triangles.size(); t += 3)
    for (std::size_t k = 1; k < 3; ++k) HOLDS(std::isnan(u[s.triangles[t]]) == std::isnan(u[s.triangles[t + k]]));
}

void click(const Surface &s, const ts_segmentation *seg, Index number) {
  auto info = sized<ts_click_info>();
  HOLDS(ts_get_click(seg, number, &info) == TS_OK);
  HOLDS(finite(info.position, 3) && info.target_distance >= 0);
  HOLDS(info.neighbour == TS_NONE || info.neighbour_distance >= 0);
  HOLDS(info.v_med >= 0 && info.v_med <= 1 && info.target_iso >= 0 && info.target_iso <= 1);
  HOLDS(info.neighbour == TS_NONE || std::isnan(info.neighbour_iso) ||
        (info.neighbour_iso >= 0 && info.neighbour_iso <= 1));
  const auto u = all<double>([&](double *p, Index n, Index *c) { return ts_get_field(seg, number, p, n, c); });
  // The maximum principle: all weights are positive. The penalty lets a little through.
  for (const double x : u) HOLDS(std::isnan(x) || (x >= -1e-6 && x <= 1 + 1e-6));
  HOLDS(3 * u.size() == s.xyz.size());
  whole_pieces(s, u);
  const auto bins = all<Index>([&](Index *p, Index n, Index *c) { return ts_get_histogram(seg, number, p, n, c); });
  std::size_t counted = 0;
  for (const Index b : bins) counted += b;
  HOLDS(counted ==
        static_cast<std::size_t>(std::count_if(u.begin(), u.end(), [](double x) { return !std::isnan(x); })));
  Index contour = 0;
  for (const auto &c : all<ts_contour_info>(
           [&](ts_contour_info *p, Index n, Index *k) { return ts_get_contours(seg, number, p, n, k); })) {
    HOLDS(c.iso > 0 && c.iso < 1 && std::isfinite(c.gradient) && std::isfinite(c.concavity) && std::isfinite(c.length));
    HOLDS(c.gradient >= 0 && c.concavity >= 0 && c.concavity <= 1 + 1e-9 && c.length >= 0);
    const auto points = all<ts_edge_point>([&](ts_edge_point *p, Index n, Index *k) {
      return ts_get_contour_points(seg, number, contour, p, n, k, nullptr, nullptr);
    });
    HOLDS(points.size() == c.points);
    for (const ts_edge_point &p : points) HOLDS(p.t >= 0 && p.t <= 1 && finite(p.position, 3));
    ++contour;
  }
}

// Numbers, where they have been assigned.
void numbers(const ts_segmentation *seg, const std::vector<Index> &teeth) {
  auto jaw = sized<ts_jaw_info>();
  if (ts_get_jaw(seg, &jaw) == TS_OK) HOLDS(jaw.confidence >= 0 && jaw.confidence <= 1);
  for (const Index id : teeth) {
    auto number = sized<ts_number_info>();
    if (ts_get_number(seg, id, &number) != TS_OK) continue;
    Index universal = 0;
    HOLDS(number.confidence >= 0 && number.confidence <= 1 && ts_fdi_to_universal(number.fdi, &universal) == TS_OK);
  }
}

}  // namespace

void fail(const char *what, const char *file, int line) {
  std::fprintf(stderr, "%s:%d: does not hold: %s\nlast message: %s\n", file, line, what, ts_last_error_message());
  std::abort();
}

void status(ts_status got, std::initializer_list<int> blocks) {
  if (got == TS_OK) return;
  HOLDS(std::strcmp(ts_status_name(got), "TS_E_?") != 0);
  HOLDS(got != TS_E_INTERNAL);
  HOLDS(ts_last_error_message()[0] != 0 && std::strchr(ts_last_error_message(), '\n') == nullptr);
  HOLDS(std::find(blocks.begin(), blocks.end(), static_cast<int>(got) / 100) != blocks.end());
}

void model(const ts_model *m) {
  auto report = sized<ts_intake_report>();
  HOLDS(ts_model_get_report(m, &report) == TS_OK);
  const Surface s = surface_of(m);
  HOLDS(s.xyz.size() == 3 * std::size_t{report.vertices} && s.triangles.size() == 3 * std::size_t{report.faces});
  HOLDS(report.faces > 0 && report.faces <= s.triangles.size());
  HOLDS(finite(s.xyz.data(), s.xyz.size()));
  HOLDS(std::isfinite(report.area) && report.area >= 0 && std::isfinite(report.diagonal) &&
        std::isfinite(report.mean_edge));
  std::set<Edge> directed;
  for (std::size_t f = 0; f < report.faces; ++f) {
    const Index *t = &s.triangles[3 * f];
    HOLDS(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
    for (int k = 0; k < 3; ++k) {
      HOLDS(t[k] < report.vertices);
      HOLDS(directed.insert({t[k], t[(k + 1) % 3]}).second);  // manifold, and wound alike on both sides
    }
  }
  for (const Index f : all<Index>([&](Index *p, Index n, Index *c) { return ts_model_get_face_sources(m, p, n, c); }))
    HOLDS(f < report.input_faces);
  for (const Index v : all<Index>([&](Index *p, Index n, Index *c) { return ts_model_get_vertex_map(m, p, n, c); }))
    HOLDS(v == TS_NONE || v < report.vertices);
  const double at[3] = {s.xyz[0] + 0.1, s.xyz[1], s.xyz[2]};
  ts_surface_point point;
  HOLDS(ts_model_nearest(m, at, &point) == TS_OK);
  HOLDS(point.face < report.faces && finite(point.position, 3) && finite(point.barycentric, 3) && point.distance >= 0);
  check::report(m);
}

void features(const ts_model *m, const ts_features *f) {
  const auto groups =
      all<ts_feature_group>([&](ts_feature_group *p, Index n, Index *c) { return ts_features_get_groups(f, p, n, c); });
  const auto points =
      all<ts_feature_point>([&](ts_feature_point *p, Index n, Index *c) { return ts_features_get_points(f, p, n, c); });
  auto report = sized<ts_intake_report>();
  HOLDS(ts_model_get_report(m, &report) == TS_OK);
  std::map<Index, Index> count;
  for (const auto &p : points) {
    HOLDS(p.vertex < report.vertices && finite(p.position, 3) && std::isfinite(p.convexity));
    ++count[p.group];
  }
  HOLDS(count.size() == groups.size());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    HOLDS(groups[i].points == count[groups[i].id] && finite(groups[i].centre, 3));
    HOLDS(groups[i].previous == (i ? groups[i - 1].id : TS_NONE));
    HOLDS(groups[i].next == (i + 1 < groups.size() ? groups[i + 1].id : TS_NONE));
    HOLDS(groups[i].confidence >= 0 && groups[i].confidence <= 1);
  }
  for (const double x : all<double>([&](double *p, Index n, Index *c) { return ts_features_get_arch(f, p, n, c); }, 3))
    HOLDS(std::isfinite(x));
}

void segmentation(const ts_model *m, const ts_segmentation *seg, bool deep, bool but_closed_gingiva) {
  const Surface s = surface_of(m);
  std::vector<std::uint32_t> seen = {0};
  const auto teeth = all<Index>([&](Index *p, Index n, Index *c) { return ts_get_teeth(seg, p, n, c); });
  for (const Index id : teeth) tooth(m, s, seg, id, seen);
  std::sort(seen.begin(), seen.end());
  HOLDS(std::adjacent_find(seen.begin(), seen.end()) == seen.end());
  auto report = sized<ts_intake_report>();
  HOLDS(ts_model_get_report(m, &report) == TS_OK);
  const auto labels = all<Index>([&](Index *p, Index n, Index *c) { return ts_get_labels(seg, p, n, c); });
  HOLDS(labels.size() == report.input_faces);
  for (const Index l : labels) HOLDS(std::binary_search(seen.begin(), seen.end(), l));
  for (const auto &o : all<ts_overlap>([&](ts_overlap *p, Index n, Index *c) { return ts_get_overlaps(seg, p, n, c); }))
    HOLDS(o.winner != o.loser && o.faces > 0 && std::isfinite(o.area) && o.area >= 0);
  for (const auto &i :
       all<ts_review_item>([&](ts_review_item *p, Index n, Index *c) { return ts_get_review(seg, p, n, c); }))
    HOLDS(i.confidence >= 0 && i.confidence <= 1);
  if (!deep) return;
  Index clicks = 0;
  HOLDS(ts_get_click_count(seg, &clicks) == TS_OK);
  for (Index k = 0; k < clicks; ++k) click(s, seg, k);
  numbers(seg, teeth);
  auto memory = sized<ts_memory_info>();
  HOLDS(ts_get_memory(seg, &memory) == TS_OK && memory.factor <= memory.segmentation &&
        memory.factor <= memory.factor_whole);
  for (const std::uint32_t closed : {0u, 1u}) {
    auto options = sized<ts_tooth_mesh_options>();
    options.closed = closed;
    for (std::size_t k = 0; k < teeth.size() + (closed && but_closed_gingiva ? 0 : 1); ++k) {
      ts_mesh *part = nullptr;
      const ts_status got = k < teeth.size() ? ts_tooth_mesh_create(seg, teeth[k], &options, nullptr, &part)
                                             : ts_gingiva_mesh_create(seg, &options, nullptr, &part);
      status(got, {6, 7});
      if (got == TS_OK) mesh(part);
      ts_mesh_destroy(part);
    }
  }
}

void mesh(const ts_mesh *m) {
  auto info = sized<ts_mesh_info>();
  HOLDS(ts_mesh_get_info(m, &info) == TS_OK);
  HOLDS(std::isfinite(info.area) && std::isfinite(info.volume) && std::isfinite(info.lost));
  const auto xyz = all<double>([&](double *p, Index n, Index *c) { return ts_mesh_get_positions(m, p, n, c); }, 3);
  const auto normals = all<double>([&](double *p, Index n, Index *c) { return ts_mesh_get_normals(m, p, n, c); }, 3);
  HOLDS(xyz.size() == 3 * std::size_t{info.vertices} && normals.size() == xyz.size());
  HOLDS(finite(xyz.data(), xyz.size()) && finite(normals.data(), normals.size()));
  const auto triangles = all<Index>([&](Index *p, Index n, Index *c) { return ts_mesh_get_triangles(m, p, n, c); }, 3);
  HOLDS(triangles.size() == 3 * std::size_t{info.triangles});
  for (const Index v : triangles) HOLDS(v < info.vertices);
  if (info.open_rims == 0)
    for (const auto &[e, faces] : edges_of(triangles)) HOLDS(faces.size() == 2);
}

}  // namespace check
