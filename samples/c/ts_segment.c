/* ts-segment: the whole library as a command. SPDX-License-Identifier: Apache-2.0
 *
 * Plain C99 against toothseg.h alone: options.c reads the command line, clicks.c the clicks, run.c goes the way through
 * the library, writers.c, json3dts.c, teeth.c and report.c write what came of it, staging.c sees to it that the outputs
 * are all there or not at all. */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "complain.h"
#include "options.h"
#include "run.h"
#include "staging.h"
#include "teeth.h"
#include "writers.h"

enum { EXIT_DONE = 0, EXIT_CLICK_FAILED = 1, EXIT_NOTHING_WRITTEN = 2 };

int complain(const char *format, ...) {
  char text[4096];
  char *c;
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  for (c = text; *c != '\0'; ++c)
    if (*c == '\n' || *c == '\r') *c = '?'; /* of a file's name: a complaint is one line */
  fprintf(stderr, "ts-segment: %s\n", text);
  return 0;
}

static int announce(const options *o, staging *s) {
  const char *const outputs[] = {o->labels, o->cuts, o->ply, o->report, o->features, o->json3dts, o->session};
  const char *const inputs[] = {o->scan, o->clicks};
  return staging_announce(s, outputs, 7, inputs, 2);
}

static int write_one(const run *r, staging *s, const char *path, int (*write)(const run *, FILE *)) {
  FILE *file;
  if (path == NULL) return 1;
  file = staging_open(s, path);
  return file != NULL && write(r, file);
}

static int write_all(run *r, const teeth_files *teeth, staging *s) {
  const options *o = r->options;
  return teeth_write(r, teeth, s) && write_one(r, s, o->labels, write_labels) && write_one(r, s, o->cuts, write_cuts) &&
         write_one(r, s, o->ply, write_ply) && write_one(r, s, o->report, write_report) &&
         write_one(r, s, o->features, write_features) && write_one(r, s, o->json3dts, write_json3dts) &&
         write_one(r, s, o->session, write_session) && staging_commit(s);
}

static int segment(const options *o) {
  int good;
  run r;
  staging outputs;
  teeth_files teeth;
  memset(&r, 0, sizeof r);
  memset(&teeth, 0, sizeof teeth);
  memset(&outputs, 0, sizeof outputs);
  r.options = o;
  good = announce(o, &outputs) && teeth_announce_gingiva(o, &teeth, &outputs) &&
         (o->clicks == NULL || clicks_read(o->clicks, &r.clicks, &r.click_count)) && run_prepare(&r) && run_click(&r) &&
         run_number(&r) && teeth_announce_all(&r, &teeth, &outputs) && write_all(&r, &teeth, &outputs);
  staging_close(&outputs);
  teeth_close(&teeth);
  if (good)
    printf("%s: %lu teeth from %lu clicks, %lu failed\n", o->scan, (unsigned long)r.tooth_count,
           (unsigned long)r.click_count, (unsigned long)r.failed);
  run_close(&r);
  if (!good) return EXIT_NOTHING_WRITTEN;
  return r.failed != 0 ? EXIT_CLICK_FAILED : EXIT_DONE;
}

int main(int argc, char **argv) {
  options o;
  switch (options_parse(argc, argv, &o)) {
    case OPTIONS_RUN: return segment(&o);
    case OPTIONS_DONE: return EXIT_DONE;
    default: return EXIT_NOTHING_WRITTEN;
  }
}
