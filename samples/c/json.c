/* SPDX-License-Identifier: Apache-2.0 */
#include "json.h"

#include <math.h>

/* Length of the UTF-8 sequence at `p`, 0 if there is none (stray, overlong, surrogate, beyond U+10FFFF, cut off). */
static int utf8_length(const unsigned char *p) {
  const int n = p[0] < 0x80                   ? 1
                : p[0] >= 0xc2 && p[0] < 0xe0 ? 2
                : (p[0] & 0xf0) == 0xe0       ? 3
                : p[0] >= 0xf0 && p[0] < 0xf5 ? 4
                                              : 0;
  int i;
  for (i = 1; i < n; ++i)
    if ((p[i] & 0xc0) != 0x80) return 0;
  if (n == 3 && ((p[0] == 0xe0 && p[1] < 0xa0) || (p[0] == 0xed && p[1] >= 0xa0))) return 0;
  if (n == 4 && ((p[0] == 0xf0 && p[1] < 0x90) || (p[0] == 0xf4 && p[1] >= 0x90))) return 0;
  return n;
}

static void quote(FILE *file, const char *text) {
  const unsigned char *p = (const unsigned char *)text;
  fputc('"', file);
  while (*p != '\0') {
    const int n = utf8_length(p);
    if (n == 0) {
      fputs("\\ufffd", file);
      ++p;
      continue;
    }
    if (*p == '"' || *p == '\\')
      fprintf(file, "\\%c", *p);
    else if (*p < 0x20)
      fprintf(file, "\\u%04x", *p);
    else
      fwrite(p, 1, (size_t)n, file);
    p += n;
  }
  fputc('"', file);
}

static void line(json *j) {
  int i;
  fputc('\n', j->file);
  for (i = 0; i < j->depth; ++i) fputs("  ", j->file);
}

/* What stands before a value: a comma, a new line, the key. */
static void lead(json *j, const char *key) {
  if (!j->empty) fputc(',', j->file);
  if (j->depth > 0) line(j);
  j->empty = 0;
  if (key == NULL) return;
  quote(j->file, key);
  fputs(": ", j->file);
}

static void open_bracket(json *j, const char *key, char bracket) {
  lead(j, key);
  fputc(bracket, j->file);
  ++j->depth;
  j->empty = 1;
}

static void close_bracket(json *j, char bracket) {
  --j->depth;
  if (!j->empty) line(j);
  fputc(bracket, j->file);
  j->empty = 0;
}

json json_begin(FILE *file) {
  json j;
  j.file = file;
  j.depth = 0;
  j.empty = 1;
  return j;
}

void json_end(json *j) {
  fputc('\n', j->file);
}

void json_open_object(json *j, const char *key) {
  open_bracket(j, key, '{');
}
void json_close_object(json *j) {
  close_bracket(j, '}');
}
void json_open_array(json *j, const char *key) {
  open_bracket(j, key, '[');
}
void json_close_array(json *j) {
  close_bracket(j, ']');
}

static void write_number(FILE *file, double value) {
  if (isfinite(value))
    fprintf(file, "%.17g", value);
  else
    fputs("null", file);
}

void json_number(json *j, const char *key, double value) {
  lead(j, key);
  write_number(j->file, value);
}

void json_count(json *j, const char *key, uint32_t value) {
  lead(j, key);
  fprintf(j->file, "%lu", (unsigned long)value);
}

void json_bool(json *j, const char *key, int value) {
  lead(j, key);
  fputs(value ? "true" : "false", j->file);
}

void json_null(json *j, const char *key) {
  lead(j, key);
  fputs("null", j->file);
}

void json_text(json *j, const char *key, const char *value) {
  if (value == NULL) {
    json_null(j, key);
    return;
  }
  lead(j, key);
  quote(j->file, value);
}

void json_point(json *j, const char *key, const double xyz[3]) {
  int i;
  lead(j, key);
  for (i = 0; i < 3; ++i) {
    fputs(i == 0 ? "[" : ", ", j->file);
    write_number(j->file, xyz[i]);
  }
  fputc(']', j->file);
}
