#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <thread>

#include "base/executor.h"
#include "base/memory.h"
#include "base/stop.h"

namespace ts {

struct Executor::Arena {
  // oneTBB prints a warning when asked for more threads than it has or the host allows: ask for no more, and now.
  explicit Arena(unsigned threads) : arena(static_cast<int>(std::min(threads, available()))) { arena.initialize(); }
  static unsigned available() {
    using oneapi::tbb::global_control;
    const std::size_t allowed = global_control::active_value(global_control::max_allowed_parallelism);
    const int cores = oneapi::tbb::info::default_concurrency();
    return static_cast<unsigned>(
        std::max<std::size_t>(1, std::min<std::size_t>(allowed, static_cast<std::size_t>(cores))));
  }
  oneapi::tbb::task_arena arena;
};

Executor::Executor(unsigned threads) : threads_(threads ? threads : std::max(1u, std::thread::hardware_concurrency())) {
  if (threads_ > 1) arena_ = std::make_unique<Arena>(threads_);
}

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
  if (!arena_ || chunks < 2) {
    for (std::size_t c = 0; c < chunks; ++c) chunk(c);
    return;
  }
  const std::shared_ptr<const AllocatorHooks> hooks = AllocatorScope::current();
  // Isolated: a thread that waits here must not pick up unrelated work of the host's while it holds our locks.
  arena_->arena.execute([&] {
    oneapi::tbb::this_task_arena::isolate([&] {
      oneapi::tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t c) {
        const AllocatorScope scope(hooks);
        const StopScope stop(monitor);
        chunk(c);
      });
    });
  });
}

}  // namespace ts
