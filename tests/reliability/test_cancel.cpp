// Every long call, cancelled: at each of its callbacks, at allocations in between, before it begins, and from another
// thread. It says TS_E_CANCELLED, its out-parameters are untouched and nothing has changed; the next call gives the
// same bytes as one that was never disturbed.
//   test_cancel FOLDER abi/toothseg.json [CALL]. SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <thread>

#include "check.h"
#include "long_calls.h"

namespace {

// The least that all calls work on.
constexpr std::uint32_t kFaces = 6000;

#ifdef TS_SANITIZED
constexpr long kMoments = 4, kEach = 8;
#else
constexpr long kMoments = 16, kEach = 1;
#endif
constexpr long kFirst = 40;

// ------------------------------------------------------------------------------------------ what cancels, and when

struct Callbacks {
  long calls = 0, stops_at = 0;  // 0: never
};
int report(double fraction, const char *stage, void *user) {
  Callbacks &c = *static_cast<Callbacks *>(user);
  HOLDS(fraction >= 0 && fraction <= 1 && stage != nullptr && stage[0] != 0);
  return ++c.calls == c.stops_at;
}

// Between callbacks: an allocation of the context's is a moment that comes again.
struct Allocations {
  long taken = 0, stops_at = 0;
  ts_job *job = nullptr;
};
void *take(std::size_t bytes, void *user) {
  Allocations &a = *static_cast<Allocations *>(user);
  if (++a.taken == a.stops_at) ts_job_cancel(a.job);
  return std::malloc(bytes);
}
void give(void *memory, void *) {
  std::free(memory);
}

Handle<ts_job> job_of(Stage &s, ts_progress_fn progress, void *user) {
  auto job = made<ts_job>([&](ts_job **out) { return ts_job_create(s.context.get(), progress, user, out); });
  HOLDS(job != nullptr);
  return job;
}

std::set<std::string> names_in(const std::string &folder) {
  std::set<std::string> names;
  for (const auto &entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

// ------------------------------------------------------------------------------------------------------------ a call

class Trial {
 public:
  Trial(Stage &stage, const LongCall &call) : s_(stage), call_(call) {
    finish(nullptr);  // a step leaves something to redo from now on
    state_ = s_.state();
    whole_ = finish(nullptr);
    HOLDS(finish(nullptr) == whole_);
    if (!call_.file.empty()) {
      std::ofstream(s_.path(call_.file), std::ios::binary) << kBefore;
      files_ = names_in(s_.folder);
    }
  }

  // To its end; gives what it made.
  std::string finish(ts_job *job) {
    std::string result;
    const ts_status got = call_.run(s_, job, &result);
    if (got != TS_OK) std::fprintf(stderr, "%s: %s\n", call_.name().c_str(), ts_last_error_message());
    HOLDS(got == TS_OK && !result.empty());
    if (call_.is_step) HOLDS(ts_undo(s_.segmentation.get()) == TS_OK);
    return result;
  }

  // Once, with a job that is cancelled at some time; whether that was in time.
  bool disturbed(ts_job *job) {
    std::string result;
    const ts_status got = call_.run(s_, job, &result);
    if (got == TS_OK) {
      HOLDS(result == whole_);
      if (call_.is_step) HOLDS(ts_undo(s_.segmentation.get()) == TS_OK);
    } else {
      if (got != TS_E_CANCELLED) std::fprintf(stderr, "%s: %s\n", call_.name().c_str(), ts_last_error_message());
      HOLDS(got == TS_E_CANCELLED);
      if (!call_.file.empty()) HOLDS(bytes_of_file(s_.path(call_.file)) == kBefore && names_in(s_.folder) == files_);
    }
    HOLDS(s_.state() == state_);
    if (got == TS_OK && !call_.file.empty()) std::ofstream(s_.path(call_.file), std::ios::binary) << kBefore;
    return got == TS_E_CANCELLED;
  }

  void at_each_callback() {
    Callbacks callbacks;
    const auto job = job_of(s_, report, &callbacks);
    HOLDS(finish(job.get()) == whole_);
    HOLDS(ts_job_progress(job.get()) == 1);
    restore();
    const long all = callbacks.calls;
    HOLDS(all >= 2);
    for (long n = 1; n <= all; n += n < kFirst ? 1 : kEach) {
      ts_job_reset(job.get());
      callbacks = {0, n};
      HOLDS(disturbed(job.get()));
      HOLDS(callbacks.calls == n);  // none after it
    }
    callbacks_ = all;
  }

  void at_allocations(Allocations &allocations) {
    const auto job = job_of(s_, nullptr, nullptr);
    allocations = {0, 0, job.get()};
    call_.run(s_, nullptr, nullptr);
    const long all = allocations.taken;
    if (call_.is_step) HOLDS(ts_undo(s_.segmentation.get()) == TS_OK);
    restore();
    for (long k = 0; k < std::min(kMoments, all); ++k) {
      ts_job_reset(job.get());
      allocations = {0, 1 + k * all / kMoments, job.get()};
      in_time_ += disturbed(job.get());
      ++moments_;
    }
    allocations = {};
  }

  void before_it_begins() {
    const auto job = job_of(s_, nullptr, nullptr);
    ts_job_cancel(job.get());
    HOLDS(disturbed(job.get()) && disturbed(job.get()));  // sticky
    ts_job_reset(job.get());
    HOLDS(!disturbed(job.get()));
  }

  // When it has come to a share of the whole; where the other thread is late, the call has ended.
  void from_another_thread() {
    for (const double share : {0.0, 0.2, 0.4, 0.6, 0.8}) {
      const auto job = job_of(s_, nullptr, nullptr);
      std::atomic<bool> ended{false};
      std::thread other([&] {
        while (!ended && ts_job_progress(job.get()) < share) std::this_thread::yield();
        ts_job_cancel(job.get());
      });
      disturbed(job.get());
      ended = true;
      other.join();
    }
  }

  void done() {
    HOLDS(finish(nullptr) == whole_ && s_.state() == state_);
    std::printf("%-40s %4ld callbacks, in time at %2d of %2d allocations\n", call_.name().c_str(), callbacks_, in_time_,
                moments_);
  }

 private:
  static constexpr const char *kBefore = "what was there";
  void restore() {
    if (!call_.file.empty()) std::ofstream(s_.path(call_.file), std::ios::binary) << kBefore;
  }

  Stage &s_;
  const LongCall &call_;
  std::string state_, whole_;
  std::set<std::string> files_;
  long callbacks_ = 0;
  int in_time_ = 0, moments_ = 0;
};

}  // namespace

int main(int argc, char **argv) {
  if (argc < 3 || argc > 4) return std::fprintf(stderr, "usage: test_cancel FOLDER abi/toothseg.json [CALL]\n"), 2;
  std::setvbuf(stdout, nullptr, _IOLBF, 1024);
  const std::vector<LongCall> calls = long_calls();
  for (const std::string &name : functions_with_a_job(argv[2])) {
    const bool there = std::any_of(calls.begin(), calls.end(), [&](const LongCall &c) { return c.function == name; });
    if (!there) return std::fprintf(stderr, "%s takes a job and is not in long_calls.cpp\n", name.c_str()), 1;
  }
  const std::string folder = std::string(argv[1]) + "/cancel";
  std::filesystem::create_directories(folder);
  static Allocations allocations;
  ts_context_options options;
  HOLDS(ts_context_options_init(&options, sizeof options) == TS_OK);
  options.threads = 1;
  options.alloc = take, options.free = give, options.alloc_user = &allocations;
  Stage stage(made<ts_context>([&](ts_context **out) { return ts_context_create(&options, out); }),
              arch_mesh(kFaces, 1), folder);
  for (const LongCall &call : calls) {
    if (argc > 3 && call.function != argv[3]) continue;
    Trial t(stage, call);
    t.at_each_callback();
    t.at_allocations(allocations);
    t.before_it_begins();
    t.from_another_thread();
    t.done();
  }
  check::segmentation(stage.model.get(), stage.segmentation.get(), true);
  std::filesystem::remove_all(folder);
}
