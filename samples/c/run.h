/* What a run of ts-segment holds: the scan, the clicks made on it and what came of them.
 * SPDX-License-Identifier: Apache-2.0 */
#ifndef RUN_H
#define RUN_H

#include <toothseg.h>

#include "options.h"

typedef struct click {
  double position[3];
  unsigned line; /* in the file of clicks; 0: proposed by the library */
  ts_status status;
  char message[256]; /* of a failed click */
  ts_click_info info;
  double target_length, neighbour_length; /* of their cuts when the click was made, mm; 0: no cut */
} click;

typedef struct run {
  const options *options;
  ts_context *context;
  ts_model *model;
  ts_features *features;
  ts_segmentation *segmentation;
  click *clicks;
  uint32_t click_count, failed;
  ts_tooth_info *teeth; /* along the arch, once all clicks are made */
  uint32_t tooth_count;
  ts_number_info *numbers; /* of the teeth; NULL: not wanted */
  ts_jaw_info jaw;         /* that they are of */
} run;

/* Reads the file of clicks. 0, with a complaint, if it cannot be read, has a bad line or no click. */
int clicks_read(const char *path, click **clicks, uint32_t *count);

/* Each returns 0, with a complaint, if it failed. */
int run_prepare(run *r);
int run_click(run *r);  /* clicks that fail are complained about and noted in r->failed */
int run_number(run *r); /* where numbers are wanted; those that are uncertain are complained about */
void run_close(run *r);

/* Complains in the library's words about a call that failed. Always 0. */
int complain_status(const char *where, ts_status status);

#endif
