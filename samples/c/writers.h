/* The outputs of ts-segment. SPDX-License-Identifier: Apache-2.0
 *
 * Each returns 0, with a complaint, if a call of the library failed; errors of writing stay in the stream, for the
 * staging that closes it. */
#ifndef WRITERS_H
#define WRITERS_H

#include <stdio.h>

#include "run.h"

int write_labels(const run *r, FILE *file);
int write_cuts(const run *r, FILE *file);
int write_ply(const run *r, FILE *file);
int write_report(const run *r, FILE *file);
int write_features(const run *r, FILE *file);
int write_json3dts(const run *r, FILE *file);
int write_session(const run *r, FILE *file);

#endif
