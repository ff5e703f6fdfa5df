/* Sessions written, read and gone on with; files that are no session. SPDX-License-Identifier: Apache-2.0 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fixture.h"
#include "harness.h"

static scan s;

/* Some steps of every kind, one of them taken back. */
static void do_things(ts_segmentation *segmentation) {
  uint32_t n = 0, teeth[64], i, points = 0, keep = 0, part = 0;
  double to[3];
  static ts_feature_point point[512];
  double *clicks = proposed_clicks(segmentation, &n);
  REQUIRE(n >= 3);
  CHECK_STATUS(ts_segment_click(segmentation, clicks, NULL, NULL), TS_OK);
  CHECK_STATUS(ts_segment_clicks(segmentation, clicks + 3, n - 1, NULL, NULL), TS_OK);
  CHECK_STATUS(ts_get_teeth(segmentation, teeth, 64, &i), TS_OK);
  REQUIRE(i >= 5);
  CHECK_STATUS(ts_tooth_merge(segmentation, teeth[0], teeth[1], NULL), TS_OK);
  REQUIRE_STATUS(ts_features_get_points(s.features, point, 512, &points), TS_OK);
  for (i = 0; i < points; ++i) {
    if (point[i].group == teeth[0]) keep = i;
    if (point[i].group == teeth[1]) part = i;
  }
  CHECK_STATUS(ts_tooth_split(segmentation, teeth[0], point[keep].position, point[part].position, NULL, NULL), TS_OK);
  for (i = 0; i < points; ++i)
    if (point[i].group == teeth[2]) keep = i;
  memcpy(to, point[keep].position, sizeof to);
  to[2] -= 1.5;
  CHECK_STATUS(ts_tooth_move_point(segmentation, teeth[2], point[keep].position, to, NULL), TS_OK);
  CHECK_STATUS(ts_tooth_set_locked(segmentation, teeth[3], 1), TS_OK);
  CHECK_STATUS(ts_tooth_remove(segmentation, teeth[4]), TS_OK);
  CHECK_STATUS(ts_assign_numbers(segmentation, NULL), TS_OK);
  CHECK_STATUS(ts_set_number(segmentation, teeth[0], 17), TS_OK);
  CHECK_STATUS(ts_tooth_remove(segmentation, teeth[5]), TS_OK);
  CHECK_STATUS(ts_undo(segmentation), TS_OK);
  free(clicks);
}

static uint32_t number_of(const ts_segmentation *segmentation, uint32_t tooth) {
  ts_number_info info;
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  CHECK_STATUS(ts_get_number(segmentation, tooth, &info), TS_OK);
  return info.fdi + 100 * info.set_by_hand;
}

static char *text_of(const ts_segmentation *segmentation, uint32_t *size) {
  char *text;
  CHECK_STATUS(ts_session_write(segmentation, NULL, 0, size), TS_OK);
  text = must_have(*size + 1);
  CHECK_STATUS(ts_session_write(segmentation, text, *size, size), TS_OK);
  text[*size] = 0;
  return text;
}

