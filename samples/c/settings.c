/* SPDX-License-Identifier: Apache-2.0 */
#include "settings.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "complain.h"

typedef enum kind { COUNT, NUMBER, BYTES } kind;

static const struct {
  const char *name;
  kind what;
  size_t at;
} fields[] = {
#define FIELD(kind, name) \
  { #name, kind, offsetof(ts_segment_options, name) }
    FIELD(COUNT, weights),
    FIELD(COUNT, background),
    FIELD(COUNT, cut_rule),
    FIELD(COUNT, contours),
    FIELD(COUNT, histogram_bins),
    FIELD(COUNT, points_per_group),
    FIELD(NUMBER, alpha),
    FIELD(NUMBER, beta),
    FIELD(NUMBER, gamma),
    FIELD(NUMBER, theta),
    FIELD(NUMBER, c0),
    FIELD(NUMBER, normal_radius),
    FIELD(NUMBER, seed_radius),
    FIELD(NUMBER, gingiva_distance),
    FIELD(NUMBER, area_min),
    FIELD(NUMBER, area_max),
    FIELD(NUMBER, hole_area),
    FIELD(NUMBER, refine_band),
    FIELD(NUMBER, smooth_radius),
    FIELD(NUMBER, click_reach),
    FIELD(NUMBER, click_concavity),
    FIELD(COUNT, reject_outliers),
    FIELD(BYTES, memory_limit),
#undef FIELD
};

int settings_apply(const char *text, ts_segment_options *options) {
  const char *equals = strchr(text, '=');
  const size_t length = equals != NULL ? (size_t)(equals - text) : strlen(text);
  size_t i;
  for (i = 0; i < sizeof fields / sizeof fields[0]; ++i) {
    char *end;
    double value;
    if (strlen(fields[i].name) != length || strncmp(text, fields[i].name, length) != 0) continue;
    if (equals == NULL) break;
    value = strtod(equals + 1, &end);
    if (end == equals + 1 || *end != '\0') return complain("--set %s: not a number", text);
    if (fields[i].what == COUNT && !(value >= 0 && value <= 1e9 && value == (double)(uint32_t)value))
      return complain("--set %s: not a whole number from 0", text);
    if (fields[i].what == BYTES && !(value >= 0 && value <= 9e15 && value == (double)(uint64_t)value))
      return complain("--set %s: not a whole number from 0", text);
    if (options == NULL) return 1;
    if (fields[i].what == COUNT) {
      const uint32_t count = (uint32_t)value;
      memcpy((char *)options + fields[i].at, &count, sizeof count);
    } else if (fields[i].what == BYTES) {
      const uint64_t bytes = (uint64_t)value;
      memcpy((char *)options + fields[i].at, &bytes, sizeof bytes);
    } else {
      memcpy((char *)options + fields[i].at, &value, sizeof value);
    }
    return 1;
  }
  return complain("--set %s: not NAME=VALUE with a name from ts_segment_options", text);
}
