/* Clicks: what they separate, what is refused, and that one does not depend on the others.
 * SPDX-License-Identifier: Apache-2.0 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fixture.h"
#include "harness.h"

static scan s;

static ts_segmentation *fresh(void) {
  ts_segmentation *out = NULL;
  CHECK_STATUS(ts_segmentation_create(s.features, NULL, NULL, &out), TS_OK);
  return out;
}

static uint32_t tooth_count(const ts_segmentation *segmentation) {
  uint32_t n = 77;
  CHECK_STATUS(ts_get_teeth(segmentation, NULL, 0, &n), TS_OK);
  return n;
}

static uint32_t click_count(const ts_segmentation *segmentation) {
  uint32_t n = 77;
  CHECK_STATUS(ts_get_click_count(segmentation, &n), TS_OK);
  return n;
}

static ts_click_info click_info(const ts_segmentation *segmentation, uint32_t click) {
  ts_click_info info;
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  CHECK_STATUS(ts_get_click(segmentation, click, &info), TS_OK);
  return info;
}

/* The middle of the gingival face furthest from the biting surface: +z is the occlusal direction. */
static void low_on_the_gingiva(double xyz[3]) {
  uint32_t f, lowest = TS_NONE;
  double z = 1e9;
  for (f = 0; f < s.arch.faces; ++f) {
    const double *p = s.arch.xyz + 3 * (size_t)s.arch.triangles[3 * (size_t)f];
    if (s.arch.labels[f] == 0 && p[2] < z) z = p[2], lowest = f;
  }
  memcpy(xyz, s.arch.xyz + 3 * (size_t)s.arch.triangles[3 * (size_t)lowest], 3 * sizeof *xyz);
}

static const double far_away[3] = {1000, 0, 0};

/* ----------------------------------------------------------------------------------------------------------- clicks */

static void proposed_clicks_cover_every_group(void) {
  ts_segmentation *segmentation = fresh();
  uint32_t groups = 0, n = 0, i;
  double *clicks = proposed_clicks(segmentation, &n);
  ts_status *statuses = must_have(sizeof *statuses * n);
  REQUIRE_STATUS(ts_features_get_groups(s.features, NULL, 0, &groups), TS_OK);
  CHECK(n >= groups / 2 && n <= groups / 2 + 1);
  CHECK(tooth_count(segmentation) == 0 && click_count(segmentation) == 0);
  CHECK_STATUS(ts_propose_clicks(segmentation, clicks, n - 1, &i), TS_E_BUFFER_TOO_SMALL);
  REQUIRE_STATUS(ts_segment_clicks(segmentation, clicks, n, NULL, statuses), TS_OK);
  for (i = 0; i < n; ++i) CHECK_STATUS(statuses[i], TS_OK);
  CHECK(tooth_count(segmentation) == groups);
  CHECK(click_count(segmentation) == n);
  CHECK_STATUS(ts_propose_clicks(segmentation, clicks, n, &n), TS_OK);
  CHECK(n == 0);
  free(statuses);
  free(clicks);
  ts_segmentation_destroy(segmentation);
}

/* A click on a crown takes that tooth and one beside it. */
static void a_click_separates_a_pair(void) {
  ts_segmentation *segmentation = fresh();
  uint32_t label, groups = 0, targets[64], distinct = 0;
  ts_feature_group *all;
  REQUIRE_STATUS(ts_features_get_groups(s.features, NULL, 0, &groups), TS_OK);
  all = must_have(sizeof *all * groups);
  REQUIRE_STATUS(ts_features_get_groups(s.features, all, groups, &groups), TS_OK);
  for (label = 1; label <= s.arch.teeth; ++label) {
    double centre[3], above[3];
    static const double down[3] = {0, 0, -1};
    ts_surface_point on;
    ts_click_info info;
    ts_tooth_info tooth;
    uint32_t number = 77, i;
    int beside = 0;
    label_centre(&s.arch, label, centre);
    memcpy(above, centre, sizeof above);
    above[2] += 50;
    harness_case("label %lu", (unsigned long)label);
    REQUIRE_STATUS(ts_model_raycast(s.model, above, down, &on), TS_OK);
    REQUIRE_STATUS(ts_segment_click(segmentation, on.position, NULL, &number), TS_OK);
    CHECK(number == label - 1);
    info = click_info(segmentation, number);
    CHECK(info.target != info.neighbour);
    for (i = 0; i < groups; ++i)
      if (all[i].id == info.target) beside = all[i].previous == info.neighbour || all[i].next == info.neighbour;
    CHECK(beside);
    CHECK_NEAR(info.position[0], on.position[0], 1e-6);
    CHECK(info.target_distance <= info.neighbour_distance);
    CHECK(info.v_med > 0 && info.v_med < 1);
    CHECK(info.target_iso > 0 && info.target_iso < 1);
    CHECK(info.ms.total >= 0);
    memset(&tooth, 0, sizeof tooth);
    tooth.struct_size = sizeof tooth;
    REQUIRE_STATUS(ts_get_tooth(segmentation, info.target, &tooth), TS_OK);
    CHECK(tooth.click == number && tooth.id == info.target);
    for (i = 0; i < distinct && targets[i] != info.target; ++i) {
    }
    if (i == distinct && distinct < 64) targets[distinct++] = info.target;
  }
  harness_case(NULL);
  CHECK(distinct + 1 >= groups); /* clicks on all teeth hit all groups, but for one that may be amiss */
  CHECK(tooth_count(segmentation) == groups);
  free(all);
  ts_segmentation_destroy(segmentation);
}

