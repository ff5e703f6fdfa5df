// The one seam to oneTBB: loops over index ranges, in an arena of the context's, or on the calling thread. A loop ends
// with Error{cancelled} before its next range once the call that it is part of is to stop (base/stop.h).
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace ts {

class Executor {
 public:
  // threads: 0 = one a core, 1 = never leaves the calling thread.
  explicit Executor(unsigned threads = 1);
  ~Executor();
  Executor(const Executor &) = delete;
  Executor &operator=(const Executor &) = delete;

  unsigned threads() const noexcept { return threads_; }

  // Calls body(begin, end) on disjoint ranges that cover [0, n), cut at multiples of `grain`, so that what a body does
  // per range cannot depend on the number of threads. An exception in a body is thrown again here.
  void ranges(std::size_t n, std::size_t grain, const std::function<void(std::size_t, std::size_t)> &body) const;

  // Calls body(i) for each i in [0, n), each a task of its own.
  void each(std::size_t n, const std::function<void(std::size_t)> &body) const {
    ranges(n, 1, [&](std::size_t b, std::size_t e) {
      for (std::size_t i = b; i < e; ++i) body(i);
    });
  }

 private:
  struct Arena;
  unsigned threads_;
  std::unique_ptr<Arena> arena_;
};

}  // namespace ts
