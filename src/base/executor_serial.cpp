// The executor where there are no threads, as in a browser without shared memory: all loops run on the calling thread.
#include <algorithm>

#include "base/executor.h"
#include "base/stop.h"

namespace ts {

struct Executor::Arena {};

Executor::Executor(unsigned /*threads*/) : threads_(1) {}

Executor::~Executor() = default;

void Executor::ranges(std::size_t n, std::size_t grain,
                      const std::function<void(std::size_t, std::size_t)> &body) const {
  grain = std::max<std::size_t>(1, grain);
  const Monitor *const monitor = StopScope::current();
  for (std::size_t begin = 0; begin < n; begin += std::min(grain, n - begin)) {
    stop_if_asked(monitor);
    body(begin, std::min(n - begin, grain) + begin);
  }
}

}  // namespace ts
