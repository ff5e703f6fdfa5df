#include <doctest/doctest.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <thread>

#include "base/executor.h"
#include "base/memory.h"

namespace {

struct Counts {
  std::atomic<int> taken{0}, given{0};
  std::atomic<bool> fail{false};
};

std::shared_ptr<const ts::AllocatorHooks> counting(Counts &counts) {
  const auto alloc = [](std::size_t bytes, void *user) -> void * {
    auto *c = static_cast<Counts *>(user);
    if (c->fail) return nullptr;
    ++c->taken;
    return std::malloc(bytes);
  };
  const auto free = [](void *memory, void *user) {
    ++static_cast<Counts *>(user)->given;
    std::free(memory);
  };
  return std::make_shared<ts::AllocatorHooks>(ts::AllocatorHooks{alloc, free, &counts});
}

}  // namespace

TEST_CASE("without a scope the C library serves") {
  ts::Vec<int> v(1000, 7);
  CHECK(v[999] == 7);
  CHECK(ts::AllocatorScope::current() == nullptr);
}

TEST_CASE("memory is aligned to a cache line and 16 bytes of the hook's are enough for that") {
  Counts counts;
  const ts::AllocatorScope scope(counting(counts));
  for (std::size_t n = 1; n < 300; n += 7) {
    ts::Vec<char> v(n, 'x');
    CHECK(reinterpret_cast<std::uintptr_t>(v.data()) % 64 == 0);
    CHECK(v.back() == 'x');
  }
  CHECK(counts.taken == counts.given);
}

TEST_CASE("the hooks of the scope are called, those of the outer one after it") {
  Counts outer, inner;
  const ts::AllocatorScope a(counting(outer));
  {
    const ts::AllocatorScope b(counting(inner));
    const ts::Vec<int> v(10);
    CHECK(inner.taken == 1);
    CHECK(outer.taken == 0);
  }
  CHECK(inner.given == 1);
  const ts::Vec<int> w(10);
  CHECK(inner.taken == 1);
  CHECK(outer.taken == 1);
}

TEST_CASE("a block is given back to whom it came from, on any thread and after the scope") {
  Counts counts;
  ts::Vec<int> v;
  {
    const ts::AllocatorScope scope(counting(counts));
    v.assign(100, 1);
  }
  CHECK(counts.given == 0);
  std::thread([moved = std::move(v)]() mutable { ts::Vec<int>().swap(moved); }).join();
  CHECK(counts.taken == 1);
  CHECK(counts.given == 1);
}

TEST_CASE("a hook that has no memory makes bad_alloc, and nothing is lost") {
  Counts counts;
  const ts::AllocatorScope scope(counting(counts));
  ts::Vec<int> v(10, 3);
  counts.fail = true;
  CHECK_THROWS_AS(v.resize(1000), std::bad_alloc);
  CHECK(v.size() == 10);
  CHECK(v[9] == 3);
  counts.fail = false;
  ts::Vec<int>().swap(v);
  CHECK(counts.taken == counts.given);
}

TEST_CASE("sizes that overflow are refused before any hook sees them") {
  Counts counts;
  const ts::AllocatorScope scope(counting(counts));
  CHECK_THROWS_AS((void)ts::Allocator<double>().allocate(SIZE_MAX / 4), std::bad_alloc);
  CHECK_THROWS_AS((void)ts::allocate(SIZE_MAX - 8), std::bad_alloc);
  CHECK(counts.taken == 0);
}

TEST_CASE("the threads of an executor use the hooks of the one that calls it") {
  Counts counts;
  const ts::Executor executor(4);
  {
    const ts::AllocatorScope scope(counting(counts));
    executor.each(64, [](std::size_t i) { const ts::Vec<int> v(100 + i); });
  }
  CHECK(counts.taken == 64);
  CHECK(counts.given == 64);
}
