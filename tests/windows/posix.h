/* SPDX-License-Identifier: Apache-2.0
 * What tests/reliability asks of the C library and Windows has under another name. Included before all else. */
#pragma once

#include <malloc.h>

#include <cerrno>
#include <cstddef>
#include <cstdlib>

inline std::size_t malloc_usable_size(void *memory) {
  return memory ? _msize(memory) : 0;
}

// To be given back by free, which _aligned_malloc's is not: 16 is what malloc has here.
inline int posix_memalign(void **out, std::size_t alignment, std::size_t size) {
  if (alignment > 16) return EINVAL;
  void *const memory = std::malloc(size);
  if (!memory) return ENOMEM;
  *out = memory;
  return 0;
}
