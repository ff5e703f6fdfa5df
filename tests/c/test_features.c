/* Features: found, edited, made by hand. SPDX-License-Identifier: Apache-2.0 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fixture.h"
#include "harness.h"

enum { MOST = 512 };

static scan s;

typedef struct set {
  ts_feature_point points[MOST];
  ts_feature_group groups[MOST];
  uint32_t point_count, group_count;
} set;

/* What a set holds; checks that it is in itself right. */
static set look(const ts_features *features) {
  set it;
  uint32_t i, k = 0, n;
  memset(&it, 0, sizeof it);
  CHECK_STATUS(ts_features_get_points(features, it.points, MOST, &it.point_count), TS_OK);
  CHECK_STATUS(ts_features_get_groups(features, it.groups, MOST, &it.group_count), TS_OK);
  for (i = 0; i < it.group_count; ++i) {
    const ts_feature_group *g = &it.groups[i];
    double centre[3] = {0, 0, 0};
    CHECK(g->points > 0);
    CHECK(g->previous == (i > 0 ? it.groups[i - 1].id : TS_NONE));
    CHECK(g->next == (i + 1 < it.group_count ? it.groups[i + 1].id : TS_NONE));
    for (n = 0; n < g->points && k < it.point_count; ++n, ++k) {
      CHECK(it.points[k].group == g->id);
      centre[0] += it.points[k].position[0] / g->points;
      centre[1] += it.points[k].position[1] / g->points;
      centre[2] += it.points[k].position[2] / g->points;
    }
    for (n = 0; n < 3; ++n) CHECK_NEAR(centre[n], g->centre[n], 1e-9);
  }
  CHECK(k == it.point_count);
  return it;
}

/* -------------------------------------------------------------------------------------------------------- found */

static void found_on_an_arch(void) {
  const set it = look(s.features);
  double occlusal[3], *arch;
  ts_surface_point on;
  uint32_t i, n = 0;
  /* How many teeth are found is not the matter of these tests; that it is an arch's number is. */
  CHECK(4 * it.group_count >= 3 * s.arch.teeth && it.group_count <= s.arch.teeth + 1);
  REQUIRE_STATUS(ts_features_get_occlusal(s.features, occlusal), TS_OK);
  CHECK_NEAR(sqrt(occlusal[0] * occlusal[0] + occlusal[1] * occlusal[1] + occlusal[2] * occlusal[2]), 1, 1e-12);
  CHECK(occlusal[2] > 0.9);
  for (i = 0; i < it.point_count; ++i) {
    const ts_feature_point *p = &it.points[i];
    CHECK(p->by_hand == 0 && p->convexity > 0);
    REQUIRE_STATUS(ts_model_nearest(s.model, p->position, &on), TS_OK);
    CHECK(on.distance < 0.5);
  }
  for (i = 0; i < it.group_count; ++i) {
    CHECK(it.groups[i].arch_from < it.groups[i].arch_to);
    CHECK(it.groups[i].confidence >= 0 && it.groups[i].confidence <= 1);
  }
  REQUIRE_STATUS(ts_features_get_arch(s.features, NULL, 0, &n), TS_OK);
  CHECK(n >= 10);
  arch = must_have(3 * sizeof *arch * n);
  CHECK_STATUS(ts_features_get_arch(s.features, arch, n - 1, &n), TS_E_BUFFER_TOO_SMALL);
  CHECK_STATUS(ts_features_get_arch(s.features, arch, n, &n), TS_OK);
  free(arch);
}

static void nothing_that_looks_like_a_tooth(void) {
  mesh sphere = make_sphere(30, 60), plane = make_plane(60, 80);
  ts_model *models[2];
  int i;
  models[0] = make_model(s.context, &sphere);
  models[1] = make_model(s.context, &plane);
  for (i = 0; i < 2; ++i) {
    char mark;
    ts_features *const sentinel = (ts_features *)(void *)&mark;
    ts_features *out = sentinel;
    harness_case(i == 0 ? "sphere" : "plane");
    CHECK_STATUS(ts_detect_features(models[i], NULL, NULL, &out), TS_E_NO_TEETH);
    CHECK(out == sentinel);
    ts_model_destroy(models[i]);
  }
  free_mesh(&sphere);
  free_mesh(&plane);
}

