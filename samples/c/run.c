/* The way through the library: context, model, features, segmentation, clicks. SPDX-License-Identifier: Apache-2.0 */
#include "run.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "complain.h"
#include "utf8.h"

int complain_status(const char *where, ts_status status) {
  return complain("%s: %s: %s", where, ts_status_name(status), ts_last_error_message());
}

/* What the library warns of must not need a report to be seen. */
static void pass_on(ts_log_level level, const char *text, void *scan) {
  if (level == TS_LOG_WARNING) complain("%s: %s", (const char *)scan, text);
}

static ts_status make_context(const options *o, ts_context **out) {
  ts_context_options c;
  ts_status status = ts_context_options_init(&c, sizeof c);
  if (status != TS_OK) return status;
  c.threads = o->threads;
  c.log = pass_on;
  c.log_user = (void *)o->scan;
  return ts_context_create(&c, out);
}

static ts_status load(const options *o, ts_context *context, ts_model **out) {
  ts_intake_options intake;
  ts_status status = ts_intake_options_init(&intake, sizeof intake);
  if (status != TS_OK) return status;
  intake.unit = o->unit;
  return ts_model_load(context, o->scan, &intake, NULL, out);
}

static ts_status prepare(const options *o, const ts_features *features, ts_segmentation **out) {
  ts_segment_options segment;
  ts_status status = ts_segment_options_init(&segment, sizeof segment, o->preset);
  int i;
  if (status != TS_OK) return status;
  for (i = 0; i < o->setting_count; ++i) settings_apply(o->settings[i], &segment);
  return ts_segmentation_create(features, &segment, NULL, out);
}

static int is_there(const char *path) {
  FILE *file = path == NULL ? NULL : utf8_fopen(path, "rb");
  if (file == NULL) return 0;
  fclose(file);
  return 1;
}

int run_prepare(run *r) {
  const char *scan = r->options->scan;
  ts_status status = make_context(r->options, &r->context);
  if (status == TS_OK) status = load(r->options, r->context, &r->model);
  if (status == TS_OK && is_there(r->options->session)) {
    status = ts_session_load(r->model, r->options->session, NULL, &r->features, &r->segmentation);
    return status == TS_OK ? 1 : complain_status(r->options->session, status);
  }
  if (status == TS_OK) status = ts_detect_features(r->model, NULL, NULL, &r->features);
  if (status == TS_OK) status = prepare(r->options, r->features, &r->segmentation);
  return status == TS_OK ? 1 : complain_status(scan, status);
}

/* Clicks for the user, after those there are: the fewest that cover what is not separated yet. */
static int propose(run *r) {
  uint32_t count = 0, i;
  double *xyz;
  click *more;
  ts_status status = ts_propose_clicks(r->segmentation, NULL, 0, &count);
  if (status != TS_OK) return complain_status(r->options->scan, status);
  xyz = malloc((size_t)count * 3 * sizeof *xyz + 1);
  more = realloc(r->clicks, ((size_t)r->click_count + count + 1) * sizeof *more);
  if (more != NULL) r->clicks = more;
  if (xyz == NULL || more == NULL) {
    free(xyz);
    return complain("%s: out of memory", r->options->scan);
  }
  status = ts_propose_clicks(r->segmentation, xyz, count, &count);
  if (status == TS_OK) {
    memset(more + r->click_count, 0, (size_t)count * sizeof *more);
    for (i = 0; i < count; ++i) memcpy(more[r->click_count + i].position, xyz + 3 * (size_t)i, 3 * sizeof *xyz);
    r->click_count += count;
  }
  free(xyz);
  return status == TS_OK ? 1 : complain_status(r->options->scan, status);
}

static ts_status cut_length(const ts_segmentation *segmentation, uint32_t tooth, double *length) {
  ts_tooth_info info;
  uint32_t loop;
  ts_status status;
  *length = 0;
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  status = ts_get_tooth(segmentation, tooth, &info);
  for (loop = 0; status == TS_OK && loop < info.loops; ++loop) {
    ts_cut_info cut;
    uint32_t points;
    memset(&cut, 0, sizeof cut);
    cut.struct_size = sizeof cut;
    status = ts_get_cut(segmentation, tooth, loop, &cut, NULL, 0, &points);
    if (status == TS_OK) *length += cut.length;
  }
  return status;
}

/* What the click did, while its cuts are still its own: a later click may separate the same tooth again. */
static ts_status describe(const ts_segmentation *segmentation, uint32_t number, click *c) {
  ts_status status;
  c->info.struct_size = sizeof c->info;
  status = ts_get_click(segmentation, number, &c->info);
  if (status == TS_OK) status = cut_length(segmentation, c->info.target, &c->target_length);
  if (status == TS_OK && c->info.neighbour != TS_NONE) {
    status = cut_length(segmentation, c->info.neighbour, &c->neighbour_length);
    if (status != TS_E_NOT_FOUND) return status;
    c->neighbour_length = 0; /* the click stands, but no cut was found for the neighbour */
    status = TS_OK;
  }
  return status;
}

