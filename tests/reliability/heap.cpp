// malloc and its kin for the whole process, in front of those of glibc. SPDX-License-Identifier: Apache-2.0
#include "heap.h"

#include <cerrno>
#include <cstddef>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HEAP_OF_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define HEAP_OF_SANITIZER
#endif
#endif

namespace heap {
namespace {
thread_local long count = 0, fails = 0;
[[maybe_unused]] bool fails_now() {
  if (++count != fails) return false;
  errno = ENOMEM;
  return true;
}
}  // namespace

long taken() {
  return count;
}
void fail_at(long n) {
  fails = n ? count + n : 0;
}

#ifdef HEAP_OF_SANITIZER
const bool can_fail = false;
#else
const bool can_fail = true;
#endif

}  // namespace heap

#ifndef HEAP_OF_SANITIZER
extern "C" {
void *__libc_malloc(std::size_t);
void *__libc_calloc(std::size_t, std::size_t);
void *__libc_realloc(void *, std::size_t);
void *__libc_memalign(std::size_t, std::size_t);

void *malloc(std::size_t size) {
  return heap::fails_now() ? nullptr : __libc_malloc(size);
}
void *calloc(std::size_t n, std::size_t size) {
  return heap::fails_now() ? nullptr : __libc_calloc(n, size);
}
void *realloc(void *old, std::size_t size) {
  return heap::fails_now() ? nullptr : __libc_realloc(old, size);
}
void *aligned_alloc(std::size_t alignment, std::size_t size) {
  return heap::fails_now() ? nullptr : __libc_memalign(alignment, size);
}
void *memalign(std::size_t alignment, std::size_t size) {
  return heap::fails_now() ? nullptr : __libc_memalign(alignment, size);
}
int posix_memalign(void **out, std::size_t alignment, std::size_t size) {
  void *p = heap::fails_now() ? nullptr : __libc_memalign(alignment, size);
  if (p == nullptr) return ENOMEM;
  *out = p;
  return 0;
}
}
#endif
