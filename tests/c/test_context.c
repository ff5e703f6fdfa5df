/* Contexts, hooks, lifetimes. SPDX-License-Identifier: Apache-2.0 */
#include <stdlib.h>
#include <string.h>

#include "fixture.h"
#include "harness.h"

/* Memory that is counted and can be made to run out. Used with one thread only. */
typedef struct memory {
  long blocks;   /* not yet given back */
  long taken;    /* ever */
  long fails_at; /* the number of the allocation that fails; 0: none */
  int misaligned, strangers;
} memory;

/* Stands before each block, 16 bytes long at least, and tells blocks of ours from others. */
typedef union head {
  unsigned long magic;
  double aligned[4];
} head;
enum { magic = 0x7007 };

static void *take(size_t size, void *user) {
  memory *m = user;
  head *h;
  if (++m->taken == m->fails_at) return NULL;
  h = malloc(sizeof *h + size);
  if (h == NULL) return NULL;
  h->magic = magic;
  ++m->blocks;
  if ((uintptr_t)(h + 1) % 16 != 0) ++m->misaligned;
  return h + 1;
}

static void give(void *block, void *user) {
  memory *m = user;
  head *h = (head *)block - 1;
  if (block == NULL) return;
  if (h->magic != magic) {
    ++m->strangers;
    return;
  }
  h->magic = 0;
  --m->blocks;
  free(h);
}

static ts_context *context_with(memory *m) {
  ts_context_options options;
  ts_context *context = NULL;
  memset(m, 0, sizeof *m);
  if (!CHECK_STATUS(ts_context_options_init(&options, sizeof options), TS_OK)) return NULL;
  options.threads = 1;
  options.alloc = take;
  options.free = give;
  options.alloc_user = m;
  CHECK_STATUS(ts_context_create(&options, &context), TS_OK);
  return context;
}

/* ------------------------------------------------------------------------------------------------------- options */

static void defaults(void) {
  ts_context_options o;
  ts_context *context = NULL;
  REQUIRE_STATUS(ts_context_options_init(&o, sizeof o), TS_OK);
  CHECK(o.threads == 0 && o.alloc == NULL && o.free == NULL && o.log == NULL);
  REQUIRE_STATUS(ts_context_create(NULL, &context), TS_OK);
  CHECK(context != NULL);
  ts_context_destroy(context);
}

static void bad_options_are_refused(void) {
  ts_context_options o;
  char mark;
  ts_context *const sentinel = (ts_context *)(void *)&mark;
  ts_context *context = sentinel;
  REQUIRE_STATUS(ts_context_options_init(&o, sizeof o), TS_OK);
  o.threads = 1025;
  CHECK_STATUS(ts_context_create(&o, &context), TS_E_INVALID_ARGUMENT);
  REQUIRE_STATUS(ts_context_options_init(&o, sizeof o), TS_OK);
  o.alloc = take;
  CHECK_STATUS(ts_context_create(&o, &context), TS_E_INVALID_ARGUMENT);
  REQUIRE_STATUS(ts_context_options_init(&o, sizeof o), TS_OK);
  o.free = give;
  CHECK_STATUS(ts_context_create(&o, &context), TS_E_INVALID_ARGUMENT);
  CHECK(context == sentinel);
}

/* ------------------------------------------------------------------------------------------------------ allocator */

/* The whole way; what fails is returned, and nothing of it is left. */
static ts_status whole_way(ts_context *context, const mesh *m, uint32_t *teeth) {
  const ts_mesh_input input = input_of(m);
  ts_model *model = NULL;
  ts_features *features = NULL;
  ts_segmentation *segmentation = NULL;
  double clicks[3 * 64];
  uint32_t n = 0;
  ts_status status = ts_model_create(context, &input, NULL, NULL, &model);
  if (status == TS_OK) status = ts_detect_features(model, NULL, NULL, &features);
  if (status == TS_OK) status = ts_segmentation_create(features, NULL, NULL, &segmentation);
  if (status == TS_OK) status = ts_propose_clicks(segmentation, clicks, 64, &n);
  if (status == TS_OK) status = ts_segment_click(segmentation, clicks, NULL, NULL);
  if (status == TS_OK) status = ts_get_teeth(segmentation, NULL, 0, teeth);
  ts_segmentation_destroy(segmentation);
  ts_features_destroy(features);
  ts_model_destroy(model);
  return status;
}

