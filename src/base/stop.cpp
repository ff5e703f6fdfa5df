#include "base/stop.h"

namespace ts {
namespace {

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
