/* Results: what the getters say fits together, fits the mesh, and fits the arch that was made.
 * SPDX-License-Identifier: Apache-2.0 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fixture.h"
#include "harness.h"

/* A clicked scan, and all of it that the tests look at. */
static scan s;
static uint32_t faces, vertices, teeth, clicks;
static uint32_t *triangles, *labels, *source, *ids;
static double *xyz;
static ts_tooth_info *tooth;

static int set_up(uint32_t wanted) {
  uint32_t n = 0, i;
  double *proposed;
  s = make_scan(wanted, 0);
  proposed = proposed_clicks(s.segmentation, &clicks);
  if (ts_segment_clicks(s.segmentation, proposed, clicks, NULL, NULL) != TS_OK) return 0;
  free(proposed);
  if (ts_model_get_positions(s.model, NULL, 0, &vertices) != TS_OK) return 0;
  if (ts_model_get_triangles(s.model, NULL, 0, &faces) != TS_OK) return 0;
  if (ts_get_teeth(s.segmentation, NULL, 0, &teeth) != TS_OK) return 0;
  xyz = must_have(3 * sizeof *xyz * vertices);
  triangles = must_have(3 * sizeof *triangles * faces);
  source = must_have(sizeof *source * faces);
  labels = must_have(sizeof *labels * s.arch.faces);
  ids = must_have(sizeof *ids * teeth);
  tooth = must_have(sizeof *tooth * teeth);
  if (ts_model_get_positions(s.model, xyz, vertices, &n) != TS_OK) return 0;
  if (ts_model_get_triangles(s.model, triangles, faces, &n) != TS_OK) return 0;
  if (ts_model_get_face_sources(s.model, source, faces, &n) != TS_OK) return 0;
  if (ts_get_teeth(s.segmentation, ids, teeth, &n) != TS_OK) return 0;
  for (i = 0; i < teeth; ++i) {
    memset(&tooth[i], 0, sizeof tooth[i]);
    tooth[i].struct_size = sizeof tooth[i];
    if (ts_get_tooth(s.segmentation, ids[i], &tooth[i]) != TS_OK) return 0;
  }
  return ts_get_labels(s.segmentation, labels, s.arch.faces, &n) == TS_OK && n == s.arch.faces;
}

static void tear_down(void) {
  free(xyz);
  free(triangles);
  free(source);
  free(labels);
  free(ids);
  free(tooth);
  free_scan(&s);
}

static const double *at(uint32_t vertex) {
  return xyz + 3 * (size_t)vertex;
}

static double distance(const double *a, const double *b) {
  return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

static double area(const double *a, const double *b, const double *c) {
  const double u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  const double x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2], z = u[0] * v[1] - u[1] * v[0];
  return 0.5 * sqrt(x * x + y * y + z * z);
}

static double face_area(uint32_t f) {
  const uint32_t *t = triangles + 3 * (size_t)f;
  return area(at(t[0]), at(t[1]), at(t[2]));
}

/* --------------------------------------------------------------------------------------------------- against truth */

/* Nothing in the library knows the labels that the arch was made with. How well single teeth are told apart is measured
 * elsewhere; here it is that what is labelled is teeth, and mostly one each. */
static void labels_are_those_of_the_arch(void) {
  double crowns = 0, labelled = 0, both = 0, pure = 0, share[64][64] = {{0}};
  uint32_t f, i, k;
  REQUIRE(s.arch.teeth < 64 && teeth < 64);
  CHECK(4 * teeth >= 3 * s.arch.teeth && teeth <= s.arch.teeth + 1);
  for (f = 0; f < s.arch.faces; ++f) {
    const uint32_t *t = s.arch.triangles + 3 * (size_t)f;
    const double a = area(s.arch.xyz + 3 * (size_t)t[0], s.arch.xyz + 3 * (size_t)t[1], s.arch.xyz + 3 * (size_t)t[2]);
    REQUIRE(labels[f] < 64);
    share[labels[f]][s.arch.labels[f]] += a;
    if (labels[f]) labelled += a;
    if (s.arch.labels[f]) crowns += a;
    if (labels[f] && s.arch.labels[f]) both += a;
  }
  for (i = 1; i <= teeth; ++i) {
    double most = 0;
    for (k = 1; k <= s.arch.teeth; ++k)
      if (share[i][k] > most) most = share[i][k];
    pure += most;
  }
  CHECK(both / labelled > 0.75);
  CHECK(both / crowns > 0.8);
  CHECK(pure / labelled > 0.7);
  for (k = 1; k < teeth; ++k) CHECK(tooth[k].label > tooth[k - 1].label);
}