static void all_memory_is_given_back(void) {
  memory m;
  mesh arch = make_arch(10000);
  uint32_t teeth = 0;
  ts_context *context = context_with(&m);
  CHECK_STATUS(whole_way(context, &arch, &teeth), TS_OK);
  CHECK(teeth == 2);
  ts_context_destroy(context);
  CHECK(m.taken > 10);
  CHECK(m.blocks == 0);
  CHECK(m.misaligned == 0 && m.strangers == 0);
  free_mesh(&arch);
}

/* Each of the first allocations fails once, then ever rarer ones up to the last: a status and no leak each time, and
 * the same context does its work afterwards. */
#ifdef TS_SANITIZED
enum { RARER = 1 }; /* ten times as slow; test_faults has all of them */
#else
enum { RARER = 4 };
#endif
static void running_out_of_memory_is_a_status(void) {
  memory m;
  mesh arch = make_arch(5000);
  uint32_t teeth = 0;
  long n, whole;
  ts_context *context = context_with(&m);
  REQUIRE_STATUS(whole_way(context, &arch, &teeth), TS_OK);
  whole = m.taken;
  for (n = 1; n <= whole; n += 1 + n / RARER) {
    harness_case("allocation %ld of %ld fails", n, whole);
    m.taken = 0;
    m.fails_at = n;
    CHECK_STATUS(whole_way(context, &arch, &teeth), TS_E_OUT_OF_MEMORY);
    CHECK(m.blocks == 0);
  }
  harness_case(NULL);
  m.fails_at = 0;
  CHECK_STATUS(whole_way(context, &arch, &teeth), TS_OK);
  ts_context_destroy(context);
  CHECK(m.blocks == 0 && m.strangers == 0);
  free_mesh(&arch);
}

/* A click that finds no memory leaves the segmentation as it was. */
static void a_failed_click_changes_nothing(void) {
  memory m;
  mesh arch = make_arch(5000);
  ts_context *context = context_with(&m);
  ts_model *model = make_model(context, &arch);
  ts_features *features = NULL;
  ts_segmentation *segmentation = NULL;
  double *clicks = NULL;
  uint32_t count = 0;
  bytes before, after;
  long n;
  REQUIRE_STATUS(ts_detect_features(model, NULL, NULL, &features), TS_OK);
  REQUIRE_STATUS(ts_segmentation_create(features, NULL, NULL, &segmentation), TS_OK);
  clicks = proposed_clicks(segmentation, &count);
  REQUIRE(count >= 2);
  REQUIRE_STATUS(ts_segment_click(segmentation, clicks, NULL, NULL), TS_OK);
  before = dump_segmentation(segmentation);
  for (n = 1; n < 1000; n += 1 + n / 2) {
    ts_status status;
    m.taken = 0;
    m.fails_at = n;
    status = ts_segment_click(segmentation, clicks + 3, NULL, NULL);
    m.fails_at = 0;
    if (status == TS_OK) break; /* it needs fewer than n */
    harness_case("allocation %ld fails", n);
    CHECK_STATUS(status, TS_E_OUT_OF_MEMORY);
    after = dump_segmentation(segmentation);
    CHECK(same_bytes(&before, &after));
    free_bytes(&after);
  }
  harness_case(NULL);
  CHECK(n > 1);
  free_bytes(&before);
  free(clicks);
  ts_segmentation_destroy(segmentation);
  ts_features_destroy(features);
  ts_model_destroy(model);
  ts_context_destroy(context);
  CHECK(m.blocks == 0);
  free_mesh(&arch);
}

/* ------------------------------------------------------------------------------------------------------------ log */

typedef struct log_seen {
  int lines, newlines, bad_levels;
} log_seen;

static void see(ts_log_level level, const char *text, void *user) {
  log_seen *seen = user;
  ++seen->lines;
  if (strchr(text, '\n') != NULL) ++seen->newlines;
  if (level > TS_LOG_INFO) ++seen->bad_levels;
}