static void clicks_that_fail_leave_no_trace(void) {
  ts_segmentation *segmentation = fresh();
  uint32_t n = 0, number = 77;
  double *clicks = proposed_clicks(segmentation, &n), gingiva[3], bad[3] = {0, 0, 0};
  bytes before, after;
  REQUIRE_STATUS(ts_segment_click(segmentation, clicks, NULL, NULL), TS_OK);
  before = dump_segmentation(segmentation);
  low_on_the_gingiva(gingiva);
  CHECK_STATUS(ts_segment_click(segmentation, far_away, NULL, &number), TS_E_CLICK_OFF_SURFACE);
  CHECK_STATUS(ts_segment_click(segmentation, gingiva, NULL, &number), TS_E_CLICK_ON_GINGIVA);
  bad[1] = (double)NAN;
  CHECK_STATUS(ts_segment_click(segmentation, bad, NULL, &number), TS_E_INVALID_ARGUMENT);
  bad[1] = (double)INFINITY;
  CHECK_STATUS(ts_segment_click(segmentation, bad, NULL, &number), TS_E_INVALID_ARGUMENT);
  CHECK(number == 77);
  after = dump_segmentation(segmentation);
  CHECK(same_bytes(&before, &after));
  free_bytes(&after);
  free_bytes(&before);
  free(clicks);
  ts_segmentation_destroy(segmentation);
}

static void reach_of_a_click(void) {
  ts_segmentation *segmentation = fresh();
  uint32_t n = 0;
  double *clicks = proposed_clicks(segmentation, &n);
  ts_surface_point on;
  REQUIRE_STATUS(ts_model_nearest(s.model, clicks, &on), TS_OK);
  CHECK(on.distance < 1e-6); /* what is proposed lies on the surface */
  clicks[2] += 1.5;          /* +z leads away from the crown */
  CHECK_STATUS(ts_segment_click(segmentation, clicks, NULL, NULL), TS_OK);
  clicks[2] += 3;
  CHECK_STATUS(ts_segment_click(segmentation, clicks, NULL, NULL), TS_E_CLICK_OFF_SURFACE);
  free(clicks);
  ts_segmentation_destroy(segmentation);
}

/* --------------------------------------------------------------------------------------------------------- together */

