/* Checks that count and say what failed. SPDX-License-Identifier: Apache-2.0 */
#ifndef HARNESS_H
#define HARNESS_H

#include <toothseg.h>

#define CHECK(condition) harness_check((condition), #condition, __FILE__, __LINE__)
#define CHECK_STATUS(call, expected) harness_status((call), (expected), #call, __FILE__, __LINE__)
#define CHECK_NEAR(a, b, tolerance) harness_near((a), (b), (tolerance), #a " ~ " #b, __FILE__, __LINE__)
/* For what the rest of a test cannot do without. */
#define REQUIRE(condition) \
  if (!CHECK(condition)) return
#define REQUIRE_STATUS(call, expected) \
  if (!CHECK_STATUS(call, expected)) return
#define RUN(test) harness_run(#test, test)

int harness_check(int good, const char *what, const char *file, int line);
int harness_status(ts_status got, ts_status expected, const char *what, const char *file, int line);
int harness_near(double a, double b, double tolerance, const char *what, const char *file, int line);
void harness_run(const char *name, void (*test)(void));
/* Said with the checks that fail while it is set, for loops over cases. NULL: none. */
void harness_case(const char *format, ...);
/* Prints "N passed, N failed"; the exit status of the program. */
int harness_finish(void);

#endif
