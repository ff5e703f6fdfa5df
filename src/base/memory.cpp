#include "base/memory.h"

#include <cstdint>
#include <cstdlib>
#include <new>
#include <utility>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace ts {
namespace {

thread_local std::shared_ptr<const AllocatorHooks> current_hooks;

constexpr std::size_t line = 64;

// Stands directly before the memory handed out.
struct Header {
  std::shared_ptr<const AllocatorHooks> hooks;
  void *block;
};
static_assert(sizeof(Header) <= line);

// The C library's memory. Large blocks ask the kernel for large pages: to touch a block of small ones for the first
// time costs more than most of what is done in it.
void *take(std::size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::size_t page = std::size_t{1} << 21;
  if (bytes >= 2 * page && bytes <= SIZE_MAX - page) {
    const std::size_t rounded = (bytes + page - 1) / page * page;
    void *block = std::aligned_alloc(page, rounded);
    if (block) madvise(block, rounded, MADV_HUGEPAGE);
    return block;
  }
#endif
  return std::malloc(bytes);
}

}  // namespace

void *allocate(std::size_t bytes) {
  if (bytes > SIZE_MAX - 2 * line) throw std::bad_alloc();
  const std::shared_ptr<const AllocatorHooks> &hooks = current_hooks;
  const std::size_t whole = bytes + 2 * line;
  void *block = hooks && hooks->alloc ? hooks->alloc(whole, hooks->user) : take(whole);
  if (!block) throw std::bad_alloc();
  const std::uintptr_t begin = (reinterpret_cast<std::uintptr_t>(block) + 2 * line - 1) / line * line;
  new (reinterpret_cast<void *>(begin - sizeof(Header))) Header{hooks, block};
  return reinterpret_cast<void *>(begin);
}

void deallocate(void *memory) noexcept {
  if (!memory) return;
  Header *header = reinterpret_cast<Header *>(static_cast<char *>(memory) - sizeof(Header));
  const std::shared_ptr<const AllocatorHooks> hooks = std::move(header->hooks);
  void *block = header->block;
  header->~Header();
  if (hooks && hooks->free)
    hooks->free(block, hooks->user);
  else
    std::free(block);
}

AllocatorScope::AllocatorScope(std::shared_ptr<const AllocatorHooks> hooks) noexcept
    : previous_(std::move(current_hooks)) {
  current_hooks = std::move(hooks);
}

AllocatorScope::~AllocatorScope() {
  current_hooks = std::move(previous_);
}

std::shared_ptr<const AllocatorHooks> AllocatorScope::current() noexcept {
  return current_hooks;
}

}  // namespace ts
