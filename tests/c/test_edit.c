/* Edits of a cut. SPDX-License-Identifier: Apache-2.0 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fixture.h"
#include "harness.h"

static scan s;
static uint32_t id, neighbour; /* of a tooth in the middle of the arch, and of the one beside it */
static double centre[3];
static const double far_away[3] = {500, 500, 500};

static ts_tooth_info tooth_info(uint32_t tooth) {
  ts_tooth_info info;
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  CHECK_STATUS(ts_get_tooth(s.segmentation, tooth, &info), TS_OK);
  return info;
}

/* Loop 0, to be freed. */
static ts_edge_point *cut_of(uint32_t tooth, uint32_t *count) {
  ts_edge_point *points;
  CHECK_STATUS(ts_get_cut(s.segmentation, tooth, 0, NULL, NULL, 0, count), TS_OK);
  points = must_have(sizeof *points * *count);
  CHECK_STATUS(ts_get_cut(s.segmentation, tooth, 0, NULL, points, *count, count), TS_OK);
  return points;
}

static double distance(const double a[3], const double b[3]) {
  return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

/* A place beside a point of the cut, away from the tooth's middle by `mm`, on the surface. */
static void beside(const ts_edge_point *p, double mm, double to[3]) {
  ts_surface_point on;
  double away[3], length = distance(p->position, centre);
  int k;
  for (k = 0; k < 3; ++k) away[k] = p->position[k] + mm * (p->position[k] - centre[k]) / length;
  CHECK_STATUS(ts_model_nearest(s.model, away, &on), TS_OK);
  memcpy(to, on.position, sizeof on.position);
}

static double nearest_of(const double at[3], uint32_t tooth) {
  uint32_t n = 0, i;
  ts_edge_point *points = cut_of(tooth, &n);
  double least = 1e9;
  for (i = 0; i < n; ++i) least = fmin(least, distance(points[i].position, at));
  free(points);
  return least;
}

static uint32_t edits_of(uint32_t tooth, ts_cut_edit *edits, uint32_t capacity) {
  uint32_t n = 77;
  CHECK_STATUS(ts_get_cut_edits(s.segmentation, tooth, edits, capacity, &n), TS_OK);
  return n;
}

/* The lowest point of the loop, seen from the middle of the tooth: on the gum, as far from contacts as can be. */
static uint32_t free_point(const ts_edge_point *points, uint32_t n) {
  uint32_t i, best = 0, other, teeth = 0, k;
  double most = -1;
  uint32_t *ids;
  CHECK_STATUS(ts_get_teeth(s.segmentation, NULL, 0, &teeth), TS_OK);
  ids = must_have(sizeof *ids * teeth);
  CHECK_STATUS(ts_get_teeth(s.segmentation, ids, teeth, &teeth), TS_OK);
  for (i = 0; i < n; i += 5) {
    double clear = 1e9;
    for (k = 0; k < teeth; ++k) {
      ts_edge_point *others;
      uint32_t j;
      if (ids[k] == id) continue;
      others = cut_of(ids[k], &other);
      for (j = 0; j < other; j += 5) clear = fmin(clear, distance(points[i].position, others[j].position));
      free(others);
    }
    if (clear > most) most = clear, best = i;
  }
  free(ids);
  return best;
}

static void drag_and_reset(void) {
  uint32_t n = 0, at;
  double to[3];
  const ts_tooth_info before = tooth_info(id);
  ts_edge_point *points = cut_of(id, &n);
  bytes untouched = dump_segmentation(s.segmentation), after;
  ts_cut_edit edits[4];
  at = free_point(points, n);
  beside(&points[at], 0.8, to);
  REQUIRE_STATUS(ts_cut_drag(s.segmentation, id, 0, at, to, 0, NULL), TS_OK);
  CHECK(nearest_of(to, id) < 0.3);
  CHECK(tooth_info(id).area > before.area);
  CHECK(tooth_info(id).loops == before.loops);
  CHECK(tooth_info(id).gradient > 0);
  REQUIRE(edits_of(id, edits, 4) == 1);
  CHECK(edits[0].kind == TS_EDIT_DRAG && edits[0].status == TS_OK && edits[0].points == 2);
  CHECK_NEAR(distance(edits[0].to, to), 0, 1e-12);
  CHECK_NEAR(distance(edits[0].from, points[at].position), 0, 1e-12);
  REQUIRE_STATUS(ts_cut_reset(s.segmentation, id), TS_OK);
  after = dump_segmentation(s.segmentation);
  CHECK(same_bytes(&untouched, &after));
  CHECK(edits_of(id, NULL, 0) == 0);
  CHECK_STATUS(ts_cut_reset(s.segmentation, id), TS_OK);
  free_bytes(&after);
  free_bytes(&untouched);
  free(points);
}

static void offset_smooth_draw(void) {
  uint32_t n = 0, at;
  double stroke[9];
  const ts_tooth_info before = tooth_info(id);
  ts_edge_point *points = cut_of(id, &n);
  ts_cut_info smooth, rough;
  memset(&smooth, 0, sizeof smooth);
  smooth.struct_size = sizeof smooth;
  rough = smooth;
  at = free_point(points, n);
  memcpy(stroke, points[(at + n - n / 20) % n].position, 3 * sizeof *stroke);
  beside(&points[at], 0.7, stroke + 3);
  memcpy(stroke + 6, points[(at + n / 20) % n].position, 3 * sizeof *stroke);
  REQUIRE_STATUS(ts_cut_draw(s.segmentation, id, stroke, 3, NULL), TS_OK);
  CHECK(nearest_of(stroke + 3, id) < 0.3);
  CHECK(tooth_info(id).area > before.area);
  CHECK_STATUS(ts_get_cut(s.segmentation, id, 0, &rough, NULL, 0, NULL), TS_OK);
  REQUIRE_STATUS(ts_cut_smooth(s.segmentation, id, 0.4, NULL), TS_OK);
  CHECK_STATUS(ts_get_cut(s.segmentation, id, 0, &smooth, NULL, 0, NULL), TS_OK);
  CHECK(smooth.length < rough.length);
  REQUIRE_STATUS(ts_cut_reset(s.segmentation, id), TS_OK);
  REQUIRE_STATUS(ts_cut_offset(s.segmentation, id, -0.3, NULL), TS_OK);
  CHECK(tooth_info(id).area < before.area);
  REQUIRE_STATUS(ts_cut_offset(s.segmentation, id, 0.5, NULL), TS_OK);
  CHECK(tooth_info(id).area > before.area);
  CHECK(edits_of(id, NULL, 0) == 2);
  REQUIRE_STATUS(ts_cut_reset(s.segmentation, id), TS_OK);
  CHECK(tooth_info(id).area == before.area);
  free(points);
}

static void refusals_change_nothing(void) {
  uint32_t n = 0, at, k;
  double to[3], bad[3] = {0, 0, 0}, two[6];
  ts_edge_point *points = cut_of(id, &n);
  bytes before, after;
  ts_job *job = NULL;
  at = free_point(points, n);
  beside(&points[at], 0.8, to);
  bad[1] = (double)NAN;
  REQUIRE_STATUS(ts_cut_offset(s.segmentation, id, 0.1, NULL), TS_OK); /* so that there is an edit to be lost */
  free(points);
  points = cut_of(id, &n);
  at = free_point(points, n);
  before = dump_segmentation(s.segmentation);
  CHECK_STATUS(ts_cut_drag(s.segmentation, 4000, 0, at, to, 0, NULL), TS_E_NOT_FOUND);
  CHECK_STATUS(ts_cut_drag(s.segmentation, id, 99, at, to, 0, NULL), TS_E_NOT_FOUND);
  CHECK_STATUS(ts_cut_drag(s.segmentation, id, 0, n, to, 0, NULL), TS_E_NOT_FOUND);
  CHECK_STATUS(ts_cut_drag(s.segmentation, id, 0, at, bad, 0, NULL), TS_E_INVALID_ARGUMENT);
  CHECK_STATUS(ts_cut_drag(s.segmentation, id, 0, at, to, -1, NULL), TS_E_INVALID_ARGUMENT);
  CHECK_STATUS(ts_cut_drag(s.segmentation, id, 0, at, to, (double)NAN, NULL), TS_E_INVALID_ARGUMENT);
  CHECK_STATUS(ts_cut_drag(s.segmentation, id, 0, at, far_away, 0, NULL), TS_E_CLICK_OFF_SURFACE);
  CHECK(strstr(ts_last_error_message(), "(500, 500, 500) is ") != NULL);
  CHECK_STATUS(ts_cut_drag(s.segmentation, id, 0, at, points[at].position, 0, NULL), TS_E_EDIT_NOTHING);
  CHECK_STATUS(ts_cut_drag(s.segmentation, id, 0, at, points[(at + n / 2) % n].position, 0, NULL), TS_E_EDIT_CROSSING);
  { /* onto the tooth beside it: a face of that one's own */
    uint32_t seeds = 0, *vertex, vertices = 0;
    double *xyz;
    CHECK_STATUS(ts_get_tooth_seeds(s.segmentation, neighbour, NULL, 0, &seeds), TS_OK);
    vertex = must_have(sizeof *vertex * seeds);
    CHECK_STATUS(ts_get_tooth_seeds(s.segmentation, neighbour, vertex, seeds, &seeds), TS_OK);
    CHECK_STATUS(ts_model_get_positions(s.model, NULL, 0, &vertices), TS_OK);
    xyz = must_have(3 * sizeof *xyz * vertices);
    CHECK_STATUS(ts_model_get_positions(s.model, xyz, vertices, &vertices), TS_OK);
    CHECK_STATUS(ts_cut_drag(s.segmentation, id, 0, at, xyz + 3 * (size_t)vertex[0], 0, NULL), TS_E_EDIT_ON_TOOTH);
    free(xyz);
    free(vertex);
  }
  for (k = 0; k < 3; ++k) two[k] = points[at].position[k], two[3 + k] = to[k];
  CHECK_STATUS(ts_cut_draw(s.segmentation, id, two, 0, NULL), TS_E_INVALID_ARGUMENT);
  CHECK_STATUS(ts_cut_draw(s.segmentation, id, two, 1, NULL), TS_E_INVALID_ARGUMENT);
  for (k = 0; k < 3; ++k) two[3 + k] = two[k];
  CHECK_STATUS(ts_cut_draw(s.segmentation, id, two, 2, NULL), TS_E_EDIT_NOTHING);
  memcpy(two + 3, centre, sizeof centre);
  CHECK_STATUS(ts_cut_draw(s.segmentation, id, two, 2, NULL), TS_E_EDIT_OFF_CUT);
  memcpy(two + 3, bad, sizeof bad);
  CHECK_STATUS(ts_cut_draw(s.segmentation, id, two, 2, NULL), TS_E_INVALID_ARGUMENT);
  memcpy(two + 3, far_away, sizeof far_away);
  CHECK_STATUS(ts_cut_draw(s.segmentation, id, two, 2, NULL), TS_E_CLICK_OFF_SURFACE);
  CHECK_STATUS(ts_cut_offset(s.segmentation, id, 0, NULL), TS_E_EDIT_NOTHING);
  CHECK_STATUS(ts_cut_offset(s.segmentation, id, -5, NULL), TS_E_EDIT_NO_LOOP);
  CHECK_STATUS(ts_cut_offset(s.segmentation, id, 9, NULL), TS_E_EDIT_ON_TOOTH);
  CHECK_STATUS(ts_cut_offset(s.segmentation, id, (double)INFINITY, NULL), TS_E_INVALID_ARGUMENT);
  CHECK_STATUS(ts_cut_smooth(s.segmentation, id, 0, NULL), TS_E_INVALID_ARGUMENT);
  CHECK_STATUS(ts_cut_smooth(s.segmentation, id, 3, NULL), TS_E_INVALID_ARGUMENT);
  CHECK_STATUS(ts_cut_reset(s.segmentation, 4000), TS_E_NOT_FOUND);
  REQUIRE_STATUS(ts_job_create(s.context, NULL, NULL, &job), TS_OK);
  ts_job_cancel(job);
  CHECK_STATUS(ts_cut_offset(s.segmentation, id, 0.2, job), TS_E_CANCELLED);
  ts_job_destroy(job);
  after = dump_segmentation(s.segmentation);
  CHECK(same_bytes(&before, &after));
  CHECK(edits_of(id, NULL, 0) == 1);
  {
    ts_cut_edit one;
    uint32_t count = 77;
    one.points = 77;
    CHECK_STATUS(ts_cut_smooth(s.segmentation, id, 0.1, NULL), TS_OK);
    CHECK_STATUS(ts_get_cut_edits(s.segmentation, id, &one, 1, &count), TS_E_BUFFER_TOO_SMALL);
    CHECK(count == 77 && one.points == 77);
  }
  CHECK_STATUS(ts_cut_reset(s.segmentation, id), TS_OK);
  free_bytes(&after);
  free_bytes(&before);
  free(points);
}

static void a_click_again_applies_them_again(void) {
  uint32_t n = 0, at, again = 0;
  double to[3];
  ts_edge_point *points = cut_of(id, &n);
  ts_click_info info;
  ts_tooth_info edited;
  ts_cut_edit edits[2];
  info.struct_size = sizeof info;
  at = free_point(points, n);
  beside(&points[at], 0.8, to);
  REQUIRE_STATUS(ts_cut_drag(s.segmentation, id, 0, at, to, 0, NULL), TS_OK);
  REQUIRE_STATUS(ts_cut_offset(s.segmentation, id, 0.15, NULL), TS_OK);
  edited = tooth_info(id);
  REQUIRE_STATUS(ts_get_click(s.segmentation, edited.click, &info), TS_OK);
  REQUIRE_STATUS(ts_segment_click(s.segmentation, info.position, NULL, &again), TS_OK);
  CHECK(again > edited.click);
  CHECK(tooth_info(id).click == again);
  CHECK(tooth_info(id).area == edited.area);
  CHECK(tooth_info(id).faces == edited.faces);
  REQUIRE(edits_of(id, edits, 2) == 2);
  CHECK(edits[0].kind == TS_EDIT_DRAG && edits[0].status == TS_OK);
  CHECK(edits[1].kind == TS_EDIT_OFFSET && edits[1].status == TS_OK);
  CHECK_NEAR(edits[1].amount, 0.15, 0);
  CHECK_STATUS(ts_cut_reset(s.segmentation, id), TS_OK);
  CHECK(tooth_info(id).area < edited.area);
  free(points);
}

int main(void) {
  ts_click_info info;
  uint32_t vertices = 0, n = 0, last = 0, *of_tooth, i;
  double *xyz, *clicks;
  s = make_scan(40000, 1);
  label_centre(&s.arch, s.arch.teeth / 2, centre);
  /* All teeth, so that what is beside the one looked at is known to be gum. */
  clicks = proposed_clicks(s.segmentation, &n);
  CHECK_STATUS(ts_segment_clicks(s.segmentation, clicks, n, NULL, NULL), TS_OK);
  free(clicks);
  CHECK_STATUS(ts_get_click_count(s.segmentation, &last), TS_OK);
  if (!CHECK_STATUS(ts_segment_click(s.segmentation, centre, NULL, NULL), TS_OK)) return 1;
  info.struct_size = sizeof info;
  CHECK_STATUS(ts_get_click(s.segmentation, last, &info), TS_OK);
  id = info.target;
  neighbour = info.neighbour;
  CHECK_STATUS(ts_model_get_positions(s.model, NULL, 0, &vertices), TS_OK);
  xyz = must_have(3 * sizeof *xyz * vertices);
  CHECK_STATUS(ts_model_get_positions(s.model, xyz, vertices, &vertices), TS_OK);
  CHECK_STATUS(ts_get_tooth_vertices(s.segmentation, id, NULL, 0, &n), TS_OK);
  of_tooth = must_have(sizeof *of_tooth * n);
  CHECK_STATUS(ts_get_tooth_vertices(s.segmentation, id, of_tooth, n, &n), TS_OK);
  centre[0] = centre[1] = centre[2] = 0;
  for (i = 0; i < 3 * n; ++i) centre[i % 3] += xyz[3 * (size_t)of_tooth[i / 3] + i % 3] / n;
  free(of_tooth);
  free(xyz);
  RUN(drag_and_reset);
  RUN(offset_smooth_draw);
  RUN(refusals_change_nothing);
  RUN(a_click_again_applies_them_again);
  free_scan(&s);
  return harness_finish();
}
