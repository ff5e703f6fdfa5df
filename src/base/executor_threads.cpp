// The executor on threads of the standard library, made for each loop: for ThreadSanitizer, which does not see into
// oneTBB, and for where that is not to be had.
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "base/executor.h"
#include "base/memory.h"
#include "base/stop.h"

namespace ts {
namespace {

thread_local bool inside = false;  // a loop in a loop runs on its thread alone

class Inside {
 public:
  Inside() { inside = true; }
  ~Inside() { inside = false; }
};

}  // namespace

struct Executor::Arena {};

Executor::Executor(unsigned threads)
    : threads_(threads ? threads : std::max(1u, std::thread::hardware_concurrency())) {}

Executor::~Executor() = default;

void Executor::ranges(std::size_t n, std::size_t grain,
                      const std::function<void(std::size_t, std::size_t)> &body) const {
  grain = std::max<std::size_t>(1, grain);
  const std::size_t chunks = n / grain + (n % grain != 0);
  const Monitor *const monitor = StopScope::current();
  const auto chunk = [&](std::size_t c) {
    stop_if_asked(monitor);
    body(c * grain, std::min(n, (c + 1) * grain));
  };
  if (threads_ < 2 || chunks < 2 || inside) {
    for (std::size_t c = 0; c < chunks; ++c) chunk(c);
    return;
  }
  const std::shared_ptr<const AllocatorHooks> hooks = AllocatorScope::current();
  std::atomic<std::size_t> next{0};
  std::mutex guard;
  std::exception_ptr first;
  const auto work = [&] {
    const Inside loop;
    const AllocatorScope scope(hooks);
    const StopScope stop(monitor);
    try {
      for (std::size_t c = next++; c < chunks; c = next++) chunk(c);
    } catch (...) {
      next = chunks;  // nobody begins another
      const std::lock_guard lock(guard);
      if (!first) first = std::current_exception();
    }
  };
  std::vector<std::jthread> others;
  for (std::size_t t = 1; t < std::min<std::size_t>(threads_, chunks); ++t) others.emplace_back(work);
  work();
  others.clear();
  if (first) std::rethrow_exception(first);
}

}  // namespace ts
