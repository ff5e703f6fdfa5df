// The C heap of this program, told to fail. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace heap {

// False where a sanitizer has the heap.
extern const bool can_fail;
long taken();          // allocations of this thread so far
void fail_at(long n);  // the n-th of this thread from now on; 0: none

// Bytes that this thread has taken and not given back, and the most that they were since the last forget_peak(). 0
// where a sanitizer has the heap.
long live();
long peak();
void forget_peak();

// Memory that none of this counts, as large as it really is.
void *take_unseen(std::size_t bytes);
void give_unseen(void *memory);
std::size_t size_of(void *memory);

}  // namespace heap
