// How long a file that is open elsewhere is waited for. On Windows, which then neither replaces nor opens it: one that
// has just been written is open for a moment, to a virus scanner or to the thread that puts it in place. Elsewhere not.
#pragma once

#include <algorithm>
#include <chrono>
#include <thread>

#include "base/stop.h"

namespace ts {

class Patience {
 public:
  // Waits, and longer each time; false once that was a second.
  bool again() {
#ifdef _WIN32
    constexpr std::chrono::milliseconds longest{1000}, longest_at_once{32};
    if (waited_ >= longest) return false;
    stop_if_asked();
    std::this_thread::sleep_for(next_);
    waited_ += next_;
    next_ = std::min(2 * next_, longest_at_once);
    return true;
#else
    return false;
#endif
  }

 private:
  [[maybe_unused]] std::chrono::milliseconds waited_{0}, next_{1};
};

}  // namespace ts
