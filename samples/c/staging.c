/* SPDX-License-Identifier: Apache-2.0 */
#if !defined(_WIN32)
#define _POSIX_C_SOURCE 200112L /* stat, getpid: the only calls here that are not C99 */
#endif

#include "staging.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#if defined(_WIN32)
#include <process.h>
#define getpid _getpid
#ifndef S_ISREG
#define S_ISREG(mode) (((mode)&_S_IFMT) == _S_IFREG)
#endif
#endif

#include "complain.h"
#include "utf8.h"

static char *beside(const char *path, const char *what) {
  const size_t size = strlen(path) + strlen(what) + 32;
  char *name = malloc(size);
  if (name != NULL) snprintf(name, size, "%s.%s-%ld", path, what, (long)getpid());
  return name;
}

static int same_file(const char *a, const char *b) {
  utf8_status sa, sb;
  if (strcmp(a, b) == 0) return 1;
  if (utf8_stat(a, &sa) != 0 || utf8_stat(b, &sb) != 0) return 0;
  return sa.st_ino != 0 && sa.st_ino == sb.st_ino && sa.st_dev == sb.st_dev;
}

/* A file that is created and removed shows whether the place can be written to, and, while it is there, whether it is
 * the place of another output under a different name. */
static int probe(staging *s, const char *path) {
  staged_file *f = &s->files[s->count];
  FILE *file;
  int i;
  memset(f, 0, sizeof *f);
  f->path = path;
  f->temporary = beside(path, "part");
  f->previous = beside(path, "previous");
  ++s->count;
  if (f->temporary == NULL || f->previous == NULL) return complain("%s: out of memory", path);
  file = utf8_fopen(f->temporary, "wb");
  if (file == NULL) return complain("%s: cannot be written: %s", path, strerror(errno));
  fclose(file);
  for (i = 0; i + 1 < s->count; ++i)
    if (same_file(f->temporary, s->files[i].temporary)) return complain("%s: named for two outputs", path);
  return 1;
}

static int announce(staging *s, const char *path, const char *const *inputs, int input_count) {
  utf8_status there;
  int i;
  if (s->count == STAGING_MOST) return complain("%s: too many outputs", path);
  for (i = 0; i < input_count; ++i)
    if (inputs[i] != NULL && same_file(path, inputs[i])) return complain("%s: both input and output", path);
  /* A rename would put a file in the place of a device or a pipe. */
  if (utf8_stat(path, &there) == 0 && !S_ISREG(there.st_mode))
    return complain("%s: cannot be written: not a regular file", path);
  return probe(s, path);
}

int staging_announce(staging *s, const char *const *outputs, int output_count, const char *const *inputs,
                     int input_count) {
  int i, good = 1;
  for (i = 0; good && i < output_count; ++i)
    if (outputs[i] != NULL) good = announce(s, outputs[i], inputs, input_count);
  for (i = 0; i < s->count; ++i)
    if (s->files[i].temporary != NULL) utf8_remove(s->files[i].temporary);
  return good;
}

static staged_file *announced(staging *s, const char *path) {
  int i;
  for (i = 0; i < s->count; ++i)
    if (strcmp(s->files[i].path, path) == 0) return &s->files[i];
  complain("%s: not announced", path);
  return NULL;
}

FILE *staging_open(staging *s, const char *path) {
  staged_file *f = announced(s, path);
  if (f == NULL) return NULL;
  f->file = utf8_fopen(f->temporary, "wb");
  if (f->file == NULL) complain("%s: cannot be written: %s", path, strerror(errno));
  return f->file;
}

const char *staging_by_path(staging *s, const char *path) {
  staged_file *f = announced(s, path);
  if (f == NULL) return NULL;
  f->by_path = 1;
  return f->temporary;
}

void staging_leave_out(staging *s, const char *path) {
  staged_file *f = announced(s, path);
  if (f != NULL) f->left_out = 1;
}

static int finish(staged_file *f) {
  int failed;
  if (f->by_path || f->left_out) return 1;
  if (f->file == NULL) return complain("%s: not opened", f->path);
  errno = 0;
  failed = fflush(f->file) != 0 || ferror(f->file);
  failed = fclose(f->file) != 0 || failed;
  f->file = NULL;
  if (failed) return complain("%s: cannot be written: %s", f->path, errno ? strerror(errno) : "write error");
  return 1;
}

static int place(staged_file *f) {
  utf8_status there;
  if (f->left_out) return 1;
  if (utf8_stat(f->path, &there) == 0) {
    if (utf8_rename(f->path, f->previous) != 0) return complain("%s: cannot be replaced: %s", f->path, strerror(errno));
    f->kept = 1;
  }
  if (utf8_rename(f->temporary, f->path) != 0) return complain("%s: cannot be written: %s", f->path, strerror(errno));
  f->placed = 1;
  return 1;
}

static void put_back(staged_file *f) {
  if (f->placed) utf8_remove(f->path);
  if (f->kept) utf8_rename(f->previous, f->path);
  f->placed = f->kept = 0;
}

int staging_commit(staging *s) {
  int i, good = 1;
  for (i = 0; good && i < s->count; ++i) good = finish(&s->files[i]);
  for (i = 0; good && i < s->count; ++i) good = place(&s->files[i]);
  for (i = 0; i < s->count; ++i) {
    staged_file *f = &s->files[i];
    if (!good) put_back(f);
    if (f->kept) utf8_remove(f->previous);
    f->kept = 0;
  }
  return good;
}

void staging_close(staging *s) {
  int i;
  for (i = 0; i < s->count; ++i) {
    staged_file *f = &s->files[i];
    if (f->file != NULL) fclose(f->file);
    if (!f->placed && f->temporary != NULL) utf8_remove(f->temporary);
    free(f->temporary);
    free(f->previous);
  }
  s->count = 0;
}
