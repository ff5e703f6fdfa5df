/* What the bindings' overhead programs measure, in C, to compare with: overhead SCAN, in JSON. overhead.sh runs all.
 * SPDX-License-Identifier: Apache-2.0 */
#define _POSIX_C_SOURCE 200112L
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <toothseg.h>

enum { CALLS = 300000, READS = 50 };

static double now_ms(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return 1e3 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;
}

static int rising(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* Into new memory each time, as a layer that returns arrays does, or all into the same. */
static double median_ms(const ts_segmentation *segmentation, uint32_t count, uint32_t *room) {
  double times[READS];
  int i;
  for (i = 0; i < READS; ++i) {
    const double begin = now_ms();
    uint32_t *labels = room;
    if (room == NULL) labels = calloc(count, sizeof *labels);
    if (labels == NULL || ts_get_labels(segmentation, labels, count, &count) != TS_OK) exit(1);
    if (room == NULL) free(labels);
    times[i] = now_ms() - begin;
  }
  qsort(times, READS, sizeof *times, rising);
  return (times[READS / 2 - 1] + times[READS / 2]) / 2;
}

int main(int argc, char **argv) {
  ts_context *context;
  ts_model *model;
  ts_features *features;
  ts_segmentation *segmentation;
  uint32_t count, universal, *room;
  double begin, ns;
  int i;
  if (argc != 2 || ts_context_create(NULL, &context) != TS_OK ||
      ts_model_load(context, argv[1], NULL, NULL, &model) != TS_OK ||
      ts_detect_features(model, NULL, NULL, &features) != TS_OK ||
      ts_segmentation_create(features, NULL, NULL, &segmentation) != TS_OK ||
      ts_segment_all(segmentation, NULL) != TS_OK || ts_get_labels(segmentation, NULL, 0, &count) != TS_OK ||
      (room = malloc(count * sizeof *room)) == NULL)
    return fprintf(stderr, "overhead: %s\n", ts_last_error_message()), 1;
  begin = now_ms();
  for (i = 0; i < CALLS; ++i)
    if (ts_fdi_to_universal(36, &universal) != TS_OK) return 1;
  ns = (now_ms() - begin) * 1e6 / CALLS;
  printf("{\"faces\":%lu,\"call_ns\":%.0f,\"labels_ms\":%.3f,", (unsigned long)count, ns,
         median_ms(segmentation, count, NULL));
  printf("\"labels_into_ms\":%.3f}\n", median_ms(segmentation, count, room));
  free(room);
  ts_segmentation_destroy(segmentation);
  ts_features_destroy(features);
  ts_model_destroy(model);
  ts_context_destroy(context);
  return 0;
}
