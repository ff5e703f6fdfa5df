// The C heap of this program, told to fail. SPDX-License-Identifier: Apache-2.0
#pragma once

namespace heap {

// False where a sanitizer has the heap.
extern const bool can_fail;
long taken();          // allocations of this thread so far
void fail_at(long n);  // the n-th of this thread from now on; 0: none

}  // namespace heap
