// Whether the call that a thread works for is to stop: asked in loops of any depth, by whoever runs them, without being
// told whom to ask. A thread has it as it has its allocator; the executor hands it on, and asks before each piece of a
// loop.
#pragma once

#include "base/progress.h"

namespace ts {

// Makes the monitor of `progress`, if it has one, the one that this thread asks until the scope ends.
class StopScope {
 public:
  explicit StopScope(const Progress &progress) noexcept : StopScope(progress.monitor()) {}
  explicit StopScope(const Monitor *monitor) noexcept;
  ~StopScope();
  StopScope(const StopScope &) = delete;
  StopScope &operator=(const StopScope &) = delete;

  static const Monitor *current() noexcept;

 private:
  const Monitor *previous_;
};

// Throws Error{cancelled} if the monitor, which may be null, has been told to stop. Calls nobody back.
inline void stop_if_asked(const Monitor *monitor) {
  if (monitor && monitor->stopped()) throw Error(Fault::cancelled, std::string("cancelled during ") + monitor->stage());
}
inline void stop_if_asked() {
  stop_if_asked(StopScope::current());
}

// For loops over small things: asks at every `rarely`-th call.
class StopNowAndThen {
 public:
  explicit StopNowAndThen(unsigned rarely) noexcept : monitor_(StopScope::current()), rarely_(rarely) {}
  void operator()() {
    if (++count_ < rarely_) return;
    count_ = 0;
    stop_if_asked(monitor_);
  }

 private:
  const Monitor *monitor_;
  unsigned rarely_, count_ = 0;
};

}  // namespace ts
