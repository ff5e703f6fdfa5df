/* Clicks on a crown that no feature group lies on. SPDX-License-Identifier: Apache-2.0 */
#include <stdlib.h>
#include <string.h>

#include "fixture.h"
#include "harness.h"

static scan s;

/* The features without one group, and where that group's crown is clicked. */
typedef struct gap {
  ts_features *features;
  ts_segmentation *segmentation;
  uint32_t groups, largest_id, removed, before, after; /* those left; ids */
  double click[3];
} gap;

static void make_gap(gap *out, uint32_t place) {
  static const double down[3] = {0, 0, -1};
  ts_feature_group groups[64];
  ts_surface_point on;
  gap g;
  double above[3];
  uint32_t i;
  memset(&g, 0, sizeof g);
  *out = g;
  REQUIRE_STATUS(ts_features_clone(s.features, &g.features), TS_OK);
  REQUIRE_STATUS(ts_features_get_groups(g.features, groups, 64, &g.groups), TS_OK);
  REQUIRE(place > 0 && place + 1 < g.groups);
  g.removed = groups[place].id;
  g.before = groups[place - 1].id;
  g.after = groups[place + 1].id;
  memcpy(above, groups[place].centre, sizeof above);
  above[2] += 50;
  REQUIRE_STATUS(ts_model_raycast(s.model, above, down, &on), TS_OK);
  memcpy(g.click, on.position, sizeof g.click);
  REQUIRE_STATUS(ts_features_remove_group(g.features, g.removed), TS_OK);
  REQUIRE_STATUS(ts_features_get_groups(g.features, groups, 64, &g.groups), TS_OK);
  for (i = 0; i < g.groups; ++i)
    if (groups[i].id > g.largest_id) g.largest_id = groups[i].id;
  REQUIRE_STATUS(ts_segmentation_create(g.features, NULL, NULL, &g.segmentation), TS_OK);
  *out = g;
}

static void free_gap(gap *g) {
  ts_segmentation_destroy(g->segmentation);
  ts_features_destroy(g->features);
}

static ts_click_info click_info(const ts_segmentation *segmentation, uint32_t click) {
  ts_click_info info;
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  CHECK_STATUS(ts_get_click(segmentation, click, &info), TS_OK);
  return info;
}

static ts_tooth_info tooth_info(const ts_segmentation *segmentation, uint32_t tooth) {
  ts_tooth_info info;
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  CHECK_STATUS(ts_get_tooth(segmentation, tooth, &info), TS_OK);
  return info;
}

/* Of the arch's tooth at the click and the faces that have `label`. */
static double overlap(const ts_segmentation *segmentation, const double at[3], uint32_t label) {
  uint32_t n = s.arch.faces, f, clicked, common = 0, either = 0;
  uint32_t *labels = must_have(sizeof *labels * n);
  ts_surface_point on;
  memset(&on, 0, sizeof on);
  CHECK_STATUS(ts_model_nearest(s.model, at, &on), TS_OK);
  clicked = s.arch.labels[on.face];
  CHECK_STATUS(ts_get_labels(segmentation, labels, n, &n), TS_OK);
  for (f = 0; f < n; ++f) {
    common += s.arch.labels[f] == clicked && labels[f] == label;
    either += s.arch.labels[f] == clicked || labels[f] == label;
  }
  free(labels);
  return (double)common / either;
}

static void a_click_on_a_crown_without_a_group_makes_one(void) {
  gap g;
  ts_click_info click;
  ts_tooth_info tooth;
  uint32_t teeth[4], n = 0, id, count = 0;
  double *u = must_have(sizeof *u * s.arch.vertices);
  make_gap(&g, 5);
  REQUIRE(g.segmentation != NULL);
  id = g.largest_id + 1;
  REQUIRE_STATUS(ts_segment_click(g.segmentation, g.click, NULL, NULL), TS_OK);
  click = click_info(g.segmentation, 0);
  CHECK(click.target == id);
  CHECK(click.neighbour == g.before || click.neighbour == g.after);
  CHECK(click.target_distance < click.neighbour_distance);
  tooth = tooth_info(g.segmentation, id);
  CHECK(tooth.id == id && tooth.click == 0);
  CHECK(tooth.label == g.groups + 1);
  CHECK(tooth.warnings & TS_WARN_MADE_BY_CLICK);
  CHECK(tooth.confidence < 0.75);
  CHECK(overlap(g.segmentation, g.click, tooth.label) > 0.85);
  CHECK(!(tooth_info(g.segmentation, click.neighbour).warnings & TS_WARN_MADE_BY_CLICK));
  REQUIRE_STATUS(ts_get_teeth(g.segmentation, teeth, 4, &n), TS_OK);
  REQUIRE(n == 2); /* along the arch */
  CHECK(click.neighbour == g.before ? teeth[1] == id : teeth[0] == id);
  CHECK_STATUS(ts_get_field(g.segmentation, 0, u, s.arch.vertices, &count), TS_OK);
  CHECK_STATUS(ts_get_tooth(g.segmentation, id + 1, &tooth), TS_E_NOT_FOUND);
  /* Again: it is there. */
  REQUIRE_STATUS(ts_segment_click(g.segmentation, g.click, NULL, NULL), TS_OK);
  CHECK(click_info(g.segmentation, 1).target == id);
  CHECK_STATUS(ts_get_tooth(g.segmentation, id + 1, &tooth), TS_E_NOT_FOUND);
  free(u);
  free_gap(&g);
}

