/* Every function with NULL in the place of each of its pointers. SPDX-License-Identifier: Apache-2.0
 *
 * all_functions.inc is made from the header by CMake: a function without a case here is a failure. */
#include <stdlib.h>
#include <string.h>

#include "fixture.h"
#include "harness.h"

static const char *const functions[] = {
#define FUNCTION(name) #name,
#include "all_functions.inc"
#undef FUNCTION
};

/* Takes the address of every function of the header: one that is declared and not exported does not link. */
typedef void (*any_function)(void);
static const any_function addresses[] = {
#define FUNCTION(name) (any_function) name,
#include "all_functions.inc"
#undef FUNCTION
};

enum { FUNCTIONS = sizeof functions / sizeof functions[0] };
static int covered[FUNCTIONS];

static void cover(const char *name) {
  size_t i;
  for (i = 0; i < FUNCTIONS; ++i)
    if (strcmp(functions[i], name) == 0) covered[i] = 1;
}

#define REFUSED(function, arguments)                    \
  do {                                                  \
    cover(#function);                                   \
    harness_case("%s%s", #function, #arguments);        \
    CHECK_STATUS(function arguments, TS_E_NULL);        \
    CHECK(strlen(ts_last_error_message()) > 0);         \
    CHECK(out == sentinel && count == 77 && done == 0); \
  } while (0)

#define ACCEPTED(function, arguments)            \
  do {                                           \
    cover(#function);                            \
    harness_case("%s%s", #function, #arguments); \
    CHECK_STATUS(function arguments, TS_OK);     \
  } while (0)

/* For functions without a status: that they return is the test. */
#define HARMLESS(function, arguments) \
  do {                                \
    cover(#function);                 \
    function arguments;               \
  } while (0)

static scan s;
static char mark;
static void *const sentinel = &mark;
static void *out;      /* where handles would go */
static uint32_t count; /* where counts would go */
static int done;       /* never set: nothing calls back */
static const double at[3] = {0, 0, 0}, down[3] = {0, 0, -1};

static int progress(double fraction, const char *stage, void *user) {
  (void)fraction;
  (void)stage;
  *(int *)user = 1;
  return 0;
}

static void begin(void) {
  out = sentinel;
  count = 77;
}

static void setup_functions(void) {
  ts_context_options o;
  ts_mesh_input m;
  ts_intake_options i;
  ts_feature_options f;
  ts_segment_options g;
  begin();
  REFUSED(ts_context_options_init, (NULL, sizeof o));
  REFUSED(ts_context_create, (NULL, NULL));
  REFUSED(ts_mesh_input_init, (NULL, sizeof m));
  REFUSED(ts_intake_options_init, (NULL, sizeof i));
  REFUSED(ts_feature_options_init, (NULL, sizeof f));
  REFUSED(ts_segment_options_init, (NULL, sizeof g, TS_PRESET_DEFAULT));
  REFUSED(ts_job_create, (NULL, progress, &done, (ts_job **)&out));
  REFUSED(ts_job_create, (s.context, progress, &done, NULL));
  HARMLESS(ts_context_destroy, (NULL));
  HARMLESS(ts_job_cancel, (NULL));
  HARMLESS(ts_job_reset, (NULL));
  HARMLESS(ts_job_destroy, (NULL));
  HARMLESS(ts_model_destroy, (NULL));
  HARMLESS(ts_features_destroy, (NULL));
  HARMLESS(ts_segmentation_destroy, (NULL));
  cover("ts_job_progress");
  CHECK(ts_job_progress(NULL) == 0);
  cover("ts_version");
  CHECK(ts_version() != NULL);
  cover("ts_status_name");
  CHECK(ts_status_name(TS_OK) != NULL);
  cover("ts_last_error_message");
  CHECK(ts_last_error_message() != NULL);
}

static void model_functions(void) {
  const ts_mesh_input input = input_of(&s.arch);
  ts_mesh_input without;
  ts_surface_point point;
  double xyz[3] = {5, 5, 5};
  uint32_t index = 5;
  ts_model **model = (ts_model **)&out;
  begin();
  REFUSED(ts_model_create, (NULL, &input, NULL, NULL, model));
  REFUSED(ts_model_create, (s.context, NULL, NULL, NULL, model));
  REFUSED(ts_model_create, (s.context, &input, NULL, NULL, NULL));
  without = input;
  without.positions = NULL;
  REFUSED(ts_model_create, (s.context, &without, NULL, NULL, model));
  REFUSED(ts_model_load, (NULL, "scan.stl", NULL, NULL, model));
  REFUSED(ts_model_load, (s.context, NULL, NULL, NULL, model));
  REFUSED(ts_model_load, (s.context, "scan.stl", NULL, NULL, NULL));
  REFUSED(ts_model_read, (NULL, "OFF", 3, TS_FORMAT_AUTO, NULL, NULL, model));
  REFUSED(ts_model_read, (s.context, NULL, 3, TS_FORMAT_AUTO, NULL, NULL, model));
  REFUSED(ts_model_read, (s.context, "OFF", 3, TS_FORMAT_AUTO, NULL, NULL, NULL));
  REFUSED(ts_model_get_report, (NULL, (ts_intake_report *)&out));
  REFUSED(ts_model_get_report, (s.model, NULL));
  REFUSED(ts_model_get_positions, (NULL, xyz, 1, &count));
  REFUSED(ts_model_get_positions, (s.model, NULL, 0, NULL));
  REFUSED(ts_model_get_triangles, (NULL, &index, 1, &count));
  REFUSED(ts_model_get_triangles, (s.model, NULL, 0, NULL));
  REFUSED(ts_model_get_face_sources, (NULL, &index, 1, &count));
  REFUSED(ts_model_get_face_sources, (s.model, NULL, 0, NULL));
  REFUSED(ts_model_get_vertex_map, (NULL, &index, 1, &count));
  REFUSED(ts_model_get_vertex_map, (s.model, NULL, 0, NULL));
  REFUSED(ts_model_nearest, (NULL, at, &point));
  REFUSED(ts_model_nearest, (s.model, NULL, &point));
  REFUSED(ts_model_nearest, (s.model, at, NULL));
  REFUSED(ts_model_raycast, (NULL, at, down, &point));
  REFUSED(ts_model_raycast, (s.model, NULL, down, &point));
  REFUSED(ts_model_raycast, (s.model, at, NULL, &point));
  REFUSED(ts_model_raycast, (s.model, at, down, NULL));
  CHECK(xyz[0] == 5 && index == 5);
}

static void feature_functions(void) {
  ts_feature_point point;
  ts_feature_group group;
  double xyz[3] = {5, 5, 5};
  uint32_t index = 5;
  ts_features **features = (ts_features **)&out;
  ts_features *copy = NULL;
  begin();
  REFUSED(ts_detect_features, (NULL, NULL, NULL, features));
  REFUSED(ts_detect_features, (s.model, NULL, NULL, NULL));
  REFUSED(ts_features_create, (NULL, features));
  REFUSED(ts_features_create, (s.model, NULL));
  REFUSED(ts_features_clone, (NULL, features));
  REFUSED(ts_features_clone, (s.features, NULL));
  REFUSED(ts_features_get_info, (NULL, (ts_features_info *)&out));
  REFUSED(ts_features_get_info, (s.features, NULL));
  REFUSED(ts_features_get_occlusal, (NULL, xyz));
  REFUSED(ts_features_get_occlusal, (s.features, NULL));
  REFUSED(ts_features_set_occlusal, (NULL, xyz));
  REFUSED(ts_features_set_occlusal, (s.features, NULL));
  REFUSED(ts_features_get_arch, (NULL, xyz, 1, &count));
  REFUSED(ts_features_get_arch, (s.features, NULL, 0, NULL));
  REFUSED(ts_features_get_points, (NULL, &point, 1, &count));
  REFUSED(ts_features_get_points, (s.features, NULL, 0, NULL));
  REFUSED(ts_features_get_groups, (NULL, &group, 1, &count));
  REFUSED(ts_features_get_groups, (s.features, NULL, 0, NULL));
  REFUSED(ts_features_add_point, (NULL, at, TS_NONE, &count, &index));
  REFUSED(ts_features_add_point, (s.features, NULL, TS_NONE, &count, &index));
  REFUSED(ts_features_move_point, (NULL, 0, at));
  REFUSED(ts_features_move_point, (s.features, 0, NULL));
  REFUSED(ts_features_set_group, (NULL, 0, TS_NONE, &count));
  REFUSED(ts_features_remove_point, (NULL, 0));
  REFUSED(ts_features_remove_group, (NULL, 0));
  CHECK(xyz[0] == 5 && index == 5);

  if (ts_features_clone(s.features, &copy) == TS_OK) {
    ACCEPTED(ts_features_add_point, (copy, at, TS_NONE, NULL, NULL));
  }
  ts_features_destroy(copy);
}

static void segmentation_functions(void) {
  double xyz[3] = {5, 5, 5};
  uint32_t index = 5;
  ts_status status = TS_E_SOLVER;
  begin();
  REFUSED(ts_segmentation_create, (NULL, NULL, NULL, (ts_segmentation **)&out));
  REFUSED(ts_segmentation_create, (s.features, NULL, NULL, NULL));
  REFUSED(ts_segment_click, (NULL, at, NULL, &count));
  REFUSED(ts_segment_click, (s.segmentation, NULL, NULL, &count));
  REFUSED(ts_segment_clicks, (NULL, at, 1, NULL, &status));
  REFUSED(ts_segment_clicks, (s.segmentation, NULL, 1, NULL, &status));
  REFUSED(ts_propose_clicks, (NULL, xyz, 1, &count));
  REFUSED(ts_propose_clicks, (s.segmentation, NULL, 0, NULL));
  CHECK(xyz[0] == 5 && index == 5 && status == TS_E_SOLVER);
}

static void result_functions(void) {
  ts_click_info click;
  ts_tooth_info tooth;
  ts_cut_info cut;
  ts_prepare_times times;
  ts_memory_info memory;
  ts_contour_info contour;
  ts_edge_point point;
  double u = 5;
  const double xyz[6] = {0, 0, 0, 1, 1, 1};
  uint32_t index = 5, id = 0, n = 0;
  uint8_t closed = 5;
  ts_cut_edit edit;
  double *clicks = proposed_clicks(s.segmentation, &n);
  click.struct_size = sizeof click;
  tooth.struct_size = sizeof tooth;
  cut.struct_size = sizeof cut;
  times.struct_size = sizeof times;
  edit.points = 5;
  REQUIRE(n > 0);
  REQUIRE_STATUS(ts_segment_click(s.segmentation, clicks, NULL, NULL), TS_OK);
  free(clicks);
  REQUIRE_STATUS(ts_get_click(s.segmentation, 0, &click), TS_OK);
  id = click.target;
  begin();
  REFUSED(ts_get_click_count, (NULL, &count));
  REFUSED(ts_get_click_count, (s.segmentation, NULL));
  REFUSED(ts_get_click, (NULL, 0, &click));
  REFUSED(ts_get_click, (s.segmentation, 0, NULL));
  REFUSED(ts_get_field, (NULL, 0, &u, 1, &count));
  REFUSED(ts_get_field, (s.segmentation, 0, NULL, 0, NULL));
  REFUSED(ts_get_histogram, (NULL, 0, &index, 1, &count));
  REFUSED(ts_get_histogram, (s.segmentation, 0, NULL, 0, NULL));
  REFUSED(ts_get_contours, (NULL, 0, &contour, 1, &count));
  REFUSED(ts_get_contours, (s.segmentation, 0, NULL, 0, NULL));
  REFUSED(ts_get_contour_points, (NULL, 0, 0, &point, 1, &count, &index, &closed));
  REFUSED(ts_get_contour_points, (s.segmentation, 0, 0, NULL, 0, NULL, NULL, NULL));
  REFUSED(ts_get_teeth, (NULL, &index, 1, &count));
  REFUSED(ts_get_teeth, (s.segmentation, NULL, 0, NULL));
  REFUSED(ts_get_tooth, (NULL, id, &tooth));
  REFUSED(ts_get_tooth, (s.segmentation, id, NULL));
  REFUSED(ts_get_tooth_faces, (NULL, id, &index, 1, &count));
  REFUSED(ts_get_tooth_faces, (s.segmentation, id, NULL, 0, NULL));
  REFUSED(ts_get_tooth_vertices, (NULL, id, &index, 1, &count));
  REFUSED(ts_get_tooth_vertices, (s.segmentation, id, NULL, 0, NULL));
  REFUSED(ts_get_tooth_seeds, (NULL, id, &index, 1, &count));
  REFUSED(ts_get_tooth_seeds, (s.segmentation, id, NULL, 0, NULL));
  REFUSED(ts_get_cut, (NULL, id, 0, &cut, &point, 1, &count));
  REFUSED(ts_get_cut, (s.segmentation, id, 0, NULL, NULL, 0, NULL));
  REFUSED(ts_get_labels, (NULL, &index, 1, &count));
  REFUSED(ts_get_labels, (s.segmentation, NULL, 0, NULL));
  REFUSED(ts_get_memory, (NULL, &memory));
  REFUSED(ts_get_memory, (s.segmentation, NULL));
  REFUSED(ts_get_prepare_times, (NULL, &times));
  REFUSED(ts_get_prepare_times, (s.segmentation, NULL));
  REFUSED(ts_cut_drag, (NULL, id, 0, 0, xyz, 0, NULL));
  REFUSED(ts_cut_drag, (s.segmentation, id, 0, 0, NULL, 0, NULL));
  REFUSED(ts_cut_draw, (NULL, id, xyz, 2, NULL));
  REFUSED(ts_cut_draw, (s.segmentation, id, NULL, 2, NULL));
  REFUSED(ts_cut_offset, (NULL, id, 0.1, NULL));
  REFUSED(ts_cut_smooth, (NULL, id, 0.1, NULL));
  REFUSED(ts_cut_reset, (NULL, id));
  REFUSED(ts_get_cut_edits, (NULL, id, &edit, 1, &count));
  REFUSED(ts_get_cut_edits, (s.segmentation, id, NULL, 0, NULL));
  CHECK(u == 5 && index == 5 && closed == 5 && edit.points == 5);
  ACCEPTED(ts_get_cut, (s.segmentation, id, 0, NULL, NULL, 0, &count));
  ACCEPTED(ts_get_cut, (s.segmentation, id, 0, &cut, NULL, 0, &count));
  ACCEPTED(ts_get_contour_points, (s.segmentation, 0, 0, NULL, 0, &count, NULL, NULL));
}

static void number_functions(void) {
  ts_number_info number;
  ts_jaw_info jaw;
  ts_palmer palmer;
  number.struct_size = sizeof number;
  jaw.struct_size = sizeof jaw;
  palmer.struct_size = sizeof palmer;
  begin();
  REFUSED(ts_number_options_init, (NULL, sizeof(ts_number_options)));
  REFUSED(ts_assign_numbers, (NULL, NULL));
  REFUSED(ts_set_number, (NULL, 0, 11));
  REFUSED(ts_get_number, (NULL, 0, &number));
  REFUSED(ts_get_number, (s.segmentation, 0, NULL));
  REFUSED(ts_get_jaw, (NULL, &jaw));
  REFUSED(ts_get_jaw, (s.segmentation, NULL));
  REFUSED(ts_fdi_to_universal, (11, NULL));
  REFUSED(ts_universal_to_fdi, (1, NULL));
  REFUSED(ts_fdi_to_palmer, (11, NULL));
}

static void mesh_functions(void) {
  ts_tooth_mesh_options o;
  ts_save_options save;
  ts_mesh_info info;
  ts_tooth_frame frame;
  ts_mesh *part = NULL;
  double xyz = 5;
  uint32_t index = 5;
  uint8_t flag = 5;
  info.struct_size = sizeof info;
  frame.struct_size = sizeof frame;
  REQUIRE_STATUS(ts_gingiva_mesh_create(s.segmentation, NULL, NULL, &part), TS_OK);
  begin();
  REFUSED(ts_tooth_mesh_options_init, (NULL, sizeof o));
  REFUSED(ts_save_options_init, (NULL, sizeof save));
  REFUSED(ts_tooth_mesh_create, (NULL, 0, NULL, NULL, (ts_mesh **)&out));
  REFUSED(ts_tooth_mesh_create, (s.segmentation, 0, NULL, NULL, NULL));
  REFUSED(ts_gingiva_mesh_create, (NULL, NULL, NULL, (ts_mesh **)&out));
  REFUSED(ts_gingiva_mesh_create, (s.segmentation, NULL, NULL, NULL));
  HARMLESS(ts_mesh_destroy, (NULL));
  REFUSED(ts_mesh_get_info, (NULL, &info));
  REFUSED(ts_mesh_get_info, (part, NULL));
  REFUSED(ts_mesh_get_positions, (NULL, &xyz, 1, &count));
  REFUSED(ts_mesh_get_positions, (part, NULL, 0, NULL));
  REFUSED(ts_mesh_get_normals, (NULL, &xyz, 1, &count));
  REFUSED(ts_mesh_get_normals, (part, NULL, 0, NULL));
  REFUSED(ts_mesh_get_triangles, (NULL, &index, 1, &count));
  REFUSED(ts_mesh_get_triangles, (part, NULL, 0, NULL));
  REFUSED(ts_mesh_get_faces, (NULL, &index, 1, &count));
  REFUSED(ts_mesh_get_faces, (part, NULL, 0, NULL));
  REFUSED(ts_mesh_get_vertex_flags, (NULL, &flag, 1, &count));
  REFUSED(ts_mesh_get_vertex_flags, (part, NULL, 0, NULL));
  REFUSED(ts_mesh_save, (NULL, "null.stl", TS_OUTPUT_STL, NULL));
  REFUSED(ts_mesh_save, (part, NULL, TS_OUTPUT_STL, NULL));
  REFUSED(ts_segmentation_save, (NULL, "null.ply", TS_OUTPUT_PLY, NULL, NULL));
  REFUSED(ts_segmentation_save, (s.segmentation, NULL, TS_OUTPUT_PLY, NULL, NULL));
  REFUSED(ts_get_tooth_frame, (NULL, 0, &frame));
  REFUSED(ts_get_tooth_frame, (s.segmentation, 0, NULL));
  CHECK(xyz == 5 && index == 5 && flag == 5);
  ts_mesh_destroy(part);
}

static void every_function_is_here(void) {
  size_t i;
  CHECK(FUNCTIONS >= 60);
  for (i = 0; i < FUNCTIONS; ++i) {
    harness_case("%s", functions[i]);
    CHECK(addresses[i] != NULL);
    CHECK(covered[i]);
  }
}

static void session_functions(void) {
  ts_review_item item;
  ts_overlap overlap;
  ts_history_info history;
  char text = 0;
  uint32_t index = 5, id = 0, n = 0, ids[64];
  history.struct_size = sizeof history;
  REQUIRE_STATUS(ts_segment_all(s.segmentation, NULL), TS_OK);
  REQUIRE_STATUS(ts_get_teeth(s.segmentation, ids, 64, &n), TS_OK);
  REQUIRE(n > 0);
  id = ids[0];
  begin();
  REFUSED(ts_segment_all, (NULL, NULL));
  REFUSED(ts_get_review, (NULL, &item, 1, &count));
  REFUSED(ts_get_review, (s.segmentation, NULL, 0, NULL));
  REFUSED(ts_tooth_include, (NULL, id, at, NULL));
  REFUSED(ts_tooth_include, (s.segmentation, id, NULL, NULL));
  REFUSED(ts_tooth_exclude, (NULL, id, at, NULL));
  REFUSED(ts_tooth_exclude, (s.segmentation, id, NULL, NULL));
  REFUSED(ts_tooth_split, (NULL, id, at, at, NULL, &count));
  REFUSED(ts_tooth_split, (s.segmentation, id, NULL, at, NULL, &count));
  REFUSED(ts_tooth_split, (s.segmentation, id, at, NULL, NULL, &count));
  REFUSED(ts_tooth_move_point, (NULL, id, at, at, NULL));
  REFUSED(ts_tooth_move_point, (s.segmentation, id, NULL, at, NULL));
  REFUSED(ts_tooth_move_point, (s.segmentation, id, at, NULL, NULL));
  REFUSED(ts_tooth_merge, (NULL, id, id, NULL));
  REFUSED(ts_tooth_remove, (NULL, id));
  REFUSED(ts_tooth_set_locked, (NULL, id, 1));
  REFUSED(ts_tooth_get_locked, (NULL, id, &count));
  REFUSED(ts_tooth_get_locked, (s.segmentation, id, NULL));
  REFUSED(ts_get_overlaps, (NULL, &overlap, 1, &count));
  REFUSED(ts_get_overlaps, (s.segmentation, NULL, 0, NULL));
  REFUSED(ts_undo, (NULL));
  REFUSED(ts_redo, (NULL));
  REFUSED(ts_get_history, (NULL, &history));
  REFUSED(ts_get_history, (s.segmentation, NULL));
  REFUSED(ts_set_history_limit, (NULL, 0));
  REFUSED(ts_get_changes, (NULL, &index, 1, &count));
  REFUSED(ts_get_changes, (s.segmentation, NULL, 0, NULL));
  REFUSED(ts_set_change_callback, (NULL, NULL, NULL));
  REFUSED(ts_session_write, (NULL, &text, 1, &count));
  REFUSED(ts_session_write, (s.segmentation, NULL, 0, NULL));
  REFUSED(ts_session_save, (NULL, "session.json"));
  REFUSED(ts_session_save, (s.segmentation, NULL));
  REFUSED(ts_session_read, (NULL, &text, 1, NULL, NULL, (ts_segmentation **)&out));
  REFUSED(ts_session_read, (s.model, NULL, 1, NULL, NULL, (ts_segmentation **)&out));
  REFUSED(ts_session_read, (s.model, &text, 1, NULL, NULL, NULL));
  REFUSED(ts_session_load, (NULL, "session.json", NULL, NULL, (ts_segmentation **)&out));
  REFUSED(ts_session_load, (s.model, NULL, NULL, NULL, (ts_segmentation **)&out));
  REFUSED(ts_session_load, (s.model, "session.json", NULL, NULL, NULL));
  ACCEPTED(ts_set_change_callback, (s.segmentation, NULL, NULL));
  CHECK(index == 5);
}

int main(void) {
  s = make_scan(10000, 1);
  RUN(setup_functions);
  RUN(model_functions);
  RUN(feature_functions);
  RUN(segmentation_functions);
  RUN(result_functions);
  RUN(session_functions);
  RUN(number_functions);
  RUN(mesh_functions);
  RUN(every_function_is_here);
  free_scan(&s);
  return harness_finish();
}
