/* Numbers of teeth: on an arch, set by hand, refused. SPDX-License-Identifier: Apache-2.0 */
#include <stdlib.h>
#include <string.h>

#include "fixture.h"
#include "harness.h"

enum { TEETH = 14, MOST = 32 };

/* The upper arch of the fixture has all teeth but the third molars; its label k is the k-th from the patient's right.
 */
static const uint32_t fdi_of_label[TEETH] = {17, 16, 15, 14, 13, 12, 11, 21, 22, 23, 24, 25, 26, 27};

static scan s;
static ts_feature_group groups[MOST];
static uint32_t count;

static ts_segmentation *fresh(void) {
  ts_segmentation *out = NULL;
  CHECK_STATUS(ts_segmentation_create(s.features, NULL, NULL, &out), TS_OK);
  return out;
}

static ts_number_info number_of(const ts_segmentation *segmentation, uint32_t tooth) {
  ts_number_info info;
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  CHECK_STATUS(ts_get_number(segmentation, tooth, &info), TS_OK);
  return info;
}

static ts_jaw_info jaw_of(const ts_segmentation *segmentation) {
  ts_jaw_info info;
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  CHECK_STATUS(ts_get_jaw(segmentation, &info), TS_OK);
  return info;
}

/* The number that the tooth under the group's first point has in truth. */
static uint32_t true_number(uint32_t group) {
  ts_feature_point points[8 * MOST];
  ts_surface_point on;
  uint32_t i, n = 0, label;
  CHECK_STATUS(ts_features_get_points(s.features, points, 8 * MOST, &n), TS_OK);
  for (i = 0; i + 1 < n && points[i].group != group; ++i) continue;
  CHECK_STATUS(ts_model_nearest(s.model, points[i].position, &on), TS_OK);
  label = s.arch.labels[on.face];
  return label > 0 ? fdi_of_label[label - 1] : 0;
}

static bytes dump(const ts_segmentation *segmentation) {
  bytes b = {NULL, 0, 0};
  const ts_jaw_info jaw = jaw_of(segmentation);
  uint32_t i;
  put_bytes(&b, &jaw, sizeof jaw);
  for (i = 0; i < count; ++i) {
    const ts_number_info n = number_of(segmentation, groups[i].id);
    put_bytes(&b, &n, sizeof n);
  }
  return b;
}

static void an_arch_gets_its_numbers(void) {
  ts_segmentation *segmentation = fresh();
  ts_number_options o;
  ts_number_info info;
  ts_jaw_info jaw;
  uint32_t i, pass;
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  info.fdi = 5;
  memset(&jaw, 0, sizeof jaw);
  jaw.struct_size = sizeof jaw;
  CHECK_STATUS(ts_get_number(segmentation, groups[0].id, &info), TS_E_NOT_FOUND);
  CHECK_STATUS(ts_get_jaw(segmentation, &jaw), TS_E_NOT_FOUND);
  CHECK(info.fdi == 5);
  CHECK_STATUS(ts_number_options_init(&o, sizeof o), TS_OK);
  CHECK(o.jaw == TS_JAW_UNKNOWN && o.mirrored == 0 && o.least_confidence == 0.9);
  o.jaw = TS_JAW_UPPER;
  for (pass = 0; pass < 2; ++pass) { /* before and after the teeth are separated */
    harness_case("%s", pass ? "separated" : "groups alone");
    REQUIRE_STATUS(ts_assign_numbers(segmentation, &o), TS_OK);
    for (i = 0; i < count; ++i) {
      info = number_of(segmentation, groups[i].id);
      CHECK(info.fdi == true_number(groups[i].id));
      CHECK(!info.set_by_hand);
      CHECK(info.uncertain == (info.confidence < 0.9));
    }
    jaw = jaw_of(segmentation);
    CHECK(jaw.jaw == TS_JAW_UPPER && jaw.given && jaw.confidence == 1 && !jaw.uncertain);
    if (pass == 0) {
      uint32_t n = 0;
      double *clicks = proposed_clicks(segmentation, &n);
      CHECK_STATUS(ts_segment_clicks(segmentation, clicks, n, NULL, NULL), TS_OK);
      free(clicks);
    }
  }
  harness_case(NULL);
  CHECK_STATUS(ts_assign_numbers(segmentation, NULL), TS_OK); /* estimated */
  jaw = jaw_of(segmentation);
  CHECK(jaw.jaw == TS_JAW_UPPER && !jaw.given && jaw.confidence > 0.9 && jaw.confidence < 1);
  o.mirrored = 1;
  CHECK_STATUS(ts_assign_numbers(segmentation, &o), TS_OK);
  for (i = 0; i < count; ++i) {
    const uint32_t n = true_number(groups[i].id);
    CHECK(number_of(segmentation, groups[i].id).fdi == (n < 20 ? n + 10 : n - 10));
  }
  o.least_confidence = 1;
  o.mirrored = 0;
  o.jaw = TS_JAW_UNKNOWN;
  CHECK_STATUS(ts_assign_numbers(segmentation, &o), TS_OK);
  CHECK(jaw_of(segmentation).uncertain != 0);
  ts_segmentation_destroy(segmentation);
}