static void info_counts(void) {
  const set it = look(s.features);
  ts_features *empty = NULL;
  ts_features_info info;
  memset(&info, 0xa5, sizeof info);
  info.struct_size = sizeof info;
  REQUIRE_STATUS(ts_features_get_info(s.features, &info), TS_OK);
  CHECK(info.groups == it.group_count && info.points == it.point_count && info.inside_out == 0);
  REQUIRE_STATUS(ts_features_create(s.model, &empty), TS_OK);
  REQUIRE_STATUS(ts_features_get_info(empty, &info), TS_OK);
  CHECK(info.groups == 0 && info.points == 0 && info.inside_out == 0);
  CHECK(info.warnings == 0 && info.opposed == 0 && info.coverage == 0 && info.arch_length == 0);
  /* A program that was built before the struct grew. */
  memset(&info, 0xa5, sizeof info);
  info.struct_size = 16;
  REQUIRE_STATUS(ts_features_get_info(s.features, &info), TS_OK);
  CHECK(info.struct_size == 16 && info.groups == it.group_count && info.warnings == 0xa5a5a5a5u);
  ts_features_destroy(empty);
}

/* The same mesh with its faces turned round: said, and everything works all the same. */
static void faces_that_look_inwards(void) {
  mesh m = make_arch(30000);
  ts_model *model;
  ts_features *features = NULL;
  ts_segmentation *segmentation = NULL;
  ts_features_info info;
  double occlusal[3], *clicks;
  uint32_t f, n = 0;
  for (f = 0; f < m.faces; ++f) {
    uint32_t *t = m.triangles + 3 * (size_t)f;
    const uint32_t kept = t[1];
    t[1] = t[2];
    t[2] = kept;
  }
  model = make_model(s.context, &m);
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  REQUIRE_STATUS(ts_detect_features(model, NULL, NULL, &features), TS_OK);
  REQUIRE_STATUS(ts_features_get_info(features, &info), TS_OK);
  CHECK(info.inside_out == 1 && info.warnings == TS_WARN_FEATURES_INSIDE_OUT);
  CHECK(info.groups == look(s.features).group_count);
  REQUIRE_STATUS(ts_features_get_occlusal(features, occlusal), TS_OK);
  CHECK(occlusal[2] > 0.9);
  REQUIRE_STATUS(ts_segmentation_create(features, NULL, NULL, &segmentation), TS_OK);
  clicks = proposed_clicks(segmentation, &n);
  CHECK_STATUS(ts_segment_clicks(segmentation, clicks, n, NULL, NULL), TS_OK);
  CHECK_STATUS(ts_get_teeth(segmentation, NULL, 0, &n), TS_OK);
  CHECK(n == info.groups);
  free(clicks);
  ts_segmentation_destroy(segmentation);
  ts_features_destroy(features);
  ts_model_destroy(model);
  free_mesh(&m);
}

/* An arch and a second one: beside it, or biting on it. The one that bites is lower: the very same one would leave no
 * occlusal direction at all, which is an error. */
static mesh two_arches(int biting) {
  const mesh one = make_arch(30000);
  mesh two = one;
  double low[3], high[3];
  size_t i;
  int k;
  two.vertices = 2 * one.vertices;
  two.faces = 2 * one.faces;
  two.xyz = must_have(3 * sizeof *two.xyz * two.vertices);
  two.triangles = must_have(3 * sizeof *two.triangles * two.faces);
  memcpy(two.xyz, one.xyz, 3 * sizeof *one.xyz * one.vertices);
  memcpy(two.triangles, one.triangles, 3 * sizeof *one.triangles * one.faces);
  for (k = 0; k < 3; ++k) low[k] = high[k] = one.xyz[k];
  for (i = 0; i < 3 * (size_t)one.vertices; ++i) {
    if (one.xyz[i] < low[i % 3]) low[i % 3] = one.xyz[i];
    if (one.xyz[i] > high[i % 3]) high[i % 3] = one.xyz[i];
  }
  for (i = 0; i < one.vertices; ++i) {
    const double *from = one.xyz + 3 * i;
    double *to = two.xyz + 3 * (i + one.vertices);
    to[0] = biting ? -from[0] : from[0] + high[0] - low[0] + 5;
    to[1] = from[1];
    to[2] = biting ? high[2] + 1 + 0.5 * (high[2] - from[2]) : from[2];
  }
  for (i = 0; i < 3 * (size_t)one.faces; ++i)
    two.triangles[3 * (size_t)one.faces + i] = one.triangles[i] + one.vertices;
  two.labels = NULL;
  free(one.xyz);
  free(one.triangles);
  free(one.labels);
  return two;
}

static int warned;
static void count_warnings(ts_log_level level, const char *text, void *user) {
  (void)user;
  if (level == TS_LOG_WARNING && strstr(text, "features: ") == text) ++warned;
}