/* --------------------------------------------------------------------------------------------------- fits together */

static void teeth_and_labels_agree(void) {
  uint32_t *label_of = calloc(faces, sizeof *label_of), i, k, n = 0, overlap = 0, wrong = 0;
  uint32_t *list = must_have(sizeof *list * faces);
  unsigned char *used = must_have(vertices);
  REQUIRE(label_of != NULL);
  for (i = 0; i < teeth; ++i) {
    double sum = 0;
    uint32_t count = 0;
    harness_case("tooth %lu", (unsigned long)i);
    CHECK(tooth[i].id == ids[i] && tooth[i].label > 0 && tooth[i].click < clicks);
    CHECK_STATUS(ts_get_tooth_faces(s.segmentation, ids[i], list, tooth[i].faces - 1, &n), TS_E_BUFFER_TOO_SMALL);
    REQUIRE_STATUS(ts_get_tooth_faces(s.segmentation, ids[i], list, faces, &n), TS_OK);
    CHECK(n == tooth[i].faces && n > 0);
    memset(used, 0, vertices);
    for (k = 0; k < n; ++k) {
      const uint32_t *t = triangles + 3 * (size_t)list[k];
      overlap += label_of[list[k]] != 0;
      label_of[list[k]] = tooth[i].label;
      sum += face_area(list[k]);
      used[t[0]] = used[t[1]] = used[t[2]] = 1;
    }
    CHECK_NEAR(sum, tooth[i].area, 1e-9 * sum);
    for (k = 0; k < vertices; ++k) count += used[k];
    CHECK(count == tooth[i].vertices);
    REQUIRE_STATUS(ts_get_tooth_vertices(s.segmentation, ids[i], list, vertices, &n), TS_OK);
    CHECK(n == count);
    for (k = 0; k < n; ++k) wrong += !used[list[k]];
    REQUIRE_STATUS(ts_get_tooth_seeds(s.segmentation, ids[i], list, vertices, &n), TS_OK);
    CHECK(n > 0);
    for (k = 0; k < n; ++k) wrong += list[k] >= vertices || !used[list[k]];
    CHECK(tooth[i].confidence >= 0 && tooth[i].confidence <= 1);
  }
  harness_case(NULL);
  for (k = 0; k < faces; ++k) wrong += labels[source[k]] != label_of[k];
  CHECK(overlap == 0 && wrong == 0);
  free(used);
  free(list);
  free(label_of);
}

/* The points of a cut lie on edges of the mesh, one face apart, and go round once. */
static void cuts_run_over_the_mesh(void) {
  uint32_t i, loop, k;
  for (i = 0; i < teeth; ++i) {
    double last = 1e9;
    CHECK(tooth[i].loops >= 1);
    for (loop = 0; loop < tooth[i].loops; ++loop) {
      ts_cut_info info;
      ts_edge_point *points;
      uint32_t n = 0, off = 0;
      double length = 0;
      harness_case("tooth %lu, loop %lu", (unsigned long)i, (unsigned long)loop);
      memset(&info, 0, sizeof info);
      info.struct_size = sizeof info;
      REQUIRE_STATUS(ts_get_cut(s.segmentation, ids[i], loop, &info, NULL, 0, &n), TS_OK);
      CHECK(info.points == n && n >= 3);
      points = must_have(sizeof *points * n);
      CHECK_STATUS(ts_get_cut(s.segmentation, ids[i], loop, NULL, points, n - 1, &n), TS_E_BUFFER_TOO_SMALL);
      REQUIRE_STATUS(ts_get_cut(s.segmentation, ids[i], loop, NULL, points, n, &n), TS_OK);
      for (k = 0; k < n; ++k) {
        const ts_edge_point *p = &points[k];
        double on[3];
        int c;
        if (p->a >= vertices || p->b >= vertices || !(p->t >= 0 && p->t <= 1)) {
          ++off;
          continue;
        }
        for (c = 0; c < 3; ++c) on[c] = (1 - p->t) * at(p->a)[c] + p->t * at(p->b)[c];
        off += distance(on, p->position) > 1e-9;
        if (k + 1 < n || info.closed) length += distance(p->position, points[(k + 1) % n].position);
      }
      CHECK(off == 0);
      CHECK_NEAR(length, info.length, 1e-9 * length);
      CHECK(info.length <= last + 1e-9); /* the longest first */
      CHECK(info.concavity >= 0 && info.concavity <= 1);
      CHECK(info.gradient >= 0);
      last = info.length;
      free(points);
    }
    CHECK_STATUS(ts_get_cut(s.segmentation, ids[i], tooth[i].loops, NULL, NULL, 0, &k), TS_E_NOT_FOUND);
  }
}

