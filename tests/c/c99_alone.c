/* The headers compile alone as C99, in any order and twice. SPDX-License-Identifier: Apache-2.0 */
#include <toothseg.h>
#include <toothseg_arch.h>

typedef char enums_are_32_bits[sizeof(ts_status) == 4 && sizeof(ts_unit) == 4 && sizeof(ts_preset) == 4 ? 1 : -1];
ts_status c99_alone(enums_are_32_bits *unused);
ts_status c99_alone(enums_are_32_bits *unused) {
  return unused ? TS_OK : TS_E_NULL;
}