static void a_number_set_by_hand_leads_the_others(void) {
  ts_segmentation *segmentation = fresh();
  uint32_t i;
  CHECK_STATUS(ts_set_number(segmentation, groups[0].id, true_number(groups[0].id)), TS_OK);
  for (i = 0; i < count; ++i) {
    const ts_number_info n = number_of(segmentation, groups[i].id);
    CHECK(n.fdi == true_number(groups[i].id));
    CHECK(n.set_by_hand == (i == 0));
  }
  CHECK(number_of(segmentation, groups[0].id).confidence == 1);
  CHECK(jaw_of(segmentation).given != 0);
  /* The other jaw, as the only number set: the whole arch is then the other jaw's, the other way round. */
  CHECK_STATUS(ts_set_number(segmentation, groups[0].id, true_number(groups[0].id) < 20 ? 37 : 47), TS_OK);
  CHECK(jaw_of(segmentation).jaw == TS_JAW_LOWER);
  for (i = 0; i < count; ++i) CHECK(number_of(segmentation, groups[i].id).fdi > 30);
  CHECK_STATUS(ts_set_number(segmentation, groups[0].id, 0), TS_OK);
  CHECK(!jaw_of(segmentation).given);
  ts_segmentation_destroy(segmentation);
}

static void what_is_refused_changes_nothing(void) {
  ts_segmentation *segmentation = fresh();
  const uint32_t last = count - 1;
  uint32_t i;
  ts_number_options o;
  bytes before, after;
  CHECK_STATUS(ts_number_options_init(&o, sizeof o), TS_OK);
  o.jaw = TS_JAW_UPPER;
  REQUIRE_STATUS(ts_assign_numbers(segmentation, &o), TS_OK);
  REQUIRE_STATUS(ts_set_number(segmentation, groups[3].id, true_number(groups[3].id)), TS_OK);
  before = dump(segmentation);
#define REFUSED(call, status)                    \
  do {                                           \
    CHECK_STATUS(call, status);                  \
    CHECK(strlen(ts_last_error_message()) > 20); \
    after = dump(segmentation);                  \
    CHECK(same_bytes(&before, &after));          \
    free_bytes(&after);                          \
  } while (0)
  REFUSED(ts_set_number(segmentation, groups[2].id, true_number(groups[3].id)), TS_E_NUMBER_TAKEN);
  REFUSED(ts_set_number(segmentation, groups[2].id, 36), TS_E_NUMBER_JAW);
  REFUSED(ts_set_number(segmentation, groups[2].id, 0), TS_E_NOT_FOUND);
  REFUSED(ts_set_number(segmentation, groups[2].id, 99), TS_E_INVALID_ARGUMENT);
  REFUSED(ts_set_number(segmentation, groups[2].id, 51), TS_E_INVALID_ARGUMENT);
  REFUSED(ts_set_number(segmentation, groups[2].id, true_number(groups[4].id)), TS_E_NUMBER_ORDER);
  REFUSED(ts_set_number(segmentation, groups[last].id, true_number(groups[5].id)), TS_E_NUMBER_ORDER);
  REFUSED(ts_set_number(segmentation, 4711, 11), TS_E_NOT_FOUND);
  REFUSED(ts_set_number(segmentation, TS_NONE, 11), TS_E_NOT_FOUND);
  o.jaw = TS_JAW_LOWER;
  REFUSED(ts_assign_numbers(segmentation, &o), TS_E_NUMBER_JAW);
  o.jaw = (ts_jaw)3;
  REFUSED(ts_assign_numbers(segmentation, &o), TS_E_INVALID_ARGUMENT);
  o.jaw = TS_JAW_UPPER;
  o.mirrored = 2;
  REFUSED(ts_assign_numbers(segmentation, &o), TS_E_INVALID_ARGUMENT);
  o.mirrored = 0;
  o.least_confidence = 1.5;
  REFUSED(ts_assign_numbers(segmentation, &o), TS_E_INVALID_ARGUMENT);
  o.least_confidence = -1;
  REFUSED(ts_assign_numbers(segmentation, &o), TS_E_INVALID_ARGUMENT);
  free_bytes(&before);
  /* A set that was taken can be given once it is forgotten. */
  CHECK_STATUS(ts_set_number(segmentation, groups[3].id, 0), TS_OK);
  for (i = 0; i < count; ++i) CHECK(!number_of(segmentation, groups[i].id).set_by_hand);
  ts_segmentation_destroy(segmentation);
}

