/* The same input gives the same bytes, whatever the number of threads, and again. SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>
#include <string.h>

#include "fixture.h"
#include "harness.h"

typedef struct results {
  bytes features, clicked, clicked_together;
} results;

static results all_of(mesh arch, uint32_t threads) {
  scan s = scan_of(arch, threads);
  ts_segmentation *together = NULL;
  uint32_t n = 0, i;
  double *clicks = proposed_clicks(s.segmentation, &n);
  results r;
  for (i = 0; i < n; ++i) CHECK_STATUS(ts_segment_click(s.segmentation, clicks + 3 * (size_t)i, NULL, NULL), TS_OK);
  CHECK_STATUS(ts_segmentation_create(s.features, NULL, NULL, &together), TS_OK);
  CHECK_STATUS(ts_segment_clicks(together, clicks, n, NULL, NULL), TS_OK);
  r.features = dump_features(s.features);
  r.clicked = dump_segmentation(s.segmentation);
  r.clicked_together = dump_segmentation(together);
  ts_segmentation_destroy(together);
  free(clicks);
  memset(&s.arch, 0, sizeof s.arch); /* the caller's */
  free_scan(&s);
  return r;
}

static void drop(results *r) {
  free_bytes(&r->features);
  free_bytes(&r->clicked);
  free_bytes(&r->clicked_together);
}

/* Large enough that loops are divided among threads. */
static void same_bytes_for_any_number_of_threads(void) {
#if defined(__SANITIZE_THREAD__)
  static const uint32_t threads[] = {4};
#elif defined(TS_SANITIZED)
  static const uint32_t threads[] = {3, 8};
#else
  static const uint32_t threads[] = {2, 3, 8, 8};
#endif
  mesh arch = make_arch(LARGE);
  results one = all_of(arch, 1);
  size_t i;
  CHECK(one.features.size > 1000 && one.clicked.size > 100000);
  CHECK(same_bytes(&one.clicked, &one.clicked_together));
  for (i = 0; i < sizeof threads / sizeof threads[0]; ++i) {
    results many = all_of(arch, threads[i]);
    harness_case("%lu threads", (unsigned long)threads[i]);
    CHECK(same_bytes(&one.features, &many.features));
    CHECK(same_bytes(&one.clicked, &many.clicked));
    CHECK(same_bytes(&one.clicked, &many.clicked_together));
    drop(&many);
  }
  drop(&one);
  free_mesh(&arch);
}

int main(void) {
  RUN(same_bytes_for_any_number_of_threads);
  return harness_finish();
}