static void at_once_is_one_after_the_other(void) {
  gap apart, together;
  uint32_t n = 0, i;
  double *clicks, *all;
  bytes a, b;
  make_gap(&apart, 5);
  make_gap(&together, 5);
  REQUIRE(apart.segmentation != NULL && together.segmentation != NULL);
  clicks = proposed_clicks(apart.segmentation, &n);
  all = must_have(sizeof *all * 3 * (n + 1));
  memcpy(all, clicks, sizeof *all * 3);
  memcpy(all + 3, apart.click, sizeof *all * 3); /* the second, so that most come after it */
  memcpy(all + 6, clicks + 3, sizeof *all * 3 * (n - 1));
  for (i = 0; i <= n; ++i) CHECK_STATUS(ts_segment_click(apart.segmentation, all + 3 * i, NULL, NULL), TS_OK);
  CHECK_STATUS(ts_segment_clicks(together.segmentation, all, n + 1, NULL, NULL), TS_OK);
  CHECK(click_info(together.segmentation, 1).target == apart.largest_id + 1);
  a = dump_segmentation(apart.segmentation);
  b = dump_segmentation(together.segmentation);
  CHECK(same_bytes(&a, &b));
  free_bytes(&a);
  free_bytes(&b);
  /* The made one came between two of a pair: what that leaves is proposed, the made one is not. */
  free(clicks);
  clicks = proposed_clicks(together.segmentation, &n);
  CHECK(n <= 1);
  CHECK_STATUS(ts_segment_clicks(together.segmentation, clicks, n, NULL, NULL), TS_OK);
  CHECK_STATUS(ts_propose_clicks(together.segmentation, NULL, 0, &n), TS_OK);
  CHECK(n == 0);
  CHECK_STATUS(ts_get_teeth(together.segmentation, NULL, 0, &n), TS_OK);
  CHECK(n == together.groups + 1);
  free(all);
  free(clicks);
  free_gap(&apart);
  free_gap(&together);
}

/* Without its refinement the cut of this upper lateral leaves its cingulum out, which lies behind a fossa that is
 * deeper than the gum line. */
static void a_click_on_a_cingulum_is_held_for_its_tooth(void) {
  static const double cingulum[3] = {-7.022, -5.887, -7.198}, edge[3] = {-8.09, -1.93, -0.97};
  scan crowded = scan_of(make_crowded_arch(20000, 0.35, 1), 2);
  ts_surface_point on;
  ts_tooth_info before, after;
  ts_segment_options o;
  uint32_t target, groups = 0, face = 0, n = crowded.arch.faces, *labels = must_have(sizeof *labels * n);
  CHECK_STATUS(ts_segment_options_init(&o, sizeof o, TS_PRESET_DEFAULT), TS_OK);
  o.refine_band = 0;
  ts_segmentation_destroy(crowded.segmentation);
  crowded.segmentation = NULL;
  REQUIRE_STATUS(ts_segmentation_create(crowded.features, &o, NULL, &crowded.segmentation), TS_OK);
  CHECK_STATUS(ts_features_get_groups(crowded.features, NULL, 0, &groups), TS_OK);
  REQUIRE_STATUS(ts_segment_click(crowded.segmentation, edge, NULL, NULL), TS_OK);
  target = click_info(crowded.segmentation, 0).target;
  before = tooth_info(crowded.segmentation, target);
  CHECK_STATUS(ts_model_nearest(crowded.model, cingulum, &on), TS_OK);
  face = on.face;
  CHECK(crowded.arch.labels[face] != 0);
  CHECK_STATUS(ts_get_labels(crowded.segmentation, labels, n, &n), TS_OK);
  CHECK(labels[face] == 0);
  REQUIRE_STATUS(ts_segment_click(crowded.segmentation, cingulum, NULL, NULL), TS_OK);
  CHECK(click_info(crowded.segmentation, 1).target == target);
  after = tooth_info(crowded.segmentation, target);
  CHECK(after.seeds > before.seeds && after.area > before.area);
  CHECK(!(after.warnings & TS_WARN_MADE_BY_CLICK));
  CHECK_STATUS(ts_get_labels(crowded.segmentation, labels, n, &n), TS_OK);
  CHECK(labels[face] == after.label);
  CHECK(after.label <= groups);
  free(labels);
  free_scan(&crowded);
}

int main(void) {
  s = make_scan(60000, 2); /* coarser, a crown has no seam around it that a click could see */
  RUN(a_click_on_a_cingulum_is_held_for_its_tooth);
  RUN(a_click_on_a_crown_without_a_group_makes_one);
  RUN(at_once_is_one_after_the_other);
  free_scan(&s);
  return harness_finish();
}
