/* What overhead.py measures, in C: overhead SCAN prints ns a no-op call, the number of faces and ms a read-back of
 * their labels. SPDX-License-Identifier: Apache-2.0 */
#define _POSIX_C_SOURCE 199309L
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <toothseg.h>

enum { CALLS = 500, BATCHES = 400, RUNS = 50 };

static double seconds(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int ascending(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

int main(int argc, char **argv) {
  ts_context *context = NULL;
  ts_model *model = NULL;
  ts_features *features = NULL;
  ts_segmentation *segmentation = NULL;
  double runs[RUNS], start, batch = 1;
  uint32_t universal, count = 0, i, k;
  if (argc != 2 || ts_context_create(NULL, &context) != TS_OK ||
      ts_model_load(context, argv[1], NULL, NULL, &model) != TS_OK ||
      ts_detect_features(model, NULL, NULL, &features) != TS_OK ||
      ts_segmentation_create(features, NULL, NULL, &segmentation) != TS_OK ||
      ts_segment_all(segmentation, NULL) != TS_OK)
    return fprintf(stderr, "overhead: %s\n", ts_last_error_message()), 1;
  for (k = 0; k < BATCHES; ++k) {
    start = seconds();
    for (i = 0; i < CALLS; ++i)
      if (ts_fdi_to_universal(11, &universal) != TS_OK) return 1;
    if (seconds() - start < batch) batch = seconds() - start;
  }
  printf("%.1f", batch * 1e9 / CALLS);
  for (i = 0; i < RUNS; ++i) {
    uint32_t *labels;
    start = seconds();
    if (ts_get_labels(segmentation, NULL, 0, &count) != TS_OK || (labels = malloc(sizeof *labels * count)) == NULL ||
        ts_get_labels(segmentation, labels, count, &count) != TS_OK)
      return 1;
    free(labels);
    runs[i] = (seconds() - start) * 1e3;
  }
  qsort(runs, RUNS, sizeof *runs, ascending);
  printf(" %lu %.4f\n", (unsigned long)count, runs[RUNS / 2]);
  ts_segmentation_destroy(segmentation);
  ts_features_destroy(features);
  ts_model_destroy(model);
  ts_context_destroy(context);
  return 0;
}