static void note_failure(run *r, click *c) {
  char where[64];
  snprintf(c->message, sizeof c->message, "%s", ts_last_error_message());
  ++r->failed;
  if (c->line != 0)
    snprintf(where, sizeof where, ":%u", c->line);
  else
    snprintf(where, sizeof where, ": proposed click %lu", (unsigned long)(c - r->clicks) + 1);
  complain("%s%s: (%g %g %g): %s: %s", c->line != 0 ? r->options->clicks : r->options->scan, where, c->position[0],
           c->position[1], c->position[2], ts_status_name(c->status), c->message);
}

/* A click that fails for its own sake leaves the others standing; a lack of memory does not. */
static int is_about_the_click(ts_status status) {
  return status == TS_E_CLICK_OFF_SURFACE || status == TS_E_CLICK_ON_GINGIVA || status == TS_E_NO_CUT ||
         status == TS_E_INVALID_ARGUMENT || status == TS_E_LOCKED;
}

/* All teeth separated, along the arch. */
static int collect_teeth(run *r) {
  uint32_t count = 0, i;
  uint32_t *ids = NULL;
  ts_status status = ts_get_teeth(r->segmentation, NULL, 0, &count);
  if (status != TS_OK) return complain_status(r->options->scan, status);
  ids = malloc((size_t)count * sizeof *ids + 1);
  r->teeth = calloc((size_t)count + 1, sizeof *r->teeth);
  if (ids == NULL || r->teeth == NULL) {
    free(ids);
    return complain("%s: out of memory", r->options->scan);
  }
  status = ts_get_teeth(r->segmentation, ids, count, &count);
  for (i = 0; status == TS_OK && i < count; ++i) {
    r->teeth[i].struct_size = sizeof r->teeth[i];
    status = ts_get_tooth(r->segmentation, ids[i], &r->teeth[i]);
  }
  free(ids);
  r->tooth_count = count;
  return status == TS_OK ? 1 : complain_status(r->options->scan, status);
}

/* The clicks from `first` on, one after the other and not with ts_segment_clicks, for the message of each that fails.
 */
static int click_from(run *r, uint32_t first) {
  uint32_t i;
  for (i = first; i < r->click_count; ++i) {
    click *c = &r->clicks[i];
    uint32_t number = TS_NONE;
    c->status = ts_segment_click(r->segmentation, c->position, NULL, &number);
    if (c->status == TS_OK) {
      const ts_status status = describe(r->segmentation, number, c);
      if (status != TS_OK) return complain_status(r->options->scan, status);
    } else if (is_about_the_click(c->status)) {
      note_failure(r, c);
    } else {
      return complain_status(r->options->scan, c->status);
    }
  }
  return 1;
}

/* Proposes until nothing is left, or until a round separates nothing more. */
static int click_for_user(run *r) {
  uint32_t before, now = 0;
  do {
    const uint32_t first = r->click_count;
    before = now;
    if (!propose(r) || !click_from(r, first)) return 0;
    if (r->click_count == first) return 1;
    if (ts_get_teeth(r->segmentation, NULL, 0, &now) != TS_OK) return complain_status(r->options->scan, TS_E_INTERNAL);
  } while (now > before);
  return 1;
}

int run_click(run *r) {
  return (r->options->clicks == NULL ? click_for_user(r) : click_from(r, 0)) && collect_teeth(r);
}

static ts_status assign_numbers(run *r) {
  ts_number_options o;
  ts_status status = ts_number_options_init(&o, sizeof o);
  if (status != TS_OK) return status;
  o.jaw = r->options->jaw;
  status = ts_assign_numbers(r->segmentation, &o);
  r->jaw.struct_size = sizeof r->jaw;
  return status == TS_OK ? ts_get_jaw(r->segmentation, &r->jaw) : status;
}

int run_number(run *r) {
  const options *o = r->options;
  ts_status status;
  uint32_t i;
  if (!o->fdi && o->json3dts == NULL && o->jaw == TS_JAW_UNKNOWN) return 1;
  r->numbers = calloc((size_t)r->tooth_count + 1, sizeof *r->numbers);
  if (r->numbers == NULL) return complain("%s: out of memory", o->scan);
  status = assign_numbers(r);
  if (status == TS_OK && r->jaw.uncertain)
    return complain("%s: the jaw cannot be told from the scan (%s with a confidence of %.2f): --jaw says which it is",
                    o->scan, r->jaw.jaw == TS_JAW_UPPER ? "upper" : "lower", r->jaw.confidence);
  for (i = 0; status == TS_OK && i < r->tooth_count; ++i) {
    ts_number_info *n = &r->numbers[i];
    n->struct_size = sizeof *n;
    status = ts_get_number(r->segmentation, r->teeth[i].id, n);
    if (status == TS_OK && n->uncertain)
      complain("%s: tooth %lu: number %lu is uncertain (confidence %.2f)", o->scan, (unsigned long)r->teeth[i].label,
               (unsigned long)n->fdi, n->confidence);
  }
  return status == TS_OK ? 1 : complain_status(o->scan, status);
}

void run_close(run *r) {
  ts_segmentation_destroy(r->segmentation);
  ts_features_destroy(r->features);
  ts_model_destroy(r->model);
  ts_context_destroy(r->context);
  free(r->clicks);
  free(r->teeth);
  free(r->numbers);
}
