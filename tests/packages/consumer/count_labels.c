/* Separates the first tooth that the library proposes on a made arch, and prints how many labels there are and a
 * checksum of them. SPDX-License-Identifier: Apache-2.0 */
#include <stdio.h>
#include <stdlib.h>
#include <toothseg.h>
#include <toothseg_arch.h>

#include "summary.h"

#define TRY(call) \
  if ((call) != 0) goto failed

int main(void) {
  tsa_options options;
  tsa_arch *arch = NULL;
  ts_mesh_input mesh;
  ts_context *context = NULL;
  ts_model *model = NULL;
  ts_features *features = NULL;
  ts_segmentation *segmentation = NULL;
  double *positions = NULL, *clicks = NULL;
  uint32_t *triangles = NULL, *labels = NULL, vertices, faces, proposed, click;
  int result = 1;

  TRY(tsa_options_init(&options, sizeof options));
  options.triangles = 6000;
  TRY(tsa_create(&options, &arch));
  TRY(tsa_get_positions(arch, NULL, 0, &vertices));
  TRY(tsa_get_triangles(arch, NULL, 0, &faces));
  positions = malloc(3 * sizeof *positions * vertices);
  triangles = malloc(3 * sizeof *triangles * faces);
  labels = malloc(sizeof *labels * faces);
  if (!positions || !triangles || !labels) goto failed;
  TRY(tsa_get_positions(arch, positions, vertices, &vertices));
  TRY(tsa_get_triangles(arch, triangles, faces, &faces));

  TRY(ts_context_create(NULL, &context));
  TRY(ts_mesh_input_init(&mesh, sizeof mesh));
  mesh.scalar = TS_FLOAT64;
  mesh.positions = positions;
  mesh.vertex_count = vertices;
  mesh.triangles = triangles;
  mesh.triangle_count = faces;
  TRY(ts_model_create(context, &mesh, NULL, NULL, &model));
  TRY(ts_detect_features(model, NULL, NULL, &features));
  TRY(ts_segmentation_create(features, NULL, NULL, &segmentation));
  TRY(ts_propose_clicks(segmentation, NULL, 0, &proposed));
  clicks = malloc(3 * sizeof *clicks * proposed);
  if (!clicks) goto failed;
  TRY(ts_propose_clicks(segmentation, clicks, proposed, NULL));
  TRY(ts_segment_click(segmentation, clicks, NULL, &click));
  TRY(ts_get_labels(segmentation, labels, faces, NULL));
  print_summary(labels, faces);
  result = 0;
failed:
  if (result) fprintf(stderr, "count_labels: %s%s\n", ts_last_error_message(), tsa_last_error_message());
  free(labels);
  free(clicks);
  free(triangles);
  free(positions);
  ts_segmentation_destroy(segmentation);
  ts_features_destroy(features);
  ts_model_destroy(model);
  ts_context_destroy(context);
  tsa_destroy(arch);
  return result;
}
