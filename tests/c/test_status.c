/* Versions, names, messages. SPDX-License-Identifier: Apache-2.0 */
#include <stdio.h>
#include <string.h>

#include "fixture.h"
#include "harness.h"

static void version_is_that_of_the_header(void) {
  char expected[64];
  snprintf(expected, sizeof expected, "%d.%d.%d", TS_VERSION_MAJOR, TS_VERSION_MINOR, TS_VERSION_PATCH);
  CHECK(strcmp(ts_version(), expected) == 0);
}

/* The values are fixed for ever: programs in other languages have them written out. */
static void status_names_and_values(void) {
  static const struct {
    ts_status status;
    int value;
    const char *name;
  } all[] = {
#define STATUS(name, value) {name, value, #name}
      STATUS(TS_OK, 0),
      STATUS(TS_E_INVALID_ARGUMENT, 100),
      STATUS(TS_E_NULL, 101),
      STATUS(TS_E_STRUCT_SIZE, 102),
      STATUS(TS_E_BUFFER_TOO_SMALL, 103),
      STATUS(TS_E_NOT_FOUND, 104),
      STATUS(TS_E_MISMATCH, 105),
      STATUS(TS_E_OUT_OF_MEMORY, 200),
      STATUS(TS_E_CANCELLED, 201),
      STATUS(TS_E_INTERNAL, 202),
      STATUS(TS_E_FILE_OPEN, 300),
      STATUS(TS_E_FILE_FORMAT, 301),
      STATUS(TS_E_FILE_TRUNCATED, 302),
      STATUS(TS_E_FILE_TRAILING, 303),
      STATUS(TS_E_FILE_COUNT, 304),
      STATUS(TS_E_FILE_SYNTAX, 305),
      STATUS(TS_E_FILE_WRITE, 306),
      STATUS(TS_E_FILE_NEWER, 307),
      STATUS(TS_E_MESH_EMPTY, 400),
      STATUS(TS_E_MESH_NON_FINITE, 401),
      STATUS(TS_E_MESH_INDEX_RANGE, 402),
      STATUS(TS_E_MESH_UNITS, 403),
      STATUS(TS_E_MESH_TOO_LARGE, 404),
      STATUS(TS_E_NO_TEETH, 500),
      STATUS(TS_E_NO_CONSTRAINT, 501),
      STATUS(TS_E_CLICK_OFF_SURFACE, 600),
      STATUS(TS_E_CLICK_ON_GINGIVA, 601),
      STATUS(TS_E_NO_CUT, 602),
      STATUS(TS_E_SOLVER, 603),
      STATUS(TS_E_LOCKED, 604),
      STATUS(TS_E_NO_CHANGE, 605),
      STATUS(TS_E_NO_HISTORY, 606),
      STATUS(TS_E_EDIT_NOTHING, 650),
      STATUS(TS_E_EDIT_ON_TOOTH, 651),
      STATUS(TS_E_EDIT_CROSSING, 652),
      STATUS(TS_E_EDIT_OFF_CUT, 653),
      STATUS(TS_E_EDIT_NO_LOOP, 654),
      STATUS(TS_E_TOO_MANY_TEETH, 700),
      STATUS(TS_E_NUMBER_JAW, 701),
      STATUS(TS_E_NUMBER_TAKEN, 702),
      STATUS(TS_E_NUMBER_ORDER, 703),
      STATUS(TS_E_NOT_CLOSED, 750),
#undef STATUS
  };
  size_t i;
  for (i = 0; i < sizeof all / sizeof all[0]; ++i) {
    harness_case("%s", all[i].name);
    CHECK((int)all[i].status == all[i].value);
    CHECK(strcmp(ts_status_name(all[i].status), all[i].name) == 0);
  }
  harness_case("unknown");
  CHECK(strcmp(ts_status_name((ts_status)1), "TS_E_?") == 0);
  CHECK(strcmp(ts_status_name((ts_status)-1), "TS_E_?") == 0);
  CHECK(strcmp(ts_status_name(TS_STATUS_FORCE_INT), "TS_E_?") == 0);
}

static void last_message_is_one_line_and_stays(void) {
  ts_context *context = NULL;
  char kept[1024];
  CHECK(strcmp(ts_last_error_message(), "") == 0); /* before any failure of this program */
  CHECK_STATUS(ts_context_create(NULL, NULL), TS_E_NULL);
  CHECK(strlen(ts_last_error_message()) > 0);
  CHECK(strchr(ts_last_error_message(), '\n') == NULL);
  snprintf(kept, sizeof kept, "%s", ts_last_error_message());
  REQUIRE_STATUS(ts_context_create(NULL, &context), TS_OK); /* success does not touch it */
  CHECK(strcmp(ts_last_error_message(), kept) == 0);
  ts_context_destroy(context);
}

/* A message says what and where: the name of the file. */
static void message_names_the_file(void) {
  ts_context *context = make_context(1);
  ts_model *model = NULL;
  CHECK_STATUS(ts_model_load(context, "no/such/scan.stl", NULL, NULL, &model), TS_E_FILE_OPEN);
  CHECK(strstr(ts_last_error_message(), "no/such/scan.stl") != NULL);
  CHECK(model == NULL);
  ts_context_destroy(context);
}

/* However long a name is, the message stays one terminated line. */
static void long_names_do_no_harm(void) {
  static char path[100000];
  ts_context *context = make_context(1);
  ts_model *model = NULL;
  memset(path, 'x', sizeof path - 1);
  CHECK_STATUS(ts_model_load(context, path, NULL, NULL, &model), TS_E_FILE_OPEN);
  CHECK(strlen(ts_last_error_message()) > 0);
  CHECK(strchr(ts_last_error_message(), '\n') == NULL);
  memcpy(path, "two\nlines", 9);
  path[9] = '\0';
  CHECK_STATUS(ts_model_load(context, path, NULL, NULL, &model), TS_E_FILE_OPEN);
  CHECK(strchr(ts_last_error_message(), '\n') == NULL);
  ts_context_destroy(context);
}

int main(void) {
  RUN(version_is_that_of_the_header);
  RUN(status_names_and_values);
  RUN(last_message_is_one_line_and_stays);
  RUN(message_names_the_file);
  RUN(long_names_do_no_harm);
  return harness_finish();
}
