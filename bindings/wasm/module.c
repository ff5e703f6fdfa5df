/* What the module has beside the libraries. SPDX-License-Identifier: Apache-2.0 */
#include <malloc.h>
#include <stddef.h>

#include "toothseg_arch.h"

/* Bytes of the module's memory that are in use, of the library's and of what JavaScript took for a call. */
size_t tsw_bytes_in_use(void) {
  return mallinfo().uordblks;
}

/* What lib/arch.js has of the arch's structs. */
_Static_assert(sizeof(tsa_options) == 56 && offsetof(tsa_options, jaw) == 4 && offsetof(tsa_options, triangles) == 8 &&
                   offsetof(tsa_options, base) == 12 && offsetof(tsa_options, seed) == 16 &&
                   offsetof(tsa_options, crowding) == 24 && offsetof(tsa_options, noise) == 32 &&
                   offsetof(tsa_options, noise_kind) == 40 && offsetof(tsa_options, missing_count) == 44 &&
                   offsetof(tsa_options, missing) == 48,
               "tsa_options");
_Static_assert(sizeof(tsa_feature) == 32 && offsetof(tsa_feature, kind) == 4 && offsetof(tsa_feature, position) == 8,
               "tsa_feature");
