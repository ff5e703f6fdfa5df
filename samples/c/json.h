/* Writes JSON to a stream. SPDX-License-Identifier: Apache-2.0
 *
 * `key` is NULL inside an array. Write errors stay in the stream, for whoever closes it. */
#ifndef JSON_H
#define JSON_H

#include <stdint.h>
#include <stdio.h>

typedef struct json {
  FILE *file;
  int depth;
  int empty; /* nothing written yet in the innermost object or array */
} json;

json json_begin(FILE *file);
void json_end(json *j);

void json_open_object(json *j, const char *key);
void json_close_object(json *j);
void json_open_array(json *j, const char *key);
void json_close_array(json *j);

void json_number(json *j, const char *key, double value); /* NaN and infinities become null */
void json_count(json *j, const char *key, uint32_t value);
void json_bool(json *j, const char *key, int value);
void json_null(json *j, const char *key);
void json_text(json *j, const char *key, const char *value); /* bytes that are not UTF-8 become U+FFFD; NULL null */
void json_point(json *j, const char *key, const double xyz[3]);

#endif
