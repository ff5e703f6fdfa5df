#include "base/stop.h"

namespace ts {
namespace {

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): each thread's own, set by StopScope alone
thread_local const Monitor *current_monitor = nullptr;

}  // namespace

StopScope::StopScope(const Monitor *monitor) noexcept : previous_(current_monitor) {
  current_monitor = monitor;
}

StopScope::~StopScope() {
  current_monitor = previous_;
}

const Monitor *StopScope::current() noexcept {
  return current_monitor;
}

}  // namespace ts