/* At once or one by one, with failing ones between and one twice: the same bytes. */
static void together_is_one_after_the_other(void) {
  ts_segmentation *one = fresh(), *all = fresh();
  uint32_t n = 0, count, i, stood = 0;
  double *proposed = proposed_clicks(one, &n), *clicks;
  ts_status *statuses;
  bytes a, b;
  count = n + 3;
  clicks = must_have(3 * sizeof *clicks * count);
  memcpy(clicks, proposed, 3 * sizeof *clicks * n);
  memcpy(clicks + 3 * (size_t)n, clicks + 3, 3 * sizeof *clicks); /* the second again, at the end */
  memcpy(clicks + 3 * (size_t)(n + 1), clicks + 3, 3 * sizeof *clicks);
  memcpy(clicks + 3, far_away, sizeof far_away);
  low_on_the_gingiva(clicks + 3 * (size_t)(n + 2));
  statuses = must_have(sizeof *statuses * count);
  REQUIRE_STATUS(ts_segment_clicks(all, clicks, count, NULL, statuses), TS_OK);
  for (i = 0; i < count; ++i) {
    uint32_t number = 77;
    const ts_status status = ts_segment_click(one, clicks + 3 * (size_t)i, NULL, &number);
    harness_case("click %lu", (unsigned long)i);
    CHECK_STATUS(statuses[i], status);
    if (status == TS_OK) CHECK(number == stood++);
  }
  harness_case(NULL);
  CHECK_STATUS(statuses[1], TS_E_CLICK_OFF_SURFACE);
  CHECK_STATUS(statuses[count - 1], TS_E_CLICK_ON_GINGIVA);
  CHECK(stood == n + 1);
  a = dump_segmentation(one);
  b = dump_segmentation(all);
  CHECK(same_bytes(&a, &b));
  CHECK(a.size > 1000);
  free_bytes(&a);
  free_bytes(&b);
  free(statuses);
  free(clicks);
  free(proposed);
  ts_segmentation_destroy(one);
  ts_segmentation_destroy(all);
}

static void batches_of_nothing_and_of_nonsense(void) {
  ts_segmentation *segmentation = fresh();
  double clicks[6] = {0, 0, 0, 0, 0, 0};
  ts_status statuses[2] = {TS_OK, TS_OK};
  memcpy(clicks, far_away, sizeof far_away);
  clicks[3] = (double)NAN;
  CHECK_STATUS(ts_segment_clicks(segmentation, NULL, 0, NULL, NULL), TS_OK);
  CHECK_STATUS(ts_segment_clicks(segmentation, clicks, 2, NULL, statuses), TS_E_INVALID_ARGUMENT);
  CHECK(statuses[0] == TS_OK && statuses[1] == TS_OK); /* untouched */
  memcpy(clicks + 3, far_away, sizeof far_away);
  CHECK_STATUS(ts_segment_clicks(segmentation, clicks, 2, NULL, NULL), TS_OK);
  CHECK_STATUS(ts_segment_clicks(segmentation, clicks, 2, NULL, statuses), TS_OK);
  CHECK(statuses[0] == TS_E_CLICK_OFF_SURFACE && statuses[1] == TS_E_CLICK_OFF_SURFACE);
  CHECK(click_count(segmentation) == 0 && tooth_count(segmentation) == 0);
  ts_segmentation_destroy(segmentation);
}

/* --------------------------------------------------------------------------------------------------------- options */

static void option_defaults_are_those_of_the_header(void) {
  ts_segment_options d, p;
  REQUIRE_STATUS(ts_segment_options_init(&d, sizeof d, TS_PRESET_DEFAULT), TS_OK);
  REQUIRE_STATUS(ts_segment_options_init(&p, sizeof p, TS_PRESET_PAPER), TS_OK);
  CHECK_STATUS(ts_segment_options_init(&p, sizeof p, (ts_preset)2), TS_E_INVALID_ARGUMENT);
  CHECK(d.preset == TS_PRESET_DEFAULT && p.preset == TS_PRESET_PAPER);
  CHECK(d.weights == TS_WEIGHTS_CONCAVITY && p.weights == TS_WEIGHTS_PAPER);
  CHECK(d.background == TS_BACKGROUND_ALL && p.background == TS_BACKGROUND_NEIGHBOUR);
  CHECK(d.cut_rule == TS_CUT_COMPONENT && p.cut_rule == TS_CUT_GRADIENT);
  CHECK(d.contours == 100 && p.contours == 100 && d.histogram_bins == 50 && p.histogram_bins == 50);
  CHECK(d.points_per_group == 0 && p.points_per_group == 0 && d.alpha == 1e8 && p.alpha == 1e8);
  CHECK(d.beta == 1e-3 && p.beta == 0.01 && d.gamma == 1e-4 && p.gamma == 1e-4 && d.theta == 0.2 && p.theta == 0.001);
  CHECK(d.c0 == 0.07 && d.normal_radius == 0.15 && d.seed_radius == 0.7 && p.seed_radius == 0);
  CHECK(d.gingiva_distance == 13 && d.area_min == 25 && d.area_max == 330 && d.hole_area == 40 && p.hole_area == 0);
  CHECK(d.refine_band == 2.5 && p.refine_band == 0 && d.smooth_radius == 0.2 && p.smooth_radius == 0);
  CHECK(d.click_reach == 2 && p.click_reach == 2 && d.click_concavity == 60 && p.click_concavity == 0);
  CHECK(d.reject_outliers == 1 && p.reject_outliers == 0);
}