static void a_session_read_goes_on_as_the_one_written(void) {
  ts_segmentation *again = NULL;
  ts_features *features = NULL;
  uint32_t size = 0, size2 = 0, teeth[64], n = 0, by_hand = 0;
  char *text, *text2;
  bytes a, b;
  do_things(s.segmentation);
  text = text_of(s.segmentation, &size);
  /* A small limit: what can no longer be undone is in the file all the same. */
  CHECK_STATUS(ts_set_history_limit(s.segmentation, 1), TS_OK);
  text2 = text_of(s.segmentation, &size2);
  CHECK(size2 == size || strcmp(text, text2) == 0);
  free(text2);
  REQUIRE_STATUS(ts_session_read(s.model, text, size, NULL, &features, &again), TS_OK);
  a = dump_segmentation(s.segmentation);
  b = dump_segmentation(again);
  CHECK(same_bytes(&a, &b));
  free_bytes(&a);
  free_bytes(&b);
  a = dump_features(s.features);
  b = dump_features(features);
  CHECK(same_bytes(&a, &b));
  free_bytes(&a);
  free_bytes(&b);
  CHECK_STATUS(ts_get_teeth(again, teeth, 64, &n), TS_OK);
  while (n-- > 0) {
    by_hand += number_of(again, teeth[n]) == 117;
    CHECK(number_of(again, teeth[n]) == number_of(s.segmentation, teeth[n]));
  }
  CHECK(by_hand == 1);
  text2 = text_of(again, &size2);
  CHECK(size2 == size && memcmp(text, text2, size) == 0);
  free(text2);
  /* The step that was taken back comes again, and both go on alike. */
  CHECK_STATUS(ts_redo(s.segmentation), TS_OK);
  CHECK_STATUS(ts_redo(again), TS_OK);
  CHECK_STATUS(ts_segment_all(s.segmentation, NULL), TS_OK);
  CHECK_STATUS(ts_segment_all(again, NULL), TS_OK);
  CHECK_STATUS(ts_get_teeth(again, teeth, 64, &n), TS_OK);
  CHECK_STATUS(ts_tooth_merge(s.segmentation, teeth[5], teeth[6], NULL), TS_OK);
  CHECK_STATUS(ts_tooth_merge(again, teeth[5], teeth[6], NULL), TS_OK);
  a = dump_segmentation(s.segmentation);
  b = dump_segmentation(again);
  CHECK(same_bytes(&a, &b));
  free_bytes(&a);
  free_bytes(&b);
  while (ts_undo(again) == TS_OK) continue;
  CHECK_STATUS(ts_get_teeth(again, NULL, 0, &n), TS_OK);
  CHECK(n == 0);
  free(text);
  ts_segmentation_destroy(again);
  ts_features_destroy(features);
}

static void files_are_whole_or_not_there(void) {
  const char *path = "session_test.json";
  ts_segmentation *again = NULL;
  bytes a, b;
  FILE *file;
  CHECK_STATUS(ts_session_save(s.segmentation, path), TS_OK);
  REQUIRE_STATUS(ts_session_load(s.model, path, NULL, NULL, &again), TS_OK);
  a = dump_teeth(s.segmentation);
  b = dump_teeth(again);
  CHECK(same_bytes(&a, &b));
  free_bytes(&a);
  free_bytes(&b);
  ts_segmentation_destroy(again);
  again = NULL;
  remove(path);
  CHECK_STATUS(ts_session_load(s.model, path, NULL, NULL, &again), TS_E_FILE_OPEN);
  CHECK(again == NULL);
  CHECK_STATUS(ts_session_save(s.segmentation, "no/such/folder/session.json"), TS_E_FILE_WRITE);
  CHECK_STATUS(ts_session_save(s.segmentation, "."), TS_E_FILE_WRITE);
  file = fopen("/dev/full", "w");
  if (file) {
    fclose(file);
    CHECK_STATUS(ts_session_save(s.segmentation, "/dev/full"), TS_E_FILE_WRITE);
  }
}

/* `text` with the first `from` in it as `to`. */
static char *altered(const char *text, const char *from, const char *to) {
  const char *at = strstr(text, from);
  const size_t rest = strlen(text) + 1, middle = strlen(to);
  char *out = must_have(rest + middle);
  size_t before;
  if (!CHECK(at != NULL)) at = text, from = "";
  before = (size_t)(at - text);
  memcpy(out, text, before);
  memcpy(out + before, to, middle);
  memcpy(out + before + middle, at + strlen(from), rest - before - strlen(from));
  return out;
}

