/* ts_segment_options by name, for --set. SPDX-License-Identifier: Apache-2.0 */
#ifndef SETTINGS_H
#define SETTINGS_H

#include <toothseg.h>

enum { SETTINGS_MOST = 32 };

/* Puts "NAME=VALUE" into the options; NULL for `options` only looks whether it could. 0 and a complaint if not. */
int settings_apply(const char *text, ts_segment_options *options);

#endif
