#include "base/memory.h"

#include <cstdint>
#include <cstdlib>
#include <new>
#include <utility>

#include "base/stop.h"

// Pages of our own would hide from AddressSanitizer what goes beyond them.
#if defined(__linux__) && !defined(TS_SANITIZED)
#define TS_OWN_PAGES
#include <sys/mman.h>
#endif

namespace ts {
namespace {

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): each thread's own, set by AllocatorScope alone
thread_local std::shared_ptr<const AllocatorHooks> current_hooks;

constexpr std::size_t line = 64;

// Stands directly before the memory handed out.
struct Header {
  std::shared_ptr<const AllocatorHooks> hooks;
  void *block;
  std::size_t mapped;  // bytes of a block of pages of its own; 0: the C library's or the caller's
};
static_assert(sizeof(Header) <= line);

constexpr std::size_t huge = std::size_t{2} << 20, large = std::size_t{1} << 20;

// Large blocks get pages of their own, huge ones where the system leaves that to us: a mesh of a million triangles
// takes hundreds of megabytes and is walked along the mesh, and on small pages a third of the time goes into faults and
// misses of the TLB. nullptr: not to be had here.
void *map_block(std::size_t &bytes) {
#ifdef TS_OWN_PAGES
  constexpr std::size_t small = std::size_t{64} << 10;
  // The rest of the last huge page is left out if it is the larger part of it.
  bytes = (bytes + small - 1) / small * small;
  if (bytes % huge >= huge / 2) bytes = (bytes + huge - 1) / huge * huge;
  void *const all = mmap(nullptr, bytes + huge, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (all == MAP_FAILED) return nullptr;
  const std::size_t before = (huge - reinterpret_cast<std::uintptr_t>(all) % huge) % huge;
  char *const begin = static_cast<char *>(all) + before;
  if (before > 0) munmap(all, before);
  munmap(begin + bytes, huge - before);
  madvise(begin, bytes, MADV_HUGEPAGE);  // advice: no harm if it is not taken
  return begin;
#else
  static_cast<void>(bytes);
  return nullptr;
#endif
}

void unmap_block(void *block, std::size_t bytes) noexcept {
#ifdef TS_OWN_PAGES
  munmap(block, bytes);
#else
  static_cast<void>(block);
  static_cast<void>(bytes);
#endif
}

// A huge page comes when it is first touched, and a virtual machine may take milliseconds for it. Whoever fills a
// buffer touches all of its pages one after another, and asks nobody: here they come before, and it is asked for each.
// False: the work is to stop.
bool touch_block(void *block, std::size_t bytes) noexcept {
  const Monitor *const monitor = StopScope::current();
  for (std::size_t at = 0; monitor && at + huge <= bytes; at += huge) {
    if (monitor->stopped()) return false;
    static_cast<volatile char *>(block)[at] = 0;
  }
  return true;
}

}  // namespace

void *allocate(std::size_t bytes) {
  if (bytes > SIZE_MAX - 2 * line) throw std::bad_alloc();
  if (bytes >= large)
    stop_if_asked();  // whoever fills so much is about to take long, and bears that an allocation throws
  const std::shared_ptr<const AllocatorHooks> &hooks = current_hooks;
  const std::size_t whole = bytes + 2 * line;
  const bool callers = hooks && hooks->alloc;
  std::size_t mapped = whole;
  void *block = callers || whole < large ? nullptr : map_block(mapped);
  if (block && !touch_block(block, mapped)) {
    unmap_block(block, mapped);
    stop_if_asked();  // throws
    block = nullptr;
  }
  if (!block) {
    mapped = 0;
    block = callers ? hooks->alloc(whole, hooks->user) : std::malloc(whole);
  }
  if (!block) throw std::bad_alloc();
  // The last multiple of a line among the bytes up to 2 * line: a line or more is before it.
  char *const begin =
      static_cast<char *>(block) + 2 * line - 1 - (reinterpret_cast<std::uintptr_t>(block) + 2 * line - 1) % line;
  new (begin - sizeof(Header)) Header{hooks, block, mapped};
  return begin;
}

void deallocate(void *memory) noexcept {
  if (!memory) return;
  Header *header = reinterpret_cast<Header *>(static_cast<char *>(memory) - sizeof(Header));
  const std::shared_ptr<const AllocatorHooks> hooks = std::move(header->hooks);
  void *block = header->block;
  const std::size_t mapped = header->mapped;
  header->~Header();
  if (mapped)
    unmap_block(block, mapped);
  else if (hooks && hooks->free)
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
