/* What the callers of 0.1.0 share. SPDX-License-Identifier: Apache-2.0 */
#ifndef CALLER_H
#define CALLER_H
#include <stdio.h>
#include <stdlib.h>

#include "toothseg.h"

#define CHECK(condition)                                                                            \
  do {                                                                                              \
    if (!(condition)) {                                                                             \
      fprintf(stderr, "%s:%d: %s (%s)\n", __FILE__, __LINE__, #condition, ts_last_error_message()); \
      exit(1);                                                                                      \
    }                                                                                               \
  } while (0)
#define DO(call) CHECK((call) == TS_OK)

static inline void *room_for(size_t bytes) {
  void *room = malloc(bytes ? bytes : 1);
  CHECK(room != NULL);
  return room;
}
#endif