/* One arch raises no doubt; two in one file do not pass silently, and the log says so too. */
static void what_is_no_single_arch_is_said(void) {
  static const struct {
    const char *name;
    uint32_t warnings;
  } cases[] = {{"one", 0}, {"side by side", TS_WARN_FEATURES_SEVERAL_ARCHES}, {"biting", TS_WARN_FEATURES_OPPOSED}};
  ts_context_options o;
  ts_context *context = NULL;
  int i;
  REQUIRE_STATUS(ts_context_options_init(&o, sizeof o), TS_OK);
  o.threads = 1;
  o.log = count_warnings;
  REQUIRE_STATUS(ts_context_create(&o, &context), TS_OK);
  for (i = 0; i < 3; ++i) {
    mesh m = i == 0 ? make_arch(30000) : two_arches(i == 2);
    ts_model *model = make_model(context, &m);
    ts_features *features = NULL, *copy = NULL;
    ts_features_info info;
    harness_case("%s", cases[i].name);
    memset(&info, 0, sizeof info);
    info.struct_size = sizeof info;
    warned = 0;
    REQUIRE_STATUS(ts_detect_features(model, NULL, NULL, &features), TS_OK);
    REQUIRE_STATUS(ts_features_get_info(features, &info), TS_OK);
    CHECK((info.warnings & cases[i].warnings) == cases[i].warnings);
    CHECK(i > 0 || info.warnings == 0);
    CHECK((warned > 0) == (i > 0));
    CHECK(info.opposed >= 0 && info.opposed <= 1 && info.coverage > 0 && info.coverage <= 1);
    CHECK(info.arch_length > 80);
    /* An edit changes nothing about the scan. */
    REQUIRE_STATUS(ts_features_clone(features, &copy), TS_OK);
    REQUIRE_STATUS(ts_features_remove_group(copy, look(copy).groups[0].id), TS_OK);
    REQUIRE_STATUS(ts_features_get_info(copy, &info), TS_OK);
    CHECK((info.warnings & cases[i].warnings) == cases[i].warnings);
    ts_features_destroy(copy);
    ts_features_destroy(features);
    ts_model_destroy(model);
    free_mesh(&m);
  }
  ts_context_destroy(context);
}

static void options(void) {
  ts_feature_options o;
  ts_features *features = NULL;
  set it;
  uint32_t i;
  double occlusal[3];
  REQUIRE_STATUS(ts_feature_options_init(&o, sizeof o), TS_OK);
  CHECK(o.max_points == 8 && o.radius == 2.0 && o.occlusal[0] == 0 && o.occlusal[1] == 0 && o.occlusal[2] == 0);
  o.max_points = 0;
  CHECK_STATUS(ts_detect_features(s.model, &o, NULL, &features), TS_E_INVALID_ARGUMENT);
  o.max_points = 8;
  o.radius = -1;
  CHECK_STATUS(ts_detect_features(s.model, &o, NULL, &features), TS_E_INVALID_ARGUMENT);
  o.radius = (double)NAN;
  CHECK_STATUS(ts_detect_features(s.model, &o, NULL, &features), TS_E_INVALID_ARGUMENT);
  o.radius = 2;
  o.occlusal[1] = (double)INFINITY;
  CHECK_STATUS(ts_detect_features(s.model, &o, NULL, &features), TS_E_INVALID_ARGUMENT);
  CHECK(features == NULL);

  o.occlusal[0] = 0.1;
  o.occlusal[1] = 0;
  o.occlusal[2] = 5;
  o.max_points = 2;
  REQUIRE_STATUS(ts_detect_features(s.model, &o, NULL, &features), TS_OK);
  it = look(features);
  for (i = 0; i < it.group_count; ++i) CHECK(it.groups[i].points <= 2);
  REQUIRE_STATUS(ts_features_get_occlusal(features, occlusal), TS_OK);
  CHECK_NEAR(occlusal[0], 0.1 / sqrt(25.01), 1e-9);
  CHECK_NEAR(occlusal[2], 5 / sqrt(25.01), 1e-9);
  ts_features_destroy(features);
}

/* --------------------------------------------------------------------------------------------------------- by hand */

static const double *vertex(uint32_t i) {
  return s.arch.xyz + 3 * (size_t)i;
}