/* 20 teeth: points by hand between those that were found. */
static void more_teeth_than_a_jaw_has(void) {
  ts_features *many = NULL;
  ts_segmentation *segmentation = NULL;
  ts_feature_point points[8 * MOST];
  uint32_t n = 0, i, added = 0;
  ts_jaw_info jaw;
  REQUIRE_STATUS(ts_features_clone(s.features, &many), TS_OK);
  REQUIRE_STATUS(ts_features_get_points(many, points, 8 * MOST, &n), TS_OK);
  for (i = 1; i < n && added < 6; ++i)
    if (points[i].group == points[i - 1].group) {
      CHECK_STATUS(ts_features_set_group(many, points[i].id, TS_NONE, NULL), TS_OK);
      ++added;
    }
  REQUIRE_STATUS(ts_segmentation_create(many, NULL, NULL, &segmentation), TS_OK);
  CHECK_STATUS(ts_assign_numbers(segmentation, NULL), TS_E_TOO_MANY_TEETH);
  CHECK(strstr(ts_last_error_message(), "16") != NULL);
  CHECK_STATUS(ts_set_number(segmentation, groups[0].id, 11), TS_E_TOO_MANY_TEETH);
  jaw.struct_size = sizeof jaw;
  CHECK_STATUS(ts_get_jaw(segmentation, &jaw), TS_E_NOT_FOUND);
  ts_segmentation_destroy(segmentation);
  ts_features_destroy(many);
}

/* A tooth that a step made has a number while it is there. */
static void numbers_of_teeth_that_steps_make(void) {
  ts_segmentation *segmentation = fresh();
  ts_feature_point points[8 * MOST];
  ts_number_info info;
  const double *keep = NULL, *part = NULL;
  uint32_t n = 0, i, second = TS_NONE;
  const uint32_t molar = groups[1].id;
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  REQUIRE_STATUS(ts_features_get_points(s.features, points, 8 * MOST, &n), TS_OK);
  for (i = 0; i < n; ++i)
    if (points[i].group == molar) {
      if (keep == NULL) keep = points[i].position;
      part = points[i].position;
    }
  REQUIRE(keep != NULL && part != keep);
  REQUIRE_STATUS(ts_segment_click(segmentation, keep, NULL, NULL), TS_OK);
  REQUIRE_STATUS(ts_assign_numbers(segmentation, NULL), TS_OK);
  REQUIRE_STATUS(ts_tooth_split(segmentation, molar, keep, part, NULL, &second), TS_OK);
  CHECK_STATUS(ts_get_number(segmentation, second, &info), TS_E_NOT_FOUND); /* not assigned yet */
  CHECK_STATUS(ts_assign_numbers(segmentation, NULL), TS_OK);
  CHECK(number_of(segmentation, second).fdi != number_of(segmentation, molar).fdi);
  CHECK_STATUS(ts_undo(segmentation), TS_OK);
  CHECK_STATUS(ts_get_number(segmentation, second, &info), TS_E_NOT_FOUND); /* not there any more */
  CHECK(number_of(segmentation, molar).fdi != 0);
  ts_segmentation_destroy(segmentation);
}