/* Counter-clockwise round the tooth seen from outside, which from above is the sign of the area in the plane. */
static void cuts_go_round_counter_clockwise(void) {
  uint32_t i, k, n = 0;
  for (i = 0; i < teeth; ++i) {
    ts_edge_point *points;
    double twice = 0;
    harness_case("tooth %lu", (unsigned long)i);
    REQUIRE_STATUS(ts_get_cut(s.segmentation, ids[i], 0, NULL, NULL, 0, &n), TS_OK);
    points = must_have(sizeof *points * n);
    REQUIRE_STATUS(ts_get_cut(s.segmentation, ids[i], 0, NULL, points, n, &n), TS_OK);
    for (k = 0; k < n; ++k) {
      const double *p = points[k].position, *q = points[(k + 1) % n].position;
      twice += p[0] * q[1] - p[1] * q[0];
    }
    CHECK(twice > 0);
    free(points);
  }
}

/* ------------------------------------------------------------------------------------------------- field, contours */

static void field_is_that_of_equation_3(void) {
  uint32_t click, i, n = 0;
  double *u = must_have(sizeof *u * vertices);
  for (click = 0; click < clicks; ++click) {
    ts_click_info info;
    uint32_t bins[64], bin_count = 0, seeds = 0, *seed = must_have(sizeof *seed * vertices), finite = 0, fullest = 0;
    double low = 1, high = 0, target = 0, neighbour = 1;
    unsigned long in_bins = 0;
    harness_case("click %lu", (unsigned long)click);
    memset(&info, 0, sizeof info);
    info.struct_size = sizeof info;
    REQUIRE_STATUS(ts_get_click(s.segmentation, click, &info), TS_OK);
    CHECK_STATUS(ts_get_field(s.segmentation, click, u, vertices - 1, &n), TS_E_BUFFER_TOO_SMALL);
    REQUIRE_STATUS(ts_get_field(s.segmentation, click, u, vertices, &n), TS_OK);
    CHECK(n == vertices);
    for (i = 0; i < n; ++i) {
      if (u[i] != u[i]) continue;
      ++finite;
      if (u[i] < low) low = u[i];
      if (u[i] > high) high = u[i];
    }
    CHECK(low >= -1e-6 && high <= 1 + 1e-6); /* the maximum principle */
    CHECK(low < 1e-6 && high > 1 - 1e-6);
    REQUIRE_STATUS(ts_get_tooth_seeds(s.segmentation, info.target, seed, vertices, &seeds), TS_OK);
    for (i = 0; i < seeds; ++i)
      if (u[seed[i]] > target) target = u[seed[i]];
    CHECK(target < 1e-5);
    if (info.neighbour != TS_NONE) {
      REQUIRE_STATUS(ts_get_tooth_seeds(s.segmentation, info.neighbour, seed, vertices, &seeds), TS_OK);
      for (i = 0; i < seeds; ++i)
        if (u[seed[i]] < neighbour) neighbour = u[seed[i]];
      CHECK(neighbour > 1 - 1e-5);
    }
    REQUIRE_STATUS(ts_get_histogram(s.segmentation, click, bins, 64, &bin_count), TS_OK);
    CHECK(bin_count == 50);
    for (i = 0; i < bin_count; ++i) {
      in_bins += bins[i];
      if (bins[i] > bins[fullest]) fullest = i;
    }
    CHECK(in_bins == finite);
    CHECK_STATUS(ts_get_histogram(s.segmentation, click, bins, 49, &bin_count), TS_E_BUFFER_TOO_SMALL);
    CHECK(info.v_med > 0 && info.v_med < 1);
    free(seed);
  }
  free(u);
}