static void made_from_nothing(void) {
  ts_features *features = NULL;
  ts_segmentation *segmentation = NULL;
  uint32_t first = 77, group = 77, second = 77, other = 77, third = 77, now = 77;
  double bad[3] = {0, 0, 0};
  set it;
  REQUIRE_STATUS(ts_features_create(s.model, &features), TS_OK);
  it = look(features);
  CHECK(it.point_count == 0 && it.group_count == 0);
  CHECK_STATUS(ts_segmentation_create(features, NULL, NULL, &segmentation), TS_E_NO_CONSTRAINT);
  CHECK(segmentation == NULL);

  REQUIRE_STATUS(ts_features_add_point(features, vertex(100), TS_NONE, &first, &group), TS_OK);
  CHECK(first != 77 && group != 77);
  it = look(features);
  CHECK(it.point_count == 1 && it.group_count == 1 && it.points[0].id == first && it.groups[0].id == group);
  CHECK(it.points[0].by_hand == 1 && it.points[0].convexity == 0 && it.groups[0].confidence == 1);
  CHECK_NEAR(it.points[0].position[0], vertex(100)[0], 1e-9);

  REQUIRE_STATUS(ts_features_add_point(features, vertex(200), group, &second, &now), TS_OK);
  CHECK(second != first && now == group);
  REQUIRE_STATUS(ts_features_add_point(features, vertex(3000), TS_NONE, &third, &other), TS_OK);
  CHECK(other != group);
  it = look(features);
  CHECK(it.point_count == 3 && it.group_count == 2);

  /* What does not exist, and what is not a position: refused, and nothing has changed. */
  CHECK_STATUS(ts_features_add_point(features, vertex(1), 12345, &now, &now), TS_E_NOT_FOUND);
  CHECK_STATUS(ts_features_move_point(features, 12345, vertex(1)), TS_E_NOT_FOUND);
  CHECK_STATUS(ts_features_set_group(features, 12345, group, &now), TS_E_NOT_FOUND);
  CHECK_STATUS(ts_features_set_group(features, first, 12345, &now), TS_E_NOT_FOUND);
  CHECK_STATUS(ts_features_remove_point(features, 12345), TS_E_NOT_FOUND);
  CHECK_STATUS(ts_features_remove_group(features, 12345), TS_E_NOT_FOUND);
  bad[2] = (double)NAN;
  CHECK_STATUS(ts_features_add_point(features, bad, TS_NONE, &now, &now), TS_E_INVALID_ARGUMENT);
  CHECK_STATUS(ts_features_move_point(features, first, bad), TS_E_INVALID_ARGUMENT);
  CHECK(now == group);
  it = look(features);
  CHECK(it.point_count == 3 && it.group_count == 2);

  REQUIRE_STATUS(ts_features_move_point(features, second, vertex(250)), TS_OK);
  REQUIRE_STATUS(ts_features_set_group(features, second, other, &now), TS_OK);
  CHECK(now == other);
  REQUIRE_STATUS(ts_features_set_group(features, second, TS_NONE, &now), TS_OK);
  CHECK(now != other && now != group);
  CHECK(look(features).group_count == 3);
  REQUIRE_STATUS(ts_features_set_group(features, second, group, NULL), TS_OK);
  it = look(features);
  CHECK(it.point_count == 3 && it.group_count == 2); /* the group it left was empty and is gone */
  CHECK_STATUS(ts_features_remove_group(features, now), TS_E_NOT_FOUND);

  REQUIRE_STATUS(ts_features_remove_point(features, third), TS_OK);
  it = look(features);
  CHECK(it.point_count == 2 && it.group_count == 1 && it.groups[0].id == group);
  CHECK_STATUS(ts_features_remove_point(features, third), TS_E_NOT_FOUND);
  REQUIRE_STATUS(ts_features_remove_group(features, group), TS_OK);
  it = look(features);
  CHECK(it.point_count == 0 && it.group_count == 0);
  ts_features_destroy(features);
}

static void occlusal_is_set_as_a_unit_vector(void) {
  ts_features *features = NULL;
  static const double up[3] = {0, 0, 7}, zero[3] = {0, 0, 0};
  double bad[3] = {0, 0, 1}, got[3];
  REQUIRE_STATUS(ts_features_create(s.model, &features), TS_OK);
  REQUIRE_STATUS(ts_features_set_occlusal(features, up), TS_OK);
  CHECK_STATUS(ts_features_set_occlusal(features, zero), TS_E_INVALID_ARGUMENT);
  bad[0] = (double)NAN;
  CHECK_STATUS(ts_features_set_occlusal(features, bad), TS_E_INVALID_ARGUMENT);
  REQUIRE_STATUS(ts_features_get_occlusal(features, got), TS_OK);
  CHECK(got[0] == 0 && got[1] == 0 && got[2] == 1);
  ts_features_destroy(features);
}

/* ---------------------------------------------------------------------------------------------------------- edited */

