/* What a technician does after the clicks: edit_teeth SCAN DIR separates all teeth, corrects one by a point, takes that
 * back and drags its cut instead, numbers the teeth, writes a closed mesh a tooth into DIR, and saves the session and
 * resumes it. SPDX-License-Identifier: Apache-2.0 */
#include <stdio.h>
#include <stdlib.h>
#include <toothseg.h>

#define TRY(call) \
  if ((call) != TS_OK) goto failed

static ts_status write_tooth(const ts_segmentation *segmentation, uint32_t tooth, const char *folder) {
  ts_number_info number;
  ts_tooth_mesh_options options;
  ts_mesh *mesh = NULL;
  char path[4096];
  ts_status status;
  number.struct_size = sizeof number;
  if ((status = ts_get_number(segmentation, tooth, &number)) != TS_OK) return status;
  if ((status = ts_tooth_mesh_options_init(&options, sizeof options)) != TS_OK) return status;
  options.closed = 1;
  status = ts_tooth_mesh_create(segmentation, tooth, &options, NULL, &mesh);
  if (status == TS_E_NOT_CLOSED) status = ts_tooth_mesh_create(segmentation, tooth, NULL, NULL, &mesh); /* open, then */
  if (status != TS_OK) return status;
  snprintf(path, sizeof path, "%s/tooth_%u.stl", folder, (unsigned)number.fdi);
  printf("%s%s\n", path, number.uncertain ? " (a number to be looked at)" : "");
  status = ts_mesh_save(mesh, path, TS_OUTPUT_STL, NULL);
  ts_mesh_destroy(mesh);
  return status;
}

static double height(const double p[3], const double up[3]) {
  return p[0] * up[0] + p[1] * up[1] + p[2] * up[2];
}

int main(int argc, char **argv) {
  ts_context *context = NULL;
  ts_model *model = NULL;
  ts_features *features = NULL;
  ts_segmentation *segmentation = NULL, *resumed = NULL;
  ts_edge_point *cut = NULL;
  ts_tooth_info before, after;
  uint32_t *teeth = NULL, count, points, lowest = 0, i;
  double to[3], up[3];
  char path[4096];
  int result = 1;

  if (argc != 3) return fprintf(stderr, "usage: edit_teeth SCAN DIR\n"), 2;
  before.struct_size = after.struct_size = sizeof before;
  TRY(ts_context_create(NULL, &context));
  TRY(ts_model_load(context, argv[1], NULL, NULL, &model));
  TRY(ts_detect_features(model, NULL, NULL, &features));
  TRY(ts_segmentation_create(features, NULL, NULL, &segmentation));
  TRY(ts_segment_all(segmentation, NULL));
  TRY(ts_get_teeth(segmentation, NULL, 0, &count));
  if ((teeth = malloc(sizeof *teeth * (count + 1))) == NULL) goto done;
  TRY(ts_get_teeth(segmentation, teeth, count, &count));
  if (count == 0) goto done;

  /* The first tooth is to reach half a millimetre further down where its cut is nearest to the gums. By a click: "this
   * too"; ts_tooth_exclude would be "not this". */
  TRY(ts_get_cut(segmentation, teeth[0], 0, NULL, NULL, 0, &points));
  if ((cut = malloc(sizeof *cut * points)) == NULL) goto done;
  TRY(ts_get_cut(segmentation, teeth[0], 0, NULL, cut, points, &points));
  TRY(ts_features_get_occlusal(features, up));
  for (i = 0; i < points; ++i)
    if (height(cut[i].position, up) < height(cut[lowest].position, up)) lowest = i;
  for (i = 0; i < 3; ++i) to[i] = cut[lowest].position[i] - 0.5 * up[i];
  TRY(ts_get_tooth(segmentation, teeth[0], &before));
  if (ts_tooth_include(segmentation, teeth[0], to, NULL) == TS_OK) {
    TRY(ts_get_tooth(segmentation, teeth[0], &after));
    printf("this too: %.2f mm^2 instead of %.2f\n", after.area, before.area);
    TRY(ts_undo(segmentation));
  } else {
    printf("the point was refused: %s\n", ts_last_error_message());
  }

  /* By hand instead: the cut is the one above again, so its point is where it was. */
  if (ts_cut_drag(segmentation, teeth[0], 0, lowest, to, 0, NULL) == TS_OK)
    printf("dragged\n");
  else
    printf("the drag was refused: %s\n", ts_last_error_message());

  TRY(ts_assign_numbers(segmentation, NULL));
  for (i = 0; i < count; ++i) TRY(write_tooth(segmentation, teeth[i], argv[2]));

  snprintf(path, sizeof path, "%s/session.json", argv[2]);
  TRY(ts_session_save(segmentation, path));
  TRY(ts_session_load(model, path, NULL, NULL, &resumed));
  TRY(ts_get_teeth(resumed, NULL, 0, &points));
  printf("resumed with %u teeth\n", (unsigned)points);
  result = points != count;
  goto done;
failed:
  fprintf(stderr, "edit_teeth: %s\n", ts_last_error_message());
done:
  free(cut);
  free(teeth);
  ts_segmentation_destroy(resumed);
  ts_segmentation_destroy(segmentation);
  ts_features_destroy(features);
  ts_model_destroy(model);
  ts_context_destroy(context);
  return result;
}
