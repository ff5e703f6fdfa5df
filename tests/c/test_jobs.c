/* Progress and cancellation: a cancelled call leaves everything as it was. SPDX-License-Identifier: Apache-2.0 */
#include <stdlib.h>
#include <string.h>

#include "fixture.h"
#include "harness.h"

typedef struct watcher {
  long calls, stop_at; /* stop_at 0: never */
  double last;
  int fell, outside, nameless;
} watcher;

static int watch(double fraction, const char *stage, void *user) {
  watcher *w = user;
  ++w->calls;
  if (!(fraction >= 0 && fraction <= 1)) ++w->outside;
  if (fraction < w->last) ++w->fell;
  if (stage == NULL || stage[0] == '\0') ++w->nameless;
  w->last = fraction;
  return w->stop_at != 0 && w->calls >= w->stop_at;
}

static void renew(watcher *w, long stop_at) {
  memset(w, 0, sizeof *w);
  w->stop_at = stop_at;
}

static scan s;
static watcher w;
static ts_job *job;

/* The long calls, each into an out-parameter of its own. */
static ts_status create_model(ts_job *j, void **out) {
  const ts_mesh_input input = input_of(&s.arch);
  return ts_model_create(s.context, &input, NULL, j, (ts_model **)out);
}
static ts_status detect(ts_job *j, void **out) {
  return ts_detect_features(s.model, NULL, j, (ts_features **)out);
}
static ts_status prepare(ts_job *j, void **out) {
  return ts_segmentation_create(s.features, NULL, j, (ts_segmentation **)out);
}
static ts_status click(ts_job *j, void **out) {
  uint32_t count = 0, number = 77;
  double *clicks = proposed_clicks(s.segmentation, &count);
  const ts_status status = ts_segment_click(s.segmentation, clicks, j, &number);
  CHECK(status == TS_OK || number == 77);
  free(clicks);
  if (status == TS_OK) *out = NULL;
  return status;
}
static ts_status click_all(ts_job *j, void **out) {
  uint32_t count = 0, i;
  double *clicks = proposed_clicks(s.segmentation, &count);
  ts_status *statuses = must_have(sizeof *statuses * count);
  ts_status status;
  for (i = 0; i < count; ++i) statuses[i] = TS_E_SOLVER;
  status = ts_segment_clicks(s.segmentation, clicks, count, j, statuses);
  for (i = 0; status != TS_OK && i < count; ++i) CHECK(statuses[i] == TS_E_SOLVER);
  free(statuses);
  free(clicks);
  if (status == TS_OK) *out = NULL;
  return status;
}

static void drop(size_t which, void *object) {
  if (which == 0) ts_model_destroy(object);
  if (which == 1) ts_features_destroy(object);
  if (which == 2) ts_segmentation_destroy(object);
}

static const struct {
  const char *name;
  ts_status (*call)(ts_job *, void **);
} calls[] = {{"ts_model_create", create_model},
             {"ts_detect_features", detect},
             {"ts_segmentation_create", prepare},
             {"ts_segment_click", click},
             {"ts_segment_clicks", click_all}};
enum { CALLS = sizeof calls / sizeof calls[0] };

static void progress_rises_to_the_end(void) {
  size_t i;
  for (i = 0; i < CALLS; ++i) {
    void *out = NULL;
    harness_case("%s", calls[i].name);
    renew(&w, 0);
    ts_job_reset(job);
    CHECK_STATUS(calls[i].call(job, &out), TS_OK);
    CHECK(w.calls >= 2);
    CHECK(w.fell == 0 && w.outside == 0 && w.nameless == 0);
    CHECK(w.last == 1);
    CHECK(ts_job_progress(job) == 1);
    drop(i, out);
  }
}

static void make_segmentation_anew(void) {
  ts_segmentation_destroy(s.segmentation);
  s.segmentation = NULL;
  if (ts_segmentation_create(s.features, NULL, NULL, &s.segmentation) != TS_OK) exit(3);
}