static void what_is_no_session_is_refused(void) {
  static const struct {
    const char *from, *to;
    ts_status status;
  } cases[] = {
      {"\"toothseg_session\": 1", "\"toothseg_session\": 2", TS_E_FILE_NEWER},
      {"\"toothseg_session\": 1", "\"toothseg_session\": 0", TS_E_FILE_FORMAT},
      {"\"toothseg_session\": 1", "\"toothseg_session\": \"1\"", TS_E_FILE_SYNTAX},
      {"\"toothseg_session\"", "\"something_else\"", TS_E_FILE_FORMAT},
      {"\"mesh\": \"", "\"mesh\": \"x", TS_E_FILE_SYNTAX},
      {"\"labels\": \"", "\"labels\": 7, \"was\": \"", TS_E_FILE_SYNTAX},
      {"\"act\": \"merge\"", "\"act\": \"explode\"", TS_E_FILE_SYNTAX},
      {"\"act\": \"remove\"", "\"act\": \"split\"", TS_E_FILE_SYNTAX},
      {"\"act\": \"merge\"", "\"act\": \"lock\"", TS_E_MISMATCH},
      {"\"number\": 17", "\"number\": 99", TS_E_FILE_SYNTAX},
      {"\"jaw\": \"unknown\"", "\"jaw\": \"both\"", TS_E_FILE_SYNTAX},
      {"\"tooth\": ", "\"tooth\": 40000", TS_E_MISMATCH},
      {"\"tooth\": ", "\"tooth\": -1, \"was\": ", TS_E_FILE_SYNTAX},
      {"\"vertex\": ", "\"vertex\": 4000000", TS_E_FILE_SYNTAX},
      {"\"vertex\": ", "\"vertex\": 1e300, \"was\": ", TS_E_FILE_SYNTAX},
      {"\"convexity\": ", "\"convexity\": 1e999, \"was\": ", TS_E_FILE_SYNTAX},
      {"\"convexity\": ", "\"convexity\": null, \"was\": ", TS_E_FILE_SYNTAX},
      {"\"alpha\"", "\"alpho\"", TS_E_FILE_SYNTAX},
      {"\"area_max\": 3", "\"area_max\": -3", TS_E_FILE_SYNTAX},
      {"\"undone\": 1", "\"undone\": 100", TS_E_FILE_SYNTAX},
      {"\"undone\": 1", "\"undone\": 0", TS_E_MISMATCH},
      {"\"id\": 1,", "\"id\": 0,", TS_E_FILE_SYNTAX},
      {"\"confidence\": ", "\"confidence\": 7", TS_E_FILE_SYNTAX},
      {"\"id\": 1,\n    \"group\"", "\"id\": 0,\n    \"group\"", TS_E_FILE_SYNTAX},
      {"\"arch\": [", "\"arch\": [7, ", TS_E_FILE_SYNTAX},
  };
  ts_segmentation *out = NULL, *fresh = NULL;
  ts_features *features = NULL;
  uint32_t size = 0, i;
  char *text, *other, *deep;
  mesh sphere = make_sphere(8, 40);
  ts_model *model = make_model(s.context, &sphere);
  REQUIRE_STATUS(ts_segmentation_create(s.features, NULL, NULL, &fresh), TS_OK);
  do_things(fresh);
  text = text_of(fresh, &size);
  CHECK_STATUS(ts_session_read(model, text, size, NULL, &features, &out), TS_E_MISMATCH);
  for (i = 0; i < sizeof cases / sizeof *cases; ++i) {
    harness_case("%s -> %s", cases[i].from, cases[i].to);
    other = altered(text, cases[i].from, cases[i].to);
    CHECK_STATUS(ts_session_read(s.model, other, strlen(other), NULL, &features, &out), cases[i].status);
    free(other);
  }
  for (i = 0; i < size; i += size / 61) {
    harness_case("cut off at %u", i);
    CHECK_STATUS(ts_session_read(s.model, text, i, NULL, &features, &out), TS_E_FILE_TRUNCATED);
  }
  harness_case(NULL);
  CHECK_STATUS(ts_session_read(s.model, "[]", 2, NULL, &features, &out), TS_E_FILE_FORMAT);
  CHECK_STATUS(ts_session_read(s.model, "solid x", 7, NULL, &features, &out), TS_E_FILE_SYNTAX);
  deep = must_have(1000001);
  memset(deep, '[', 1000000);
  deep[1000000] = 0;
  CHECK_STATUS(ts_session_read(s.model, deep, 10, NULL, &features, &out), TS_E_FILE_TRUNCATED);
  /* Deeper than any session: refused before its end is looked for. */
  CHECK_STATUS(ts_session_read(s.model, deep, 1000000, NULL, &features, &out), TS_E_FILE_SYNTAX);
  CHECK(out == NULL && features == NULL);
  free(deep);
  free(text);
  ts_segmentation_destroy(fresh);
  ts_model_destroy(model);
  free_mesh(&sphere);
}

int main(void) {
  s = make_scan(20000, 2);
  RUN(a_session_read_goes_on_as_the_one_written);
  RUN(files_are_whole_or_not_there);
  RUN(what_is_no_session_is_refused);
  free_scan(&s);
  return harness_finish();
}
