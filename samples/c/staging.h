/* Several output files that come into being together or not at all. SPDX-License-Identifier: Apache-2.0
 *
 * Each is written to a temporary file beside its place. staging_commit puts all of them in place; where that fails half
 * way, what was there before is put back. */
#ifndef STAGING_H
#define STAGING_H

#include <stdio.h>

#define STAGING_MOST 128

typedef struct staged_file {
  const char *path; /* the caller's */
  char *temporary;  /* beside it */
  char *previous;   /* where the file that was there waits while the new ones are put in place */
  FILE *file;
  int by_path;      /* written by its temporary name, not through `file` */
  int left_out;     /* not to be put in place after all */
  int kept, placed; /* what staging_commit has done so far */
} staged_file;

typedef struct staging {
  staged_file files[STAGING_MOST];
  int count;
} staging;

/* Announces the outputs, before the long work: complains and returns 0 if one is not a place to write to, or the same
 * place as another or as an input. Paths that are NULL do not count. */
int staging_announce(staging *s, const char *const *outputs, int output_count, const char *const *inputs,
                     int input_count);

/* The stream to write an announced output to; NULL, with a complaint, if it cannot be opened. */
FILE *staging_open(staging *s, const char *path);

/* The temporary name to write an announced output to by other means. */
const char *staging_by_path(staging *s, const char *path);

/* This output will not be there after all; what was there stays. */
void staging_leave_out(staging *s, const char *path);

/* Closes all and puts them in place. 0, with a complaint, if anything could not be written: then no output changed. */
int staging_commit(staging *s);

/* Removes what is not in place; to be called in the end in any case. */
void staging_close(staging *s);

#endif