#ifdef TS_SANITIZED
enum { RARER = 2 }; /* ten times as slow */
#else
enum { RARER = 8 };
#endif
/* Stopped at the first callback, the second, and so on: nothing has changed each time. */
static void stopped_at_any_callback(void) {
  size_t i;
  for (i = 0; i < CALLS; ++i) {
    char mark;
    bytes before;
    long whole, at;
    void *out = NULL;
    make_segmentation_anew();
    renew(&w, 0);
    ts_job_reset(job);
    harness_case("%s", calls[i].name);
    if (!CHECK_STATUS(calls[i].call(job, &out), TS_OK)) continue;
    drop(i, out);
    whole = w.calls;
    make_segmentation_anew();
    before = dump_segmentation(s.segmentation);
    for (at = 1; at <= whole; at += 1 + at / RARER) {
      bytes after;
      ts_status status;
      harness_case("%s stopped at callback %ld of %ld", calls[i].name, at, whole);
      out = &mark;
      renew(&w, at);
      ts_job_reset(job);
      status = calls[i].call(job, &out);
      if (status == TS_OK && w.calls < at) { /* threads that report together call back less often */
        drop(i, out);
        make_segmentation_anew();
        continue;
      }
      CHECK_STATUS(status, TS_E_CANCELLED);
      CHECK(out == &mark);
      CHECK(w.calls == at);
      after = dump_segmentation(s.segmentation);
      CHECK(same_bytes(&before, &after));
      free_bytes(&after);
    }
    free_bytes(&before);
  }
}

/* Nobody watches: the job serves to cancel only. */
static void cancel_sticks_until_reset(void) {
  ts_job *silent = NULL;
  size_t i;
  REQUIRE_STATUS(ts_job_create(s.context, NULL, NULL, &silent), TS_OK);
  CHECK(ts_job_progress(silent) == 0);
  ts_job_cancel(silent);
  for (i = 0; i < CALLS; ++i) {
    char mark;
    void *out = &mark;
    harness_case("%s", calls[i].name);
    CHECK_STATUS(calls[i].call(silent, &out), TS_E_CANCELLED);
    CHECK_STATUS(calls[i].call(silent, &out), TS_E_CANCELLED);
    CHECK(out == &mark);
  }
  ts_job_reset(silent);
  for (i = 0; i < CALLS; ++i) {
    void *out = NULL;
    harness_case("%s after reset", calls[i].name);
    CHECK_STATUS(calls[i].call(silent, &out), TS_OK);
    drop(i, out);
  }
  ts_job_destroy(silent);
}

static int cancel_from_within(double fraction, const char *stage, void *user) {
  (void)stage;
  if (fraction > 0.3) ts_job_cancel(*(ts_job **)user);
  return 0;
}

/* ts_job_cancel may come at any time, from the callback too. */
static void cancelled_while_running(void) {
  ts_job *own = NULL;
  ts_features *features = NULL;
  REQUIRE_STATUS(ts_job_create(s.context, cancel_from_within, &own, &own), TS_OK);
  CHECK_STATUS(ts_detect_features(s.model, NULL, own, &features), TS_E_CANCELLED);
  CHECK(features == NULL);
  ts_job_destroy(own);
}

static void with_threads(uint32_t threads) {
  s = make_scan(10000, threads);
  if (ts_job_create(s.context, watch, &w, &job) != TS_OK) exit(3);
  RUN(progress_rises_to_the_end);
  RUN(stopped_at_any_callback);
  RUN(cancel_sticks_until_reset);
  RUN(cancelled_while_running);
  ts_job_destroy(job);
  free_scan(&s);
}

int main(void) {
#ifndef __SANITIZE_THREAD__ /* it would see nothing there */
  with_threads(1);
#endif
  with_threads(4);
  return harness_finish();
}
