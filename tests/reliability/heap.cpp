// malloc and its kin for the whole process, in front of those of glibc. SPDX-License-Identifier: Apache-2.0
#include "heap.h"

#include <malloc.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>

namespace heap {
namespace {
thread_local long count = 0, fails = 0, bytes = 0, most = 0;
[[maybe_unused]] bool fails_now() {
  if (++count != fails) return false;
  errno = ENOMEM;
  return true;
}
[[maybe_unused]] void *counted(void *p) {
  if (p) bytes += static_cast<long>(malloc_usable_size(p)), most = std::max(most, bytes);
  return p;
}
[[maybe_unused]] void *uncounted(void *p) {
  if (p) bytes -= static_cast<long>(malloc_usable_size(p));
  return p;
}
}  // namespace

long live() {
  return bytes;
}
long peak() {
  return most;
}
void forget_peak() {
  most = bytes;
}
std::size_t size_of(void *memory) {
  return malloc_usable_size(memory);
}

long taken() {
  return count;
}
void fail_at(long n) {
  fails = n ? count + n : 0;
}

#ifdef TS_SANITIZED
const bool can_fail = false;
#else
const bool can_fail = true;
#endif

}  // namespace heap

#ifdef TS_SANITIZED
void *heap::take_unseen(std::size_t size) {
  return std::malloc(size);
}
void heap::give_unseen(void *memory) {
  std::free(memory);
}
#else
extern "C" {
void *__libc_malloc(std::size_t);
void *__libc_calloc(std::size_t, std::size_t);
void *__libc_realloc(void *, std::size_t);
void *__libc_memalign(std::size_t, std::size_t);
void __libc_free(void *);

void *malloc(std::size_t size) noexcept {
  return heap::fails_now() ? nullptr : heap::counted(__libc_malloc(size));
}
void *calloc(std::size_t n, std::size_t size) noexcept {
  return heap::fails_now() ? nullptr : heap::counted(__libc_calloc(n, size));
}
void *realloc(void *old, std::size_t size) noexcept {
  if (heap::fails_now()) return nullptr;
  const std::size_t before = old ? malloc_usable_size(old) : 0;
  void *const p = __libc_realloc(old, size);
  if (p || size == 0) heap::bytes -= static_cast<long>(before);
  return heap::counted(p);
}
void *aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return heap::fails_now() ? nullptr : heap::counted(__libc_memalign(alignment, size));
}
void *memalign(std::size_t alignment, std::size_t size) noexcept {
  return heap::fails_now() ? nullptr : heap::counted(__libc_memalign(alignment, size));
}
int posix_memalign(void **out, std::size_t alignment, std::size_t size) noexcept {
  void *p = heap::fails_now() ? nullptr : heap::counted(__libc_memalign(alignment, size));
  if (p == nullptr) return ENOMEM;
  *out = p;
  return 0;
}
void free(void *memory) noexcept {
  __libc_free(heap::uncounted(memory));
}
}

void *heap::take_unseen(std::size_t size) {
  return __libc_malloc(size);
}
void heap::give_unseen(void *memory) {
  __libc_free(memory);
}
#endif