static void features_without_an_occlusal_direction(void) {
  ts_features *by_hand = NULL;
  ts_segmentation *segmentation = NULL;
  uint32_t i;
  REQUIRE_STATUS(ts_features_create(s.model, &by_hand), TS_OK);
  for (i = 0; i < 3; ++i) CHECK_STATUS(ts_features_add_point(by_hand, groups[i].centre, TS_NONE, NULL, NULL), TS_OK);
  REQUIRE_STATUS(ts_segmentation_create(by_hand, NULL, NULL, &segmentation), TS_OK);
  CHECK_STATUS(ts_assign_numbers(segmentation, NULL), TS_E_INVALID_ARGUMENT);
  CHECK(strstr(ts_last_error_message(), "occlusal") != NULL);
  ts_segmentation_destroy(segmentation);
  ts_features_destroy(by_hand);
}

/* Of a mesh a thousand kilometres wide, which is not looked at by the millimetre. */
static void an_arch_longer_than_any(void) {
  const double side = 9e8, up[3] = {0, 0, 1};
  mesh plane = make_plane(side, 6);
  const ts_mesh_input input = input_of(&plane);
  ts_intake_options options;
  ts_model *model = NULL;
  ts_features *by_hand = NULL;
  ts_segmentation *segmentation = NULL;
  uint32_t i;
  REQUIRE_STATUS(ts_intake_options_init(&options, sizeof options), TS_OK);
  options.unit = TS_UNIT_MM;
  REQUIRE_STATUS(ts_model_create(s.context, &input, &options, NULL, &model), TS_OK);
  REQUIRE_STATUS(ts_features_create(model, &by_hand), TS_OK);
  CHECK_STATUS(ts_features_set_occlusal(by_hand, up), TS_OK);
  for (i = 0; i < 3; ++i) {
    const double at[3] = {side * i / 2, side / 2, 0};
    CHECK_STATUS(ts_features_add_point(by_hand, at, TS_NONE, NULL, NULL), TS_OK);
  }
  REQUIRE_STATUS(ts_segmentation_create(by_hand, NULL, NULL, &segmentation), TS_OK);
  CHECK_STATUS(ts_assign_numbers(segmentation, NULL), TS_E_INVALID_ARGUMENT); /* no arch is that long */
  ts_segmentation_destroy(segmentation);
  ts_features_destroy(by_hand);
  ts_model_destroy(model);
  free_mesh(&plane);
}

static void notations(void) {
  uint32_t u, n, fdi, back = 0;
  for (u = 1; u <= 32; ++u) {
    ts_palmer p;
    memset(&p, 0, sizeof p);
    p.struct_size = sizeof p;
    fdi = 0;
    CHECK_STATUS(ts_universal_to_fdi(u, &fdi), TS_OK);
    CHECK_STATUS(ts_fdi_to_universal(fdi, &back), TS_OK);
    CHECK(back == u);
    CHECK_STATUS(ts_fdi_to_palmer(fdi, &p), TS_OK);
    CHECK(10 * p.quadrant + p.position == fdi);
    CHECK(strlen(p.letters) == 3 && strlen(p.symbol) == 4);
  }
  for (n = 0; n < 120; ++n) {
    const int valid = n / 10 >= 1 && n / 10 <= 4 && n % 10 >= 1 && n % 10 <= 8;
    back = 77;
    CHECK_STATUS(ts_fdi_to_universal(n, &back), valid ? TS_OK : TS_E_INVALID_ARGUMENT);
    CHECK(valid || back == 77);
  }
  CHECK_STATUS(ts_universal_to_fdi(0, &back), TS_E_INVALID_ARGUMENT);
  CHECK_STATUS(ts_universal_to_fdi(33, &back), TS_E_INVALID_ARGUMENT);
}

int main(void) {
  s = make_scan(30000, 2);
  if (CHECK(ts_features_get_groups(s.features, groups, MOST, &count) == TS_OK) && CHECK(count == TEETH)) {
    RUN(an_arch_gets_its_numbers);
    RUN(a_number_set_by_hand_leads_the_others);
    RUN(what_is_refused_changes_nothing);
    RUN(more_teeth_than_a_jaw_has);
    RUN(numbers_of_teeth_that_steps_make);
    RUN(features_without_an_occlusal_direction);
    RUN(an_arch_longer_than_any);
  }
  RUN(notations);
  free_scan(&s);
  return harness_finish();
}
