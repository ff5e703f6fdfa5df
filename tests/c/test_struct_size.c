/* Every struct that begins with struct_size: today's size is accepted, no size that no release had is.
 * SPDX-License-Identifier: Apache-2.0 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fixture.h"
#include "harness.h"

static scan s;

/* A struct as bytes, with room behind it. */
static union {
  unsigned char bytes[1024];
  uint32_t struct_size;
  double aligned;
} room;

typedef ts_status (*use)(void *object);

static ts_status init_context(void *o, uint32_t size) {
  return ts_context_options_init(o, size);
}
static ts_status init_input(void *o, uint32_t size) {
  return ts_mesh_input_init(o, size);
}
static ts_status init_intake(void *o, uint32_t size) {
  return ts_intake_options_init(o, size);
}
static ts_status init_features(void *o, uint32_t size) {
  return ts_feature_options_init(o, size);
}
static ts_status init_segment(void *o, uint32_t size) {
  return ts_segment_options_init(o, size, TS_PRESET_PAPER);
}

static ts_status init_number(void *o, uint32_t size) {
  return ts_number_options_init(o, size);
}
static ts_status init_tooth_mesh(void *o, uint32_t size) {
  return ts_tooth_mesh_options_init(o, size);
}
static ts_status init_save(void *o, uint32_t size) {
  return ts_save_options_init(o, size);
}

static ts_status use_context(void *o) {
  ts_context *out = NULL;
  const ts_status status = ts_context_create(o, &out);
  ts_context_destroy(out);
  return status;
}

static ts_status use_input(void *o) {
  ts_model *out = NULL;
  ts_mesh_input *input = o;
  const ts_mesh_input good = input_of(&s.arch);
  const uint32_t size = input->struct_size;
  ts_status status;
  *input = good;
  input->struct_size = size;
  status = ts_model_create(s.context, input, NULL, NULL, &out);
  ts_model_destroy(out);
  return status;
}

static ts_status use_intake(void *o) {
  ts_model *out = NULL;
  const ts_mesh_input input = input_of(&s.arch);
  const ts_status status = ts_model_create(s.context, &input, o, NULL, &out);
  ts_model_destroy(out);
  return status;
}

static ts_status use_features(void *o) {
  ts_features *out = NULL;
  const ts_status status = ts_detect_features(s.model, o, NULL, &out);
  ts_features_destroy(out);
  return status;
}

static ts_status use_segment(void *o) {
  ts_segmentation *out = NULL;
  const ts_status status = ts_segmentation_create(s.features, o, NULL, &out);
  ts_segmentation_destroy(out);
  return status;
}

static ts_status use_number(void *o) {
  return ts_assign_numbers(s.segmentation, o);
}

static uint32_t tooth_id;
static ts_status get_number(void *o) {
  return ts_get_number(s.segmentation, tooth_id, o);
}
static ts_status get_jaw(void *o) {
  return ts_get_jaw(s.segmentation, o);
}
static ts_status get_palmer(void *o) {
  return ts_fdi_to_palmer(21, o);
}
static ts_mesh *part;

static ts_status use_tooth_mesh(void *o) {
  ts_mesh *out = NULL;
  const ts_status status = ts_tooth_mesh_create(s.segmentation, tooth_id, o, NULL, &out);
  ts_mesh_destroy(out);
  return status;
}

static ts_status use_save(void *o) {
  const ts_status status = ts_segmentation_save(s.segmentation, "struct_size.ply", TS_OUTPUT_PLY, o, NULL);
  remove("struct_size.ply");
  return status;
}

static ts_status get_report(void *o) {
  return ts_model_get_report(s.model, o);
}
static ts_status get_features(void *o) {
  return ts_features_get_info(s.features, o);
}
static ts_status get_click(void *o) {
  return ts_get_click(s.segmentation, 0, o);
}
static ts_status get_tooth(void *o) {
  return ts_get_tooth(s.segmentation, tooth_id, o);
}
static ts_status get_memory(void *o) {
  return ts_get_memory(s.segmentation, o);
}
static ts_status get_times(void *o) {
  return ts_get_prepare_times(s.segmentation, o);
}
static ts_status get_history(void *o) {
  return ts_get_history(s.segmentation, o);
}
static ts_status get_mesh(void *o) {
  return ts_mesh_get_info(part, o);
}
static ts_status get_frame(void *o) {
  return ts_get_tooth_frame(s.segmentation, tooth_id, o);
}
static ts_status get_cut(void *o) {
  uint32_t n;
  return ts_get_cut(s.segmentation, tooth_id, 0, o, NULL, 0, &n);
}

static const struct {
  const char *name;
  ts_status (*init)(void *, uint32_t);
  use use;
  uint32_t size;
} options[] = {{"ts_context_options", init_context, use_context, sizeof(ts_context_options)},
               {"ts_mesh_input", init_input, use_input, sizeof(ts_mesh_input)},
               {"ts_intake_options", init_intake, use_intake, sizeof(ts_intake_options)},
               {"ts_feature_options", init_features, use_features, sizeof(ts_feature_options)},
               {"ts_segment_options", init_segment, use_segment, sizeof(ts_segment_options)},
               {"ts_number_options", init_number, use_number, sizeof(ts_number_options)},
               {"ts_tooth_mesh_options", init_tooth_mesh, use_tooth_mesh, sizeof(ts_tooth_mesh_options)},
               {"ts_save_options", init_save, use_save, sizeof(ts_save_options)}},
  results[] = {{"ts_intake_report", NULL, get_report, sizeof(ts_intake_report)},
               {"ts_features_info", NULL, get_features, sizeof(ts_features_info)},
               {"ts_click_info", NULL, get_click, sizeof(ts_click_info)},
               {"ts_tooth_info", NULL, get_tooth, sizeof(ts_tooth_info)},
               {"ts_cut_info", NULL, get_cut, sizeof(ts_cut_info)},
               {"ts_memory_info", NULL, get_memory, sizeof(ts_memory_info)},
               {"ts_history_info", NULL, get_history, sizeof(ts_history_info)},
               {"ts_prepare_times", NULL, get_times, sizeof(ts_prepare_times)},
               {"ts_number_info", NULL, get_number, sizeof(ts_number_info)},
               {"ts_jaw_info", NULL, get_jaw, sizeof(ts_jaw_info)},
               {"ts_palmer", NULL, get_palmer, sizeof(ts_palmer)},
               {"ts_mesh_info", NULL, get_mesh, sizeof(ts_mesh_info)},
               {"ts_tooth_frame", NULL, get_frame, sizeof(ts_tooth_frame)}};