static void refuse(const ts_segment_options *o, const char *what) {
  ts_segmentation *out = NULL;
  harness_case("%s", what);
  CHECK_STATUS(ts_segmentation_create(s.features, o, NULL, &out), TS_E_INVALID_ARGUMENT);
  CHECK(out == NULL);
}

static void options_out_of_range_are_refused(void) {
  ts_segment_options good, o;
  REQUIRE_STATUS(ts_segment_options_init(&good, sizeof good, TS_PRESET_DEFAULT), TS_OK);
#define REFUSE(member, value) \
  o = good;                   \
  o.member = value;           \
  refuse(&o, #member " = " #value)
  REFUSE(preset, (ts_preset)2);
  REFUSE(weights, (ts_weights)5);
  REFUSE(background, (ts_background)3);
  REFUSE(cut_rule, (ts_cut_rule)3);
  REFUSE(contours, 0);
  REFUSE(contours, UINT32_MAX);
  REFUSE(histogram_bins, 0);
  REFUSE(histogram_bins, UINT32_MAX);
  REFUSE(alpha, -1);
  REFUSE(alpha, (double)NAN);
  REFUSE(beta, 0);
  REFUSE(beta, -1);
  REFUSE(beta, (double)NAN);
  REFUSE(gamma, -1);
  REFUSE(gamma, (double)NAN);
  REFUSE(theta, (double)NAN);
  REFUSE(c0, 0);
  REFUSE(c0, (double)NAN);
  REFUSE(normal_radius, -1);
  REFUSE(normal_radius, (double)NAN);
  REFUSE(seed_radius, -1);
  REFUSE(seed_radius, (double)NAN);
  REFUSE(gingiva_distance, -1);
  REFUSE(gingiva_distance, (double)NAN);
  REFUSE(area_min, -1);
  REFUSE(area_min, 331);
  REFUSE(area_max, (double)NAN);
  REFUSE(hole_area, -1);
  REFUSE(refine_band, -1);
  REFUSE(refine_band, (double)NAN);
  REFUSE(smooth_radius, -1);
  REFUSE(smooth_radius, (double)NAN);
  REFUSE(click_reach, -1);
  REFUSE(click_reach, (double)NAN);
  REFUSE(click_concavity, -1);
  REFUSE(click_concavity, (double)NAN);
  REFUSE(reject_outliers, 2);
}

/* Every weighting, background and cut rule does its work on a clean arch: the first click gives two teeth, or says
 * that no cut separates them. With the other weights the latter is what the paper's Fig. 10 is about. */
static void every_variant_runs(void) {
  int weights, background, rule;
  uint32_t n = 0, good = 0;
  double *clicks = proposed_clicks(s.segmentation, &n);
  for (weights = 0; weights < 5; ++weights)
    for (background = 0; background < 3; ++background)
      for (rule = 0; rule < 3; ++rule) {
        ts_segment_options o;
        ts_segmentation *segmentation = NULL;
        ts_status status;
        harness_case("weights %d, background %d, rule %d", weights, background, rule);
        REQUIRE_STATUS(ts_segment_options_init(&o, sizeof o, TS_PRESET_DEFAULT), TS_OK);
        o.weights = (ts_weights)weights;
        o.background = (ts_background)background;
        o.cut_rule = (ts_cut_rule)rule;
        REQUIRE_STATUS(ts_segmentation_create(s.features, &o, NULL, &segmentation), TS_OK);
        status = ts_segment_click(segmentation, clicks, NULL, NULL);
        CHECK(status == TS_OK || status == TS_E_NO_CUT);
        CHECK(tooth_count(segmentation) == (status == TS_OK ? 2u : 0u));
        good += status == TS_OK;
        ts_segmentation_destroy(segmentation);
      }
  harness_case(NULL);
  CHECK(good >= 18);
  free(clicks);
}

static void paper_preset_runs(void) {
  ts_segment_options o;
  ts_segmentation *segmentation = NULL;
  uint32_t n = 0, i, good = 0;
  double *clicks = proposed_clicks(s.segmentation, &n);
  REQUIRE_STATUS(ts_segment_options_init(&o, sizeof o, TS_PRESET_PAPER), TS_OK);
  REQUIRE_STATUS(ts_segmentation_create(s.features, &o, NULL, &segmentation), TS_OK);
  for (i = 0; i < n; ++i) good += ts_segment_click(segmentation, clicks + 3 * (size_t)i, NULL, NULL) == TS_OK;
  CHECK(good > n / 2);
  CHECK(click_count(segmentation) == good);
  ts_segmentation_destroy(segmentation);
  free(clicks);
}

/* alpha: the penalty of Eq. 6 comes close to exact constraints, which 0 stands for. */
static void exact_constraints(void) {
  ts_segment_options o;
  ts_segmentation *exact = NULL, *penalty = fresh();
  uint32_t n = 0, count = 0, i;
  double *clicks = proposed_clicks(s.segmentation, &n), *u, *v, most = 0;
  REQUIRE_STATUS(ts_segment_options_init(&o, sizeof o, TS_PRESET_DEFAULT), TS_OK);
  o.alpha = 0;
  REQUIRE_STATUS(ts_segmentation_create(s.features, &o, NULL, &exact), TS_OK);
  REQUIRE_STATUS(ts_segment_click(exact, clicks, NULL, NULL), TS_OK);
  REQUIRE_STATUS(ts_segment_click(penalty, clicks, NULL, NULL), TS_OK);
  REQUIRE_STATUS(ts_get_field(exact, 0, NULL, 0, &count), TS_OK);
  u = must_have(sizeof *u * count);
  v = must_have(sizeof *v * count);
  REQUIRE_STATUS(ts_get_field(exact, 0, u, count, &count), TS_OK);
  REQUIRE_STATUS(ts_get_field(penalty, 0, v, count, &count), TS_OK);
  for (i = 0; i < count; ++i)
    if (fabs(u[i] - v[i]) > most) most = fabs(u[i] - v[i]);
  CHECK(most < 1e-5);
  free(u);
  free(v);
  free(clicks);
  ts_segmentation_destroy(exact);
  ts_segmentation_destroy(penalty);
}

/* --------------------------------------------------------------------------------------------------------- by hand */

static void one_group_has_no_neighbour(void) {
  ts_features *features = NULL;
  ts_segmentation *segmentation = NULL;
  static ts_feature_point points[512];
  uint32_t n = 0, i, group = TS_NONE, teeth = 0, id = 0;
  ts_click_info info;
  ts_tooth_info tooth;
  REQUIRE_STATUS(ts_features_get_points(s.features, points, 512, &n), TS_OK);
  REQUIRE_STATUS(ts_features_create(s.model, &features), TS_OK);
  for (i = 0; i < n && points[i].group == points[0].group; ++i)
    REQUIRE_STATUS(ts_features_add_point(features, points[i].position, group, NULL, &group), TS_OK);
  REQUIRE_STATUS(ts_segmentation_create(features, NULL, NULL, &segmentation), TS_OK);
  REQUIRE_STATUS(ts_segment_click(segmentation, points[0].position, NULL, NULL), TS_OK);
  info = click_info(segmentation, 0);
  CHECK(info.target == group && info.neighbour == TS_NONE);
  CHECK(info.neighbour_iso != info.neighbour_iso);
  REQUIRE_STATUS(ts_get_teeth(segmentation, &id, 1, &teeth), TS_OK);
  CHECK(teeth == 1 && id == group);
  memset(&tooth, 0, sizeof tooth);
  tooth.struct_size = sizeof tooth;
  REQUIRE_STATUS(ts_get_tooth(segmentation, id, &tooth), TS_OK);
  CHECK(tooth.warnings & TS_WARN_NO_NEIGHBOUR);
  CHECK(tooth.faces > 0 && tooth.faces < s.arch.faces / 4);
  ts_segmentation_destroy(segmentation);
  ts_features_destroy(features);
}

int main(void) {
  s = make_scan(20000, 1);
  RUN(proposed_clicks_cover_every_group);
  RUN(a_click_separates_a_pair);
  RUN(clicks_that_fail_leave_no_trace);
  RUN(reach_of_a_click);
  RUN(together_is_one_after_the_other);
  RUN(batches_of_nothing_and_of_nonsense);
  RUN(option_defaults_are_those_of_the_header);
  RUN(options_out_of_range_are_refused);
  RUN(every_variant_runs);
  RUN(paper_preset_runs);
  RUN(exact_constraints);
  RUN(one_group_has_no_neighbour);
  free_scan(&s);
  return harness_finish();
}
