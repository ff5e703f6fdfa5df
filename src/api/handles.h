// What stands behind the opaque handles. A handle is a shared_ptr to its state; a child's state holds its parents', so
// handles may be destroyed in any order.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>

#include "base/executor.h"
#include "base/memory.h"
#include "base/stop.h"
#include "toothseg.h"

namespace ts::api {

struct Context {
  std::shared_ptr<const AllocatorHooks> allocator;
  std::unique_ptr<Executor> executor;
  ts_log_fn log = nullptr;
  void *log_user = nullptr;

  void write_log(ts_log_level level, const std::string &text) const {
    if (log) log(level, text.c_str(), log_user);
  }
};

using ContextPtr = std::shared_ptr<const Context>;

class Stopwatch {
 public:
  double ms() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace ts::api

struct ts_context {
  ts::api::ContextPtr state;
};

struct ts_job final : ts::Monitor {
  ts_job(ts::api::ContextPtr c, ts_progress_fn f, void *u) : context(std::move(c)), progress(f), user(u) {}

  bool proceed(double f, const char *stage) noexcept override;
  bool stopped() const noexcept override { return cancelled.load(std::memory_order_relaxed); }
  const char *stage() const noexcept override { return stage_now; }

  // For a call that begins: a job that was cancelled before cancels it at once.
  ts::Progress begin() noexcept {
    fraction = 0;
    return ts::Progress(this);
  }

  const ts::api::ContextPtr context;
  const ts_progress_fn progress;
  void *const user;
  std::mutex calling;
  std::atomic<bool> cancelled{false};
  std::atomic<double> fraction{0};
  std::atomic<const char *> stage_now{"work"};  // a literal
};

namespace ts::api {

inline Progress progress_of(ts_job *job) {
  const Progress progress = job ? job->begin() : Progress();
  progress(0);
  return progress;
}

}  // namespace ts::api