static void log_comes_in_lines(void) {
  log_seen seen = {0, 0, 0};
  mesh arch = make_arch(10000);
  uint32_t teeth = 0;
  ts_context_options options;
  ts_context *context = NULL;
  REQUIRE_STATUS(ts_context_options_init(&options, sizeof options), TS_OK);
  options.threads = 1;
  options.log = see;
  options.log_user = &seen;
  REQUIRE_STATUS(ts_context_create(&options, &context), TS_OK);
  CHECK_STATUS(whole_way(context, &arch, &teeth), TS_OK);
  ts_context_destroy(context);
  CHECK(seen.lines > 0);
  CHECK(seen.newlines == 0 && seen.bad_levels == 0);
  free_mesh(&arch);
}

/* ------------------------------------------------------------------------------------------------------ lifetimes */

enum { CONTEXT, MODEL, FEATURES, SEGMENTATION, JOB, HANDLES };

static void destroy(scan *s, ts_job *job, int which) {
  if (which == CONTEXT) ts_context_destroy(s->context);
  if (which == MODEL) ts_model_destroy(s->model);
  if (which == FEATURES) ts_features_destroy(s->features);
  if (which == SEGMENTATION) ts_segmentation_destroy(s->segmentation);
  if (which == JOB) ts_job_destroy(job);
}

static int next_order(int *order) {
  int i = HANDLES - 2, k = HANDLES - 1, swap;
  while (i >= 0 && order[i] > order[i + 1]) --i;
  if (i < 0) return 0;
  while (order[k] < order[i]) --k;
  swap = order[i], order[i] = order[k], order[k] = swap;
  for (++i, k = HANDLES - 1; i < k; ++i, --k) swap = order[i], order[i] = order[k], order[k] = swap;
  return 1;
}

/* All 120 orders; what is left works until it goes. An address sanitizer or the counts find what is wrong. */
static void destroyed_in_any_order(void) {
  int order[HANDLES] = {CONTEXT, MODEL, FEATURES, SEGMENTATION, JOB};
  mesh arch = make_arch(5000);
  do {
    memory m;
    scan s;
    ts_job *job = NULL;
    int i, alive = 1;
    memset(&s, 0, sizeof s);
    s.context = context_with(&m);
    s.model = make_model(s.context, &arch);
    harness_case("order %d %d %d %d %d", order[0], order[1], order[2], order[3], order[4]);
    REQUIRE_STATUS(ts_features_create(s.model, &s.features), TS_OK);
    REQUIRE_STATUS(ts_features_add_point(s.features, arch.xyz, TS_NONE, NULL, NULL), TS_OK);
    REQUIRE_STATUS(ts_features_add_point(s.features, arch.xyz + 3 * 1000, TS_NONE, NULL, NULL), TS_OK);
    REQUIRE_STATUS(ts_job_create(s.context, NULL, NULL, &job), TS_OK);
    REQUIRE_STATUS(ts_segmentation_create(s.features, NULL, job, &s.segmentation), TS_OK);
    for (i = 0; i < HANDLES; ++i) {
      uint32_t labels = 0;
      destroy(&s, job, order[i]);
      if (order[i] == SEGMENTATION) alive = 0;
      if (alive) {
        CHECK_STATUS(ts_get_labels(s.segmentation, NULL, 0, &labels), TS_OK);
        CHECK(labels == arch.faces);
      }
    }
    CHECK(m.blocks == 0);
  } while (next_order(order));
  free_mesh(&arch);
}

/* Two contexts, and two models of one, know nothing of each other. */
static void contexts_are_independent(void) {
  memory a, b;
  mesh arch = make_arch(5000);
  ts_context *first = context_with(&a), *second = context_with(&b);
  ts_model *model = make_model(first, &arch);
  CHECK(a.blocks > 0 && b.blocks == 0);
  ts_context_destroy(first);
  CHECK(a.blocks > 0);
  ts_model_destroy(model);
  CHECK(a.blocks == 0);
  ts_context_destroy(second);
  CHECK(b.taken == 0);
  free_mesh(&arch);
}

int main(void) {
  RUN(defaults);
  RUN(bad_options_are_refused);
  RUN(all_memory_is_given_back);
  RUN(running_out_of_memory_is_a_status);
  RUN(a_failed_click_changes_nothing);
  RUN(log_comes_in_lines);
  RUN(destroyed_in_any_order);
  RUN(contexts_are_independent);
  return harness_finish();
}
