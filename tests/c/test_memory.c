/* What is kept, a cap on it, and batches of any size. SPDX-License-Identifier: Apache-2.0 */
#include <stdlib.h>
#include <string.h>

#include "fixture.h"
#include "harness.h"

static scan s;

static ts_memory_info memory_of(const ts_segmentation *segmentation) {
  ts_memory_info m;
  memset(&m, 0, sizeof m);
  m.struct_size = (uint32_t)sizeof m;
  CHECK_STATUS(ts_get_memory(segmentation, &m), TS_OK);
  return m;
}

static ts_status create_with(uint64_t limit, ts_segmentation **out) {
  ts_segment_options options;
  CHECK_STATUS(ts_segment_options_init(&options, (uint32_t)sizeof options, TS_PRESET_DEFAULT), TS_OK);
  CHECK(options.memory_limit == 0);
  options.memory_limit = limit;
  return ts_segmentation_create(s.features, &options, NULL, out);
}

static void click_all(ts_segmentation *segmentation) {
  uint32_t n = 0;
  double *clicks = proposed_clicks(segmentation, &n);
  CHECK_STATUS(ts_segment_clicks(segmentation, clicks, n, NULL, NULL), TS_OK);
  free(clicks);
}

static void what_is_kept(void) {
  const ts_memory_info m = memory_of(s.segmentation);
  CHECK(m.model > 50u * s.arch.faces && m.model < 400u * s.arch.faces);
  CHECK(m.segmentation > m.factor && m.factor == m.factor_whole);
  CHECK(m.factor > 100u * s.arch.vertices && m.factor < 2000u * s.arch.vertices);
  CHECK(m.click > s.arch.faces);
}

static void less_memory_gives_the_same_bytes(void) {
  static const double shares[] = {0.95, 0.6, 0.3};
  const ts_memory_info whole = memory_of(s.segmentation);
  bytes expected;
  size_t i;
  click_all(s.segmentation);
  expected = dump_segmentation(s.segmentation);
  for (i = 0; i < sizeof shares / sizeof shares[0]; ++i) {
    const uint64_t limit = whole.segmentation - (uint64_t)((1 - shares[i]) * (double)whole.factor_whole);
    ts_segmentation *small = NULL;
    harness_case("%g of the factor", shares[i]);
    if (CHECK_STATUS(create_with(limit, &small), TS_OK)) {
      const ts_memory_info m = memory_of(small);
      bytes got;
      CHECK(m.segmentation <= limit);
      CHECK(m.factor < m.factor_whole);
      click_all(small);
      got = dump_segmentation(small);
      CHECK(same_bytes(&expected, &got));
      free_bytes(&got);
    }
    ts_segmentation_destroy(small);
  }
  harness_case(NULL);
  free_bytes(&expected);
}

static void too_little_is_refused(void) {
  ts_segmentation *const untouched = (ts_segmentation *)&s;
  const ts_memory_info whole = memory_of(s.segmentation);
  const uint64_t limits[] = {1, whole.segmentation / 100, whole.segmentation - whole.factor_whole};
  size_t i;
  for (i = 0; i < sizeof limits / sizeof limits[0]; ++i) {
    ts_segmentation *out = untouched;
    harness_case("limit %lu", (unsigned long)limits[i]);
    CHECK_STATUS(create_with(limits[i], &out), TS_E_OUT_OF_MEMORY);
    CHECK(out == untouched);
    CHECK(strstr(ts_last_error_message(), "memory_limit") != NULL);
  }
  harness_case(NULL);
}

/* Ten thousand clicks on two places, one twice in a row and the other between. */
static void a_batch_of_ten_thousand(void) {
#ifdef TS_SANITIZED
  enum { count = 1000 }; /* ten times as slow */
#else
  enum { count = 10000 };
#endif
  scan small = make_scan(5000, 2);
  uint32_t n = 0, i, failed = 0;
  double *clicks = must_have(3 * count * sizeof *clicks), *places = proposed_clicks(small.segmentation, &n);
  ts_status *statuses = must_have(count * sizeof *statuses);
  ts_segmentation *few = NULL;
  ts_memory_info m;
  CHECK(n >= 2);
  for (i = 0; i < 3 * count; ++i) clicks[i] = places[(i / 3 % 3 == 2 ? 3 : 0) + i % 3];
  CHECK_STATUS(ts_segment_clicks(small.segmentation, clicks, count, NULL, statuses), TS_OK);
  for (i = 0; i < count; ++i) failed += statuses[i] != TS_OK;
  CHECK(failed == 0);
  CHECK_STATUS(ts_get_click_count(small.segmentation, &n), TS_OK);
  CHECK(n == count);
  /* The teeth are those of the first few. */
  CHECK_STATUS(ts_segmentation_create(small.features, NULL, NULL, &few), TS_OK);
  CHECK_STATUS(ts_segment_clicks(few, clicks, 3, NULL, NULL), TS_OK);
  {
    uint32_t *a = must_have(small.arch.faces * sizeof *a), *b = must_have(small.arch.faces * sizeof *b);
    CHECK_STATUS(ts_get_labels(few, a, small.arch.faces, &n), TS_OK);
    CHECK_STATUS(ts_get_labels(small.segmentation, b, small.arch.faces, &n), TS_OK);
    CHECK(memcmp(a, b, small.arch.faces * sizeof *a) == 0);
    free(a);
    free(b);
  }
  m = memory_of(small.segmentation);
  CHECK(m.segmentation == memory_of(few).segmentation);
  ts_segmentation_destroy(few);
  free(statuses);
  free(clicks);
  free(places);
  free_scan(&small);
}

int main(void) {
  s = make_scan(LARGE, 2);
  RUN(what_is_kept);
  RUN(less_memory_gives_the_same_bytes);
  RUN(too_little_is_refused);
  RUN(a_batch_of_ten_thousand);
  free_scan(&s);
  return harness_finish();
}
