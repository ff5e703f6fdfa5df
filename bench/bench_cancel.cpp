// How soon each long call returns once it is asked to stop: from another thread, at moments spread over the time that
// it takes undisturbed. JSON to stdout.
//   bench_cancel FOLDER [--triangles N] [--moments N] [--threads N] [--call NAME]. SPDX-License-Identifier: Apache-2.0
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <thread>

#include "tests/fuzz/check.h"
#include "tests/reliability/long_calls.h"

namespace {

using Clock = std::chrono::steady_clock;

double ms_between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double, std::milli>(to - from).count();
}

// Of all threads of the process: what a wait is made of where the machine has other work as well. What the kernel takes
// is giving pages and taking them back, and depends on the machine.
struct Cpu {
  double user = 0, kernel = 0;
};
Cpu cpu_ms() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  const auto ms = [](const timeval &t) {
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
  };
  return {ms(usage.ru_utime), ms(usage.ru_stime)};
}

struct Wait {
  double ms = 0;
  Cpu cpu;
  double at = 0;      // share of the undisturbed call
  std::string where;  // that the call says it was
};

struct Measured {
  double whole_ms = 0, sum_ms = 0;
  int cancelled = 0, too_late = 0;
  Wait longest;
};

Measured measure(Stage &stage, const LongCall &call, int moments) {
  const auto job =
      made<ts_job>([&](ts_job **out) { return ts_job_create(stage.context.get(), nullptr, nullptr, out); });
  HOLDS(job != nullptr);
  const auto back = [&] {
    if (call.is_step) HOLDS(ts_undo(stage.segmentation.get()) == TS_OK);
  };
  Measured m;
  for (int k = 0; k < 2; ++k) {  // the second time, when all is warm
    const auto begin = Clock::now();
    HOLDS(call.run(stage, job.get(), nullptr) == TS_OK);
    m.whole_ms = ms_between(begin, Clock::now());
    back();
  }
  for (int k = 0; k < moments; ++k) {
    ts_job_reset(job.get());
    const double share = (k + 0.5) / moments;
    Clock::time_point asked;
    Cpu asked_cpu;
    const auto begin = Clock::now();
    std::thread other([&] {
      std::this_thread::sleep_until(begin + std::chrono::duration_cast<Clock::duration>(
                                                std::chrono::duration<double, std::milli>(share * m.whole_ms)));
      asked_cpu = cpu_ms();
      asked = Clock::now();
      ts_job_cancel(job.get());
    });
    const ts_status got = call.run(stage, job.get(), nullptr);
    const auto returned = Clock::now();
    const Cpu returned_cpu = cpu_ms();
    const std::string where = got == TS_OK ? "nothing: it was done" : ts_last_error_message();
    other.join();
    HOLDS(got == TS_OK || got == TS_E_CANCELLED);
    if (got == TS_OK) back();
    if (returned < asked) {
      ++m.too_late;
      continue;
    }
    m.cancelled += got == TS_E_CANCELLED;
    const double ms = ms_between(asked, returned);
    m.sum_ms += ms;
    if (ms > m.longest.ms) {
      const Cpu spent = {returned_cpu.user - asked_cpu.user, returned_cpu.kernel - asked_cpu.kernel};
      m.longest = {ms, spent, share, where};
    }
  }
  return m;
}

}  // namespace

int main(int argc, char **argv) {
  const auto usage = [] {
    std::fprintf(stderr, "usage: bench_cancel FOLDER [--triangles N] [--moments N] [--threads N] [--call NAME]\n");
    return 2;
  };
  if (argc < 2 || argc % 2 != 0) return usage();
  std::uint32_t triangles = 1000000, threads = 0;
  int moments = 20;
  std::string only;
  for (int i = 2; i < argc; i += 2) {
    const std::string name = argv[i];
    if (name == "--triangles")
      triangles = static_cast<std::uint32_t>(std::strtoul(argv[i + 1], nullptr, 10));
    else if (name == "--moments")
      moments = std::atoi(argv[i + 1]);
    else if (name == "--threads")
      threads = static_cast<std::uint32_t>(std::strtoul(argv[i + 1], nullptr, 10));
    else if (name == "--call")
      only = argv[i + 1];
    else
      return usage();
  }
  std::filesystem::create_directories(argv[1]);
  ts_context_options options;
  HOLDS(ts_context_options_init(&options, sizeof options) == TS_OK);
  options.threads = threads;
  Stage stage(made<ts_context>([&](ts_context **out) { return ts_context_create(&options, out); }),
              arch_mesh(triangles, 1), argv[1]);
  std::printf("{\"triangles\": %u, \"threads\": %u, \"moments\": %d, \"calls\": [", triangles, threads, moments);
  double worst = 0;
  bool first = true;
  for (const LongCall &call : long_calls()) {
    if (!only.empty() && call.function != only) continue;
    const Measured m = measure(stage, call, moments);
    worst = std::max(worst, m.longest.ms);
    std::printf(
        "%s\n  {\"call\": \"%s\", \"whole_ms\": %.1f, \"cancelled\": %d, \"returned_before\": %d, \"mean_ms\": %.2f, "
        "\"max_ms\": %.2f, \"max_user_ms\": %.2f, \"max_kernel_ms\": %.2f, \"max_at\": %.3f, \"max_where\": \"%s\"}",
        first ? "" : ",", call.name().c_str(), m.whole_ms, m.cancelled, m.too_late,
        m.sum_ms / std::max(1, moments - m.too_late), m.longest.ms, m.longest.cpu.user, m.longest.cpu.kernel,
        m.longest.at, m.longest.where.c_str());
    std::fflush(stdout);
    first = false;
  }
  std::printf("],\n \"max_ms\": %.2f}\n", worst);
}