static void contours_are_lines_of_the_field(void) {
  static ts_contour_info info[128];
  uint32_t n = 0, i, k, c;
  double *u = must_have(sizeof *u * vertices), last = 0;
  REQUIRE_STATUS(ts_get_field(s.segmentation, 0, u, vertices, &n), TS_OK);
  REQUIRE_STATUS(ts_get_contours(s.segmentation, 0, info, 128, &n), TS_OK);
  CHECK(n == 100);
  CHECK_STATUS(ts_get_contours(s.segmentation, 0, info, n - 1, &k), TS_E_BUFFER_TOO_SMALL);
  for (c = 0; c < n; ++c) {
    ts_edge_point *points = must_have(sizeof *points * info[c].points);
    uint32_t *starts = must_have(sizeof *starts * info[c].polylines), off = 0;
    uint8_t *closed = must_have(info[c].polylines);
    double length = 0;
    harness_case("contour %lu", (unsigned long)c);
    CHECK(info[c].iso > last && info[c].iso < 1);
    last = info[c].iso;
    REQUIRE_STATUS(ts_get_contour_points(s.segmentation, 0, c, points, info[c].points, &k, starts, closed), TS_OK);
    CHECK(k == info[c].points);
    for (i = 0; i < k; ++i)
      off += fabs((1 - points[i].t) * u[points[i].a] + points[i].t * u[points[i].b] - info[c].iso) > 1e-9;
    CHECK(off == 0);
    for (i = 0; i < info[c].polylines; ++i) {
      const uint32_t end = i + 1 < info[c].polylines ? starts[i + 1] : k;
      uint32_t p;
      CHECK(closed[i] <= 1 && starts[i] < end);
      for (p = starts[i]; p < end; ++p)
        if (p + 1 < end || closed[i])
          length += distance(points[p].position, points[p + 1 < end ? p + 1 : starts[i]].position);
    }
    CHECK_NEAR(length, info[c].length, 1e-6 * (1 + length));
    CHECK(info[c].gradient >= 0 && info[c].concavity >= 0 && info[c].concavity <= 1 && info[c].chosen <= 2);
    if (k > 0)
      CHECK_STATUS(ts_get_contour_points(s.segmentation, 0, c, points, k - 1, &k, NULL, NULL), TS_E_BUFFER_TOO_SMALL);
    free(points);
    free(starts);
    free(closed);
  }
  harness_case(NULL);
  CHECK_STATUS(ts_get_contour_points(s.segmentation, 0, n, NULL, 0, &k, NULL, NULL), TS_E_NOT_FOUND);
  free(u);
}

/* ----------------------------------------------------------------------------------------------------- not to be had
 */

static void what_does_not_exist_is_not_found(void) {
  ts_click_info click;
  ts_tooth_info info;
  double u = 5;
  uint32_t index = 5, n = 77;
  memset(&click, 0, sizeof click);
  click.struct_size = sizeof click;
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  CHECK_STATUS(ts_get_click(s.segmentation, clicks, &click), TS_E_NOT_FOUND);
  CHECK_STATUS(ts_get_click(s.segmentation, TS_NONE, &click), TS_E_NOT_FOUND);
  CHECK_STATUS(ts_get_field(s.segmentation, clicks, &u, 1, &n), TS_E_NOT_FOUND);
  CHECK_STATUS(ts_get_histogram(s.segmentation, clicks, &index, 1, &n), TS_E_NOT_FOUND);
  CHECK_STATUS(ts_get_contours(s.segmentation, clicks, NULL, 0, &n), TS_E_NOT_FOUND);
  CHECK_STATUS(ts_get_tooth(s.segmentation, 12345, &info), TS_E_NOT_FOUND);
  CHECK_STATUS(ts_get_tooth(s.segmentation, TS_NONE, &info), TS_E_NOT_FOUND);
  CHECK_STATUS(ts_get_tooth_faces(s.segmentation, 12345, &index, 1, &n), TS_E_NOT_FOUND);
  CHECK_STATUS(ts_get_tooth_vertices(s.segmentation, 12345, &index, 1, &n), TS_E_NOT_FOUND);
  CHECK_STATUS(ts_get_tooth_seeds(s.segmentation, 12345, &index, 1, &n), TS_E_NOT_FOUND);
  CHECK_STATUS(ts_get_cut(s.segmentation, 12345, 0, NULL, NULL, 0, &n), TS_E_NOT_FOUND);
  CHECK(u == 5 && index == 5 && n == 77);
}

