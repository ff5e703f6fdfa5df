/* The shortest way to a tooth: hello_tooth SCAN [X Y Z] prints the cut around the tooth at X Y Z (mm, on the surface),
 * or around the first one the library proposes. SPDX-License-Identifier: Apache-2.0 */
#include <stdio.h>
#include <stdlib.h>
#include <toothseg.h>

#define TRY(call) \
  if ((call) != TS_OK) goto failed

int main(int argc, char **argv) {
  ts_context *context = NULL;
  ts_model *model = NULL;
  ts_features *features = NULL;
  ts_segmentation *segmentation = NULL;
  ts_click_info info;
  ts_edge_point *points = NULL;
  double *proposed = NULL, click[3];
  uint32_t number, count, i;
  int result = 1;

  if (argc != 2 && argc != 5) return fprintf(stderr, "usage: hello_tooth SCAN [X Y Z]\n"), 2;
  TRY(ts_context_create(NULL, &context));
  TRY(ts_model_load(context, argv[1], NULL, NULL, &model));
  TRY(ts_detect_features(model, NULL, NULL, &features));
  TRY(ts_segmentation_create(features, NULL, NULL, &segmentation));

  if (argc == 5) {
    for (i = 0; i < 3; ++i) click[i] = atof(argv[2 + i]);
  } else {
    TRY(ts_propose_clicks(segmentation, NULL, 0, &count));
    if ((proposed = malloc(3 * sizeof *proposed * count)) == NULL) goto done;
    TRY(ts_propose_clicks(segmentation, proposed, count, &count));
    for (i = 0; i < 3; ++i) click[i] = proposed[i];
  }
  TRY(ts_segment_click(segmentation, click, NULL, &number));
  info.struct_size = sizeof info;
  TRY(ts_get_click(segmentation, number, &info));
  TRY(ts_get_cut(segmentation, info.target, 0, NULL, NULL, 0, &count));
  if ((points = malloc(sizeof *points * count)) == NULL) goto done;
  TRY(ts_get_cut(segmentation, info.target, 0, NULL, points, count, &count));
  for (i = 0; i < count; ++i)
    printf("%.4f %.4f %.4f\n", points[i].position[0], points[i].position[1], points[i].position[2]);
  result = 0;
  goto done;
failed:
  fprintf(stderr, "hello_tooth: %s\n", ts_last_error_message());
done:
  free(points);
  free(proposed);
  ts_segmentation_destroy(segmentation);
  ts_features_destroy(features);
  ts_model_destroy(model);
  ts_context_destroy(context);
  return result;
}
