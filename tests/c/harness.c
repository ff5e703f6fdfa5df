/* SPDX-License-Identifier: Apache-2.0 */
#include "harness.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

static unsigned long passed, failed;
static const char *running = "";
static char current_case[256];

static int note(int good, const char *what, const char *file, int line) {
  if (good) {
    ++passed;
    return 1;
  }
  ++failed;
  printf("%s:%d: %s%s%s: failed: %s", file, line, running, current_case[0] ? ": " : "", current_case, what);
  return 0;
}

int harness_check(int good, const char *what, const char *file, int line) {
  if (!note(good, what, file, line)) printf("\n");
  return good;
}

int harness_status(ts_status got, ts_status expected, const char *what, const char *file, int line) {
  const int good = note(got == expected, what, file, line);
  if (!good)
    printf(": %s, expected %s (last message: %s)\n", ts_status_name(got), ts_status_name(expected),
           ts_last_error_message());
  return good;
}

int harness_near(double a, double b, double tolerance, const char *what, const char *file, int line) {
  const int good = note(fabs(a - b) <= tolerance, what, file, line);
  if (!good) printf(": %.17g and %.17g\n", a, b);
  return good;
}

void harness_run(const char *name, void (*test)(void)) {
  running = name;
  current_case[0] = '\0';
  test();
  running = "";
  current_case[0] = '\0';
  fflush(stdout);
}

void harness_case(const char *format, ...) {
  va_list arguments;
  current_case[0] = '\0';
  if (format == NULL) return;
  va_start(arguments, format);
  vsnprintf(current_case, sizeof current_case, format, arguments);
  va_end(arguments);
}

int harness_finish(void) {
  printf("%lu passed, %lu failed\n", passed, failed);
  return failed != 0 || passed == 0;
}
