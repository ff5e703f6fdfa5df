/* The locale of the host, whose decimal point may be a comma, changes no file and no reading.
 * SPDX-License-Identifier: Apache-2.0 */
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fixture.h"
#include "harness.h"

#if !defined(COMMA_LOCALE)
#define COMMA_LOCALE "comma" /* made by CMakeLists.txt */
#endif

static scan s;
static const char *const names[] = {"locale.stl", "locale.ply", "locale.obj", "locale.glb", "locale.json"};
static const ts_output_format formats[] = {TS_OUTPUT_STL, TS_OUTPUT_PLY, TS_OUTPUT_OBJ, TS_OUTPUT_GLB};
enum { FILES = 5, MESHES = 4 };

static bytes content_of(const char *path) {
  bytes all = {NULL, 0, 0};
  unsigned char part[4096];
  size_t n;
  FILE *file = fopen(path, "rb");
  if (!CHECK(file != NULL)) return all;
  while ((n = fread(part, 1, sizeof part, file)) > 0) put_bytes(&all, part, n);
  fclose(file);
  return all;
}

static void write_all(bytes files[FILES]) {
  int i;
  for (i = 0; i < MESHES; ++i)
    CHECK_STATUS(ts_segmentation_save(s.segmentation, names[i], formats[i], NULL, NULL), TS_OK);
  CHECK_STATUS(ts_session_save(s.segmentation, names[MESHES]), TS_OK);
  for (i = 0; i < FILES; ++i) files[i] = content_of(names[i]);
}

static void every_file_is_the_same(void) {
  bytes plain[FILES], comma[FILES];
  char number[16];
  int i;
  write_all(plain);
  REQUIRE(setlocale(LC_NUMERIC, COMMA_LOCALE) != NULL);
  sprintf(number, "%.1f", 1.5);
  CHECK(strcmp(number, "1,5") == 0);
  write_all(comma);
  for (i = 0; i < FILES; ++i) {
    harness_case("%s", names[i]);
    CHECK(plain[i].size > 1000);
    CHECK(same_bytes(&plain[i], &comma[i]));
    free_bytes(&plain[i]);
    free_bytes(&comma[i]);
  }
  harness_case(NULL);
}

static void every_file_is_read_back(void) {
  ts_segmentation *resumed = NULL;
  bytes before = dump_teeth(s.segmentation), after;
  int i;
  for (i = 0; i < MESHES - 1; ++i) { /* GLB is written only */
    ts_model *model = NULL;
    harness_case("%s", names[i]);
    CHECK_STATUS(ts_model_load(s.context, names[i], NULL, NULL, &model), TS_OK);
    ts_model_destroy(model);
  }
  harness_case(NULL);
  REQUIRE_STATUS(ts_session_load(s.model, names[MESHES], NULL, NULL, &resumed), TS_OK);
  after = dump_teeth(resumed);
  CHECK(same_bytes(&before, &after));
  free_bytes(&before);
  free_bytes(&after);
  ts_segmentation_destroy(resumed);
}

static void every_message_has_a_point(void) {
  ts_feature_options o;
  ts_features *features = NULL;
  REQUIRE_STATUS(ts_feature_options_init(&o, sizeof o), TS_OK);
  o.radius = 7.25;
  CHECK_STATUS(ts_detect_features(s.model, &o, NULL, &features), TS_E_INVALID_ARGUMENT);
  CHECK(strstr(ts_last_error_message(), "7.25") != NULL);
}

int main(void) {
  uint32_t n = 0;
  int i;
  double *clicks;
  s = make_scan(20000, 1);
  clicks = proposed_clicks(s.segmentation, &n);
  CHECK_STATUS(ts_segment_clicks(s.segmentation, clicks, n, NULL, NULL), TS_OK);
  free(clicks);
  RUN(every_file_is_the_same);
  RUN(every_file_is_read_back);
  RUN(every_message_has_a_point);
  for (i = 0; i < FILES; ++i) remove(names[i]);
  free_scan(&s);
  return harness_finish();
}
