/* One line to stderr, "ts-segment: what and where". SPDX-License-Identifier: Apache-2.0 */
#ifndef COMPLAIN_H
#define COMPLAIN_H

/* Always returns 0, so that a function can say `return complain(...)` for "failed". */
int complain(const char *format, ...);

#endif