static void before_any_click(void) {
  ts_segmentation *fresh = NULL;
  uint32_t n = 77, i, other = 0, *all = must_have(sizeof *all * s.arch.faces);
  REQUIRE_STATUS(ts_segmentation_create(s.features, NULL, NULL, &fresh), TS_OK);
  CHECK_STATUS(ts_get_click_count(fresh, &n), TS_OK);
  CHECK(n == 0);
  CHECK_STATUS(ts_get_teeth(fresh, all, 0, &n), TS_OK);
  CHECK(n == 0);
  REQUIRE_STATUS(ts_get_labels(fresh, all, s.arch.faces, &n), TS_OK);
  CHECK(n == s.arch.faces);
  for (i = 0; i < n; ++i) other += all[i] != 0;
  CHECK(other == 0);
  CHECK_STATUS(ts_get_labels(fresh, all, n - 1, &n), TS_E_BUFFER_TOO_SMALL);
  free(all);
  ts_segmentation_destroy(fresh);
}

static void times_are_times(void) {
  ts_prepare_times t;
  memset(&t, 0, sizeof t);
  t.struct_size = sizeof t;
  REQUIRE_STATUS(ts_get_prepare_times(s.segmentation, &t), TS_OK);
  CHECK(t.intake > 0 && t.features > 0 && t.weights > 0 && t.factorise > 0);
}

/* The caller's faces are labelled in the caller's order, whatever intake dropped. */
static void dropped_faces_have_labels_too(void) {
  mesh m = s.arch;
  ts_mesh_input input;
  ts_model *model = NULL;
  ts_features *features = NULL;
  ts_segmentation *segmentation = NULL;
  uint32_t n = 0, f, wrong = 0, *got, k;
  double *proposed;
  m.faces = s.arch.faces + 20; /* ten faces twice, ten without area beside them */
  m.triangles = must_have(3 * sizeof *m.triangles * m.faces);
  memcpy(m.triangles, s.arch.triangles, 3 * sizeof *m.triangles * s.arch.faces);
  for (k = 0; k < 10; ++k) {
    const uint32_t *t = s.arch.triangles + 3 * (size_t)(s.arch.faces / 10 * k);
    uint32_t *twice = m.triangles + 3 * (size_t)(s.arch.faces + k), *flat = twice + 30;
    twice[0] = t[1], twice[1] = t[2], twice[2] = t[0];
    flat[0] = flat[1] = t[0], flat[2] = t[1];
  }
  input = input_of(&m);
  REQUIRE_STATUS(ts_model_create(s.context, &input, NULL, NULL, &model), TS_OK);
  REQUIRE_STATUS(ts_detect_features(model, NULL, NULL, &features), TS_OK);
  REQUIRE_STATUS(ts_segmentation_create(features, NULL, NULL, &segmentation), TS_OK);
  proposed = proposed_clicks(segmentation, &n);
  REQUIRE_STATUS(ts_segment_clicks(segmentation, proposed, n, NULL, NULL), TS_OK);
  got = must_have(sizeof *got * m.faces);
  REQUIRE_STATUS(ts_get_labels(segmentation, got, m.faces, &n), TS_OK);
  CHECK(n == m.faces);
  for (f = 0; f < s.arch.faces; ++f) wrong += got[f] != labels[f];
  CHECK(wrong == 0); /* what was dropped has changed nothing else */
  for (k = 0; k < 10; ++k) CHECK(got[s.arch.faces + k] == got[s.arch.faces / 10 * k]);
  free(got);
  free(proposed);
  free(m.triangles);
  ts_segmentation_destroy(segmentation);
  ts_features_destroy(features);
  ts_model_destroy(model);
}

int main(void) {
  if (!CHECK(set_up(30000))) return harness_finish();
  RUN(labels_are_those_of_the_arch);
  RUN(teeth_and_labels_agree);
  RUN(cuts_run_over_the_mesh);
  RUN(cuts_go_round_counter_clockwise);
  RUN(field_is_that_of_equation_3);
  RUN(contours_are_lines_of_the_field);
  RUN(what_does_not_exist_is_not_found);
  RUN(before_any_click);
  RUN(times_are_times);
  RUN(dropped_faces_have_labels_too);
  tear_down();
  return harness_finish();
}
