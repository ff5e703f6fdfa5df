/* The same as toothseg/examples/overhead.rs in C, to compare with. SPDX-License-Identifier: Apache-2.0 */
#define _POSIX_C_SOURCE 200112L /* clock_gettime */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <toothseg.h>

#define TRY(call) \
  if ((call) != TS_OK) return fprintf(stderr, "overhead: %s\n", ts_last_error_message()), 1

enum { CALLS = 1000000, TIMES = 50 };

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int compare(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

int main(int argc, char **argv) {
  ts_context *context;
  ts_model *model;
  ts_features *features;
  ts_segmentation *segmentation;
  double start, call_ns, times[TIMES];
  uint32_t universal, faces = 0, i;
  if (argc != 2) return fprintf(stderr, "usage: overhead SCAN\n"), 2;
  start = now();
  for (i = 0; i < CALLS; ++i) TRY(ts_fdi_to_universal(11 + i % 8, &universal));
  call_ns = (now() - start) * 1e9 / CALLS;

  TRY(ts_context_create(NULL, &context));
  TRY(ts_model_load(context, argv[1], NULL, NULL, &model));
  TRY(ts_detect_features(model, NULL, NULL, &features));
  TRY(ts_segmentation_create(features, NULL, NULL, &segmentation));
  TRY(ts_segment_all(segmentation, NULL));
  for (i = 0; i < TIMES; ++i) {
    uint32_t *labels;
    start = now();
    TRY(ts_get_labels(segmentation, NULL, 0, &faces));
    if ((labels = malloc(sizeof *labels * faces)) == NULL) return 1;
    TRY(ts_get_labels(segmentation, labels, faces, &faces));
    times[i] = (now() - start) * 1e3;
    free(labels);
  }
  qsort(times, TIMES, sizeof *times, compare);
  printf("{\"language\": \"c\", \"call_ns\": %.1f, \"labels_ms\": %.3f, \"faces\": %u}\n", call_ns, times[TIMES / 2],
         (unsigned)faces);
  ts_segmentation_destroy(segmentation);
  ts_features_destroy(features);
  ts_model_destroy(model);
  ts_context_destroy(context);
  return 0;
}
