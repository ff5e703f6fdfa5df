/* The meshes of the teeth and the gingiva, a file each. SPDX-License-Identifier: Apache-2.0 */
#ifndef TEETH_H
#define TEETH_H

#include "run.h"
#include "staging.h"

typedef struct teeth_files {
  char **paths; /* of the gingiva, then of the teeth of the run in their order */
  uint32_t count;
  const char *made; /* the directory, if it was not there before */
} teeth_files;

/* Makes the directory of --teeth if it is not there, and announces the gingiva's file: before the long work. Each of
 * these returns 0, with a complaint, if it failed; all do nothing without --teeth. */
int teeth_announce_gingiva(const options *o, teeth_files *files, staging *s);
/* The others, once it is known which teeth there are. */
int teeth_announce_all(const run *r, teeth_files *files, staging *s);
/* A tooth that cannot be closed is complained about, counted in r->failed and left out. */
int teeth_write(run *r, const teeth_files *files, staging *s);
/* In the end, after the staging: takes away the directory if it was made for nothing. */
void teeth_close(teeth_files *files);

#endif
