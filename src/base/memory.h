// Memory of the caller's: every large buffer is a Vec, and a Vec takes its memory from the allocator hook of the
// context that the running thread works for (AllocatorScope). A block remembers whom it came from, so it can be freed
// anywhere.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace ts {

struct AllocatorHooks {
  void *(*alloc)(std::size_t bytes, void *user) = nullptr;  // nullptr: the system's
  void (*free)(void *memory, void *user) = nullptr;
  void *user = nullptr;
};

// Throws std::bad_alloc. The memory is aligned to 64 bytes, a cache line.
void *allocate(std::size_t bytes);
void deallocate(void *memory) noexcept;

// Makes `hooks` the allocator of this thread until the scope ends. The hooks are shared with every block taken.
class AllocatorScope {
 public:
  explicit AllocatorScope(std::shared_ptr<const AllocatorHooks> hooks) noexcept;
  ~AllocatorScope();
  AllocatorScope(const AllocatorScope &) = delete;
  AllocatorScope &operator=(const AllocatorScope &) = delete;

  static std::shared_ptr<const AllocatorHooks> current() noexcept;

 private:
  std::shared_ptr<const AllocatorHooks> previous_;
};

template <class T>
struct Allocator {
  using value_type = T;
  Allocator() noexcept = default;
  template <class U>
  // NOLINTNEXTLINE(google-explicit-constructor): an allocator of another type is one of this, says the standard
  Allocator(const Allocator<U> &) noexcept {}
  T *allocate(std::size_t n) {
    constexpr std::size_t each = sizeof(T);  // NOLINT(bugprone-sizeof-expression): T may be a pointer
    if (n > static_cast<std::size_t>(-1) / each) throw std::bad_alloc();
    return static_cast<T *>(ts::allocate(n * each));
  }
  void deallocate(T *p, std::size_t) noexcept { ts::deallocate(p); }
  template <class U>
  bool operator==(const Allocator<U> &) const noexcept {
    return true;
  }
};

template <class T>
using Vec = std::vector<T, Allocator<T>>;

}  // namespace ts
