/* SPDX-License-Identifier: Apache-2.0 */
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "complain.h"
#include "run.h"
#include "utf8.h"

/* The first three numbers of a line. 1: read; 0: no click here (blank, comment); -1: not numbers. */
static int parse_line(const char *text, double xyz[3]) {
  int i;
  while (isspace((unsigned char)*text)) ++text;
  if (*text == '\0' || *text == '#') return 0;
  for (i = 0; i < 3; ++i) {
    char *end;
    xyz[i] = strtod(text, &end);
    if (end == text || !isfinite(xyz[i]) || (*end != '\0' && !isspace((unsigned char)*end))) return -1;
    text = end;
  }
  return 1;
}

static int append(click **clicks, uint32_t *count, uint32_t *capacity, const double xyz[3], unsigned line) {
  click *c;
  if (*count == *capacity) {
    const uint32_t more = *capacity ? 2 * *capacity : 32;
    click *grown = realloc(*clicks, more * sizeof *grown);
    if (grown == NULL) return 0;
    *clicks = grown;
    *capacity = more;
  }
  c = &(*clicks)[(*count)++];
  memset(c, 0, sizeof *c);
  memcpy(c->position, xyz, sizeof c->position);
  c->line = line;
  return 1;
}

/* 0, with a complaint, at the first bad line. A line longer than the buffer ends in columns that do not matter. */
static int read_lines(FILE *file, const char *path, click **clicks, uint32_t *count) {
  char text[1024];
  unsigned number = 0;
  uint32_t capacity = 0;
  int in_long_line = 0;
  while (fgets(text, sizeof text, file) != NULL) {
    const int goes_on = strchr(text, '\n') == NULL;
    double xyz[3];
    int got;
    if (in_long_line) {
      in_long_line = goes_on;
      continue;
    }
    in_long_line = goes_on;
    ++number;
    got = parse_line(text, xyz);
    if (got < 0) return complain("%s:%u: not three numbers x y z", path, number);
    if (got > 0 && !append(clicks, count, &capacity, xyz, number)) return complain("%s: out of memory", path);
  }
  if (ferror(file)) return complain("%s: cannot be read: %s", path, strerror(errno));
  if (*count == 0) return complain("%s: holds no click", path);
  return 1;
}

int clicks_read(const char *path, click **clicks, uint32_t *count) {
  FILE *file = utf8_fopen(path, "r");
  int good;
  *clicks = NULL;
  *count = 0;
  if (file == NULL) return complain("%s: cannot be opened: %s", path, strerror(errno));
  good = read_lines(file, path, clicks, count);
  fclose(file);
  if (good) return 1;
  free(*clicks);
  *clicks = NULL;
  *count = 0;
  return 0;
}
