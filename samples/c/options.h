/* The command line of ts-segment. SPDX-License-Identifier: Apache-2.0 */
#ifndef OPTIONS_H
#define OPTIONS_H

#include "settings.h"

typedef struct options {
  const char *scan;
  const char *clicks;                                  /* NULL: the library proposes them */
  const char *labels, *cuts, *ply, *report, *features; /* outputs; NULL: not wanted */
  const char *json3dts;
  const char *session; /* in, where it is there, and out */
  const char *teeth;   /* directory for a mesh a tooth; NULL: not wanted */
  int closed;          /* of these meshes: all rims */
  ts_preset preset;
  ts_unit unit;
  uint32_t threads;
  const char *settings[SETTINGS_MOST]; /* NAME=VALUE of ts_segment_options, over the preset */
  int setting_count;
  int fdi;    /* numbers in labels are FDI */
  ts_jaw jaw; /* TS_JAW_UNKNOWN: estimated where numbers are wanted */
} options;

typedef enum options_result { OPTIONS_RUN, OPTIONS_DONE, OPTIONS_BAD } options_result;

/* OPTIONS_DONE: --help or --version was asked for and has been printed. OPTIONS_BAD: complained. */
options_result options_parse(int argc, char **argv, options *out);

#endif