static void a_copy_goes_its_own_way(void) {
  ts_features *copy = NULL;
  bytes before = dump_features(s.features), same, after;
  set it;
  REQUIRE_STATUS(ts_features_clone(s.features, &copy), TS_OK);
  same = dump_features(copy);
  CHECK(same_bytes(&before, &same));
  it = look(copy);
  REQUIRE_STATUS(ts_features_remove_group(copy, it.groups[0].id), TS_OK);
  CHECK(look(copy).group_count == it.group_count - 1);
  after = dump_features(s.features);
  CHECK(same_bytes(&before, &after));
  ts_features_destroy(copy);
  free_bytes(&after);
  free_bytes(&same);
  free_bytes(&before);
}

/* A new group goes where it belongs along the arch: a tooth whose points are taken away and set again by hand has its
 * old neighbours. */
static void a_group_by_hand_finds_its_place(void) {
  ts_features *features = NULL;
  set before, after;
  uint32_t i, place, group = TS_NONE, first;
  REQUIRE_STATUS(ts_features_clone(s.features, &features), TS_OK);
  before = look(features);
  REQUIRE(before.group_count >= 5);
  place = before.group_count / 2;
  for (first = 0, i = 0; i < place; ++i) first += before.groups[i].points;
  REQUIRE_STATUS(ts_features_remove_group(features, before.groups[place].id), TS_OK);
  for (i = 0; i < before.groups[place].points; ++i)
    REQUIRE_STATUS(ts_features_add_point(features, before.points[first + i].position, group, NULL, &group), TS_OK);
  after = look(features);
  CHECK(after.group_count == before.group_count);
  CHECK(after.groups[place].id == group);
  CHECK(after.groups[place].points == before.groups[place].points);
  CHECK(after.groups[place].previous == before.groups[place - 1].id);
  CHECK(after.groups[place].next == before.groups[place + 1].id);
  ts_features_destroy(features);
}

/* A segmentation takes a copy. */
static void editing_does_not_change_a_segmentation(void) {
  ts_features *features = NULL;
  ts_segmentation *segmentation = NULL;
  uint32_t n = 0, now = 0;
  double *clicks, *again;
  REQUIRE_STATUS(ts_features_clone(s.features, &features), TS_OK);
  REQUIRE_STATUS(ts_segmentation_create(features, NULL, NULL, &segmentation), TS_OK);
  clicks = proposed_clicks(segmentation, &n);
  REQUIRE_STATUS(ts_features_remove_group(features, look(features).groups[0].id), TS_OK);
  again = proposed_clicks(segmentation, &now);
  CHECK(now == n && memcmp(clicks, again, 3 * sizeof *clicks * n) == 0);
  free(clicks);
  free(again);
  ts_segmentation_destroy(segmentation);
  ts_features_destroy(features);
}

static void buffers_too_small(void) {
  static ts_feature_point points[MOST];
  static ts_feature_group groups[MOST];
  uint32_t n = 77, p = 0, g = 0;
  REQUIRE_STATUS(ts_features_get_points(s.features, NULL, 0, &p), TS_OK);
  REQUIRE_STATUS(ts_features_get_groups(s.features, NULL, 0, &g), TS_OK);
  REQUIRE(p > 1 && g > 1 && p <= MOST && g <= MOST);
  memset(points, 0xa5, sizeof points);
  memset(groups, 0xa5, sizeof groups);
  CHECK_STATUS(ts_features_get_points(s.features, points, p - 1, &n), TS_E_BUFFER_TOO_SMALL);
  CHECK_STATUS(ts_features_get_groups(s.features, groups, g - 1, &n), TS_E_BUFFER_TOO_SMALL);
  CHECK(n == 77 && points[0].id == 0xa5a5a5a5u && groups[0].id == 0xa5a5a5a5u);
  CHECK_STATUS(ts_features_get_points(s.features, points, p, &n), TS_OK);
  CHECK(n == p);
}

int main(void) {
  s = make_scan(30000, 1);
  RUN(found_on_an_arch);
  RUN(nothing_that_looks_like_a_tooth);
  RUN(info_counts);
  RUN(faces_that_look_inwards);
  RUN(what_is_no_single_arch_is_said);
  RUN(options);
  RUN(made_from_nothing);
  RUN(occlusal_is_set_as_a_unit_vector);
  RUN(a_copy_goes_its_own_way);
  RUN(a_group_by_hand_finds_its_place);
  RUN(editing_does_not_change_a_segmentation);
  RUN(buffers_too_small);
  free_scan(&s);
  return harness_finish();
}
