/* A session: clicks, corrections of teeth and cuts, undo, numbers, meshes, and the session kept: session SCAN TRUTH
 * FOLDER. SPDX-License-Identifier: Apache-2.0 */
#include <string.h>

#include "caller.h"

static ts_context *context;
static ts_model *model;
static ts_segmentation *segmentation;
static uint32_t faces;

static uint32_t *labels_of(const ts_segmentation *s) {
  uint32_t *labels = room_for(sizeof *labels * faces);
  DO(ts_get_labels(s, labels, faces, NULL));
  return labels;
}

static ts_history_info history(void) {
  ts_history_info info;
  info.struct_size = sizeof info;
  DO(ts_get_history(segmentation, &info));
  return info;
}

static double area_of(uint32_t tooth) {
  ts_tooth_info info;
  info.struct_size = sizeof info;
  DO(ts_get_tooth(segmentation, tooth, &info));
  return info.area;
}

static void on_change(void *user, const uint32_t *teeth, uint32_t count) {
  if (count == 0 || teeth) ++*(uint32_t *)user;
}

/* What a step did is gone after undo, and there after redo, to the byte. */
static void check_undo(const uint32_t *before) {
  uint32_t *after = labels_of(segmentation), *now;
  DO(ts_undo(segmentation));
  now = labels_of(segmentation);
  CHECK(memcmp(now, before, sizeof *now * faces) == 0);
  free(now);
  DO(ts_redo(segmentation));
  now = labels_of(segmentation);
  CHECK(memcmp(now, after, sizeof *now * faces) == 0);
  free(now);
  free(after);
}

static void corrections(const uint32_t *teeth) {
  uint32_t *before = labels_of(segmentation), locked = 7, count = 0;
  DO(ts_tooth_set_locked(segmentation, teeth[0], 1));
  CHECK(ts_tooth_remove(segmentation, teeth[0]) == TS_E_LOCKED);
  DO(ts_tooth_get_locked(segmentation, teeth[0], &locked));
  CHECK(locked == 1);
  DO(ts_tooth_merge(segmentation, teeth[3], teeth[4], NULL));
  DO(ts_get_changes(segmentation, NULL, 0, &count));
  CHECK(count > 0);
  check_undo(before);
  DO(ts_undo(segmentation));
  DO(ts_tooth_remove(segmentation, teeth[3]));
  check_undo(before);
  DO(ts_undo(segmentation));
  free(before);
}

static void edits(uint32_t tooth) {
  const double area = area_of(tooth);
  ts_cut_edit kept[4];
  uint32_t count = 0;
  DO(ts_cut_offset(segmentation, tooth, -0.3, NULL));
  CHECK(area_of(tooth) < area);
  DO(ts_cut_smooth(segmentation, tooth, 0.3, NULL));
  DO(ts_get_cut_edits(segmentation, tooth, kept, 4, &count));
  CHECK(count == 2 && kept[0].kind == TS_EDIT_OFFSET && kept[0].amount == -0.3 && kept[0].status == TS_OK);
  CHECK(kept[1].kind == TS_EDIT_SMOOTH && kept[1].amount == 0.3);
  CHECK(ts_cut_drag(segmentation, tooth, 99, 0, kept[0].to, 0, NULL) == TS_E_NOT_FOUND);
  CHECK(ts_cut_draw(segmentation, tooth, kept[0].to, 1, NULL) == TS_E_INVALID_ARGUMENT);
  DO(ts_cut_reset(segmentation, tooth));
  CHECK(area_of(tooth) == area);
}

static void numbers(uint32_t tooth) {
  ts_number_options options;
  ts_number_info number;
  ts_jaw_info jaw;
  ts_palmer palmer;
  uint32_t universal = 0, back = 0;
  DO(ts_number_options_init(&options, sizeof options));
  DO(ts_assign_numbers(segmentation, &options));
  number.struct_size = sizeof number;
  DO(ts_get_number(segmentation, tooth, &number));
  jaw.struct_size = sizeof jaw;
  DO(ts_get_jaw(segmentation, &jaw));
  CHECK(jaw.jaw == TS_JAW_UPPER || jaw.jaw == TS_JAW_LOWER);
  DO(ts_fdi_to_universal(number.fdi, &universal));
  DO(ts_universal_to_fdi(universal, &back));
  CHECK(back == number.fdi);
  palmer.struct_size = sizeof palmer;
  DO(ts_fdi_to_palmer(number.fdi, &palmer));
  CHECK(palmer.quadrant == number.fdi / 10 && palmer.position == number.fdi % 10);
}