/* All of these are no size of any release; 0.1.0 is the first, so that no shorter one is one. */
static size_t wrong_sizes(uint32_t size, uint32_t *wrong) {
  wrong[0] = 0;
  wrong[1] = 1;
  wrong[2] = 4;
  wrong[3] = size - 1;
  wrong[4] = size + 1;
  wrong[5] = size + 4096;
  wrong[6] = UINT32_MAX;
  return 7;
}

static int all_bytes_are(unsigned char value, size_t from) {
  size_t i;
  for (i = from; i < sizeof room.bytes; ++i)
    if (room.bytes[i] != value) return 0;
  return 1;
}

static void init_fills_its_struct_and_no_more(void) {
  size_t i;
  for (i = 0; i < sizeof options / sizeof options[0]; ++i) {
    harness_case("%s", options[i].name);
    memset(room.bytes, 0xa5, sizeof room.bytes);
    CHECK_STATUS(options[i].init(&room, options[i].size), TS_OK);
    CHECK(room.struct_size == options[i].size);
    CHECK(all_bytes_are(0xa5, options[i].size));
  }
}

static void init_refuses_wrong_sizes(void) {
  uint32_t wrong[8];
  size_t i, k;
  for (i = 0; i < sizeof options / sizeof options[0]; ++i)
    for (k = 0; k < wrong_sizes(options[i].size, wrong); ++k) {
      harness_case("%s of %lu", options[i].name, (unsigned long)wrong[k]);
      memset(room.bytes, 0xa5, sizeof room.bytes);
      CHECK_STATUS(options[i].init(&room, wrong[k]), TS_E_STRUCT_SIZE);
      CHECK(all_bytes_are(0xa5, 0));
    }
}

static void options_of_a_wrong_size_are_refused(void) {
  uint32_t wrong[8];
  size_t i, k;
  for (i = 0; i < sizeof options / sizeof options[0]; ++i) {
    harness_case("%s", options[i].name);
    REQUIRE_STATUS(options[i].init(&room, options[i].size), TS_OK);
    CHECK_STATUS(options[i].use(&room), TS_OK);
    for (k = 0; k < wrong_sizes(options[i].size, wrong); ++k) {
      harness_case("%s of %lu", options[i].name, (unsigned long)wrong[k]);
      REQUIRE_STATUS(options[i].init(&room, options[i].size), TS_OK);
      room.struct_size = wrong[k];
      CHECK_STATUS(options[i].use(&room), TS_E_STRUCT_SIZE);
    }
  }
}

static void results_fill_their_struct_and_no_more(void) {
  size_t i;
  for (i = 0; i < sizeof results / sizeof results[0]; ++i) {
    harness_case("%s", results[i].name);
    memset(room.bytes, 0xa5, sizeof room.bytes);
    room.struct_size = results[i].size;
    CHECK_STATUS(results[i].use(&room), TS_OK);
    CHECK(room.struct_size == results[i].size);
    CHECK(all_bytes_are(0xa5, results[i].size));
    CHECK(!all_bytes_are(0xa5, sizeof room.struct_size));
  }
}

static void results_refuse_wrong_sizes(void) {
  uint32_t wrong[8];
  size_t i, k;
  for (i = 0; i < sizeof results / sizeof results[0]; ++i)
    for (k = 0; k < wrong_sizes(results[i].size, wrong); ++k) {
      harness_case("%s of %lu", results[i].name, (unsigned long)wrong[k]);
      memset(room.bytes, 0xa5, sizeof room.bytes);
      room.struct_size = wrong[k];
      CHECK_STATUS(results[i].use(&room), TS_E_STRUCT_SIZE);
      CHECK(room.struct_size == wrong[k] && all_bytes_are(0xa5, sizeof room.struct_size));
    }
}

int main(void) {
  uint32_t clicks = 0, teeth = 0;
  double *proposed;
  s = make_scan(10000, 1);
  proposed = proposed_clicks(s.segmentation, &clicks);
  if (ts_segment_clicks(s.segmentation, proposed, clicks, NULL, NULL) != TS_OK) return 3;
  if (ts_get_teeth(s.segmentation, NULL, 0, &teeth) != TS_OK || teeth == 0) return 3;
  {
    uint32_t *ids = must_have(sizeof *ids * teeth);
    if (ts_get_teeth(s.segmentation, ids, teeth, &teeth) != TS_OK) return 3;
    tooth_id = ids[0];
    free(ids);
  }
  free(proposed);
  if (ts_gingiva_mesh_create(s.segmentation, NULL, NULL, &part) != TS_OK) return 3;
  RUN(init_fills_its_struct_and_no_more);
  RUN(init_refuses_wrong_sizes);
  RUN(options_of_a_wrong_size_are_refused);
  RUN(results_fill_their_struct_and_no_more);
  RUN(results_refuse_wrong_sizes);
  ts_mesh_destroy(part);
  free_scan(&s);
  return harness_finish();
}
