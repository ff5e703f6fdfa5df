#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "base/executor.h"

namespace {

using Ranges = std::vector<std::pair<std::size_t, std::size_t>>;

Ranges ranges_of(unsigned threads, std::size_t n, std::size_t grain) {
  const ts::Executor executor(threads);
  Ranges seen;
  std::mutex guard;
  executor.ranges(n, grain, [&](std::size_t b, std::size_t e) {
    const std::lock_guard lock(guard);
    seen.emplace_back(b, e);
  });
  std::sort(seen.begin(), seen.end());
  return seen;
}

}  // namespace

TEST_CASE("ranges cover [0, n) once, cut at multiples of the grain, for any number of threads") {
  for (const std::size_t n : {0, 1, 9, 10, 11, 1000})
    for (const std::size_t grain : {1, 10, 5000}) {
      const Ranges one = ranges_of(1, n, grain);
      std::size_t next = 0;
      for (const auto &[b, e] : one) {
        CHECK(b == next);
        CHECK(b % grain == 0);
        CHECK(e > b);
        CHECK(e - b <= grain);
        next = e;
      }
      CHECK(next == n);
      CHECK(ranges_of(2, n, grain) == one);
      CHECK(ranges_of(5, n, grain) == one);
    }
}

TEST_CASE("a grain of 0 counts as 1") {
  CHECK(ranges_of(2, 3, 0) == Ranges{{0, 1}, {1, 2}, {2, 3}});
}

TEST_CASE("one thread never leaves the calling one") {
  const ts::Executor executor(1);
  const auto here = std::this_thread::get_id();
  executor.each(20, [&](std::size_t) { CHECK(std::this_thread::get_id() == here); });
  CHECK(executor.threads() == 1);
  CHECK(ts::Executor(0).threads() >= 1);
  CHECK(ts::Executor(7).threads() == 7);
}

TEST_CASE("an exception in a body is thrown again by the call, and the executor goes on to work") {
  for (const unsigned threads : {1u, 3u}) {
    const ts::Executor executor(threads);
    CHECK_THROWS_WITH_AS(executor.each(50,
                                       [](std::size_t i) {
                                         if (i == 17) throw std::runtime_error("seventeen");
                                       }),
                         "seventeen", std::runtime_error);
    std::atomic<int> done = 0;
    executor.each(50, [&](std::size_t) { ++done; });
    CHECK(done == 50);
  }
}

TEST_CASE("loops may be nested") {
  const ts::Executor executor(3);
  std::atomic<int> done = 0;
  executor.each(8, [&](std::size_t) { executor.each(8, [&](std::size_t) { ++done; }); });
  CHECK(done == 64);
}