static void meshes(uint32_t tooth, const char *folder) {
  ts_tooth_mesh_options options;
  ts_save_options save;
  ts_mesh_info info;
  ts_tooth_frame frame;
  ts_mesh *mesh = NULL;
  char path[4096];
  double *xyz;
  uint32_t *triangles, i;
  DO(ts_tooth_mesh_options_init(&options, sizeof options));
  options.closed = 1;
  DO(ts_tooth_mesh_create(segmentation, tooth, &options, NULL, &mesh));
  info.struct_size = sizeof info;
  DO(ts_mesh_get_info(mesh, &info));
  CHECK(info.vertices > 10 && info.triangles > 10 && info.open_rims == 0 && info.volume > 1);
  xyz = room_for(3 * sizeof *xyz * info.vertices);
  triangles = room_for(3 * sizeof *triangles * info.triangles);
  DO(ts_mesh_get_positions(mesh, xyz, info.vertices, NULL));
  DO(ts_mesh_get_triangles(mesh, triangles, info.triangles, NULL));
  for (i = 0; i < 3 * info.triangles; ++i) CHECK(triangles[i] < info.vertices);
  free(triangles);
  free(xyz);
  CHECK((size_t)snprintf(path, sizeof path, "%s/tooth.stl", folder) < sizeof path);
  DO(ts_mesh_save(mesh, path, TS_OUTPUT_STL, NULL));
  ts_mesh_destroy(mesh);
  DO(ts_save_options_init(&save, sizeof save));
  CHECK((size_t)snprintf(path, sizeof path, "%s/teeth.ply", folder) < sizeof path);
  DO(ts_segmentation_save(segmentation, path, TS_OUTPUT_PLY, &save, NULL));
  frame.struct_size = sizeof frame;
  DO(ts_get_tooth_frame(segmentation, tooth, &frame));
  CHECK(frame.width > 1 && frame.depth > 1 && frame.height > 1);
}

static void kept_and_read(void) {
  uint32_t size = 0, *here = labels_of(segmentation), *there;
  ts_segmentation *read = NULL;
  ts_features *features = NULL;
  char *text;
  DO(ts_session_write(segmentation, NULL, 0, &size));
  text = room_for(size);
  DO(ts_session_write(segmentation, text, size, NULL));
  CHECK(ts_session_read(model, text, size / 2, NULL, NULL, &read) != TS_OK && read == NULL);
  DO(ts_session_read(model, text, size, NULL, &features, &read));
  there = labels_of(read);
  CHECK(memcmp(here, there, sizeof *here * faces) == 0);
  free(there);
  free(here);
  free(text);
  ts_features_destroy(features);
  ts_segmentation_destroy(read);
}

int main(int argc, char **argv) {
  ts_features *features = NULL;
  ts_intake_report report;
  uint32_t teeth[32], count = 0, changes = 0;
  CHECK(argc == 4);
  DO(ts_context_create(NULL, &context));
  DO(ts_model_load(context, argv[1], NULL, NULL, &model));
  report.struct_size = sizeof report;
  DO(ts_model_get_report(model, &report));
  faces = report.input_faces;
  DO(ts_detect_features(model, NULL, NULL, &features));
  DO(ts_segmentation_create(features, NULL, NULL, &segmentation));
  DO(ts_set_change_callback(segmentation, on_change, &changes));
  CHECK(ts_undo(segmentation) == TS_E_NO_HISTORY);
  DO(ts_segment_all(segmentation, NULL));
  CHECK(changes == 1 && history().undo == 1 && history().redo == 0);
  DO(ts_get_teeth(segmentation, teeth, 32, &count));
  CHECK(count >= 12);
  corrections(teeth);
  edits(teeth[5]);
  numbers(teeth[5]);
  meshes(teeth[5], argv[3]);
  kept_and_read();
  CHECK(changes > 4);
  ts_features_destroy(features);
  ts_segmentation_destroy(segmentation);
  ts_model_destroy(model);
  ts_context_destroy(context);
  return 0;
}
