// SPDX-License-Identifier: Apache-2.0
#include "faults_sampled.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <new>
#include <set>

#include "check.h"
#include "heap.h"
#include "long_calls.h"

namespace {

constexpr long kFirst = 50;  // of these allocations each fails

// What may be outside of the context's allocator at a time, of all that is inside: the buffers of files, small dense
// matrices, text, and the trees of what meshes of teeth are cut along.
constexpr double kOutside = 0.04;

struct Hook {
  long taken = 0, live = 0;
  long fails_at = 0;  // 0: never
  std::size_t bytes = 0, peak = 0;
};
void *take(std::size_t bytes, void *user) {
  Hook &h = *static_cast<Hook *>(user);
  if (++h.taken == h.fails_at) return nullptr;
  void *const p = heap::take_unseen(bytes);
  if (!p) return nullptr;
  ++h.live;
  h.bytes += heap::size_of(p);
  h.peak = std::max(h.peak, h.bytes);
  return p;
}
void give(void *memory, void *user) {
  Hook &h = *static_cast<Hook *>(user);
  --h.live;
  h.bytes -= heap::size_of(memory);
  heap::give_unseen(memory);
}

// The first ones, then `count` more, each as much further on as the one before.
std::set<long> sampled(long whole, int count) {
  std::set<long> n;
  for (long k = 1; k <= std::min(kFirst, whole); ++k) n.insert(k);
  const double ratio = static_cast<double>(whole) / kFirst;
  for (int k = 1; k <= count && whole > kFirst; ++k)
    n.insert(std::lround(kFirst * std::pow(ratio, static_cast<double>(k) / count)));
  return n;
}

class Sampler {
 public:
  Sampler(Stage &stage, Hook &hook, int samples) : s_(stage), hook_(hook), samples_(samples) {}

  // Whether all held.
  bool run(const LongCall &call) {
    for (int k = 0; k < 2; ++k) finish(call);  // what is set up at its first use
    const std::string before = s_.state();
    bool good = outside(call);
    long runs[2] = {0, 0}, whole[2] = {0, 0};
    for (const bool in_heap : {false, true}) {
      if (in_heap && !heap::can_fail) continue;
      const auto count = [&] { return in_heap ? heap::taken() : hook_.taken; };
      const auto fail_at = [&](long n) {
        if (in_heap)
          heap::fail_at(n);
        else
          hook_.fails_at = n ? hook_.taken + n : 0;
      };
      const long from = count();
      finish(call);
      whole[in_heap] = count() - from;
      const long live = hook_.live, outside = heap::live();
      for (const long n : sampled(whole[in_heap], samples_)) {
        fail_at(n);
        const ts_status got = attempt(call);
        fail_at(0);
        ++runs[in_heap];
        const auto told = [&](bool holds, const char *what) {
          if (!holds)
            std::printf("%s, allocation %ld of %ld of the %s: %s (%s)\n", call.name().c_str(), n, whole[in_heap],
                        in_heap ? "C heap" : "hook", what, ts_last_error_message());
          good = good && holds;
        };
        if (got == TS_OK) {  // it did without
          if (call.is_step) HOLDS(ts_undo(s_.segmentation.get()) == TS_OK);
        } else {
          told(got == TS_E_OUT_OF_MEMORY, ts_status_name(got));
        }
        told(hook_.live <= live, "leaks");
        told(heap::live() <= outside + (1 << 16), "leaks outside of the hook");
        told(s_.state() == before, "has changed something");
        if (!good) return false;
      }
      finish(call);  // works afterwards
      if (hook_.live != live || s_.state() != before) {
        std::printf("%s: is not as it was after all\n", call.name().c_str());
        return false;
      }
    }
    std::printf("%-34s failed %3ld of %7ld of the hook, %3ld of %6ld of the C heap\n", call.name().c_str(), runs[0],
                whole[0], runs[1], whole[1]);
    total_ += runs[0] + runs[1];
    return good;
  }

  long total() const { return total_; }

 private:
  void finish(const LongCall &call) {
    const ts_status got = call.run(s_, nullptr, nullptr);
    if (got != TS_OK) std::fprintf(stderr, "%s: %s\n", call.name().c_str(), ts_last_error_message());
    HOLDS(got == TS_OK);
    if (call.is_step) HOLDS(ts_undo(s_.segmentation.get()) == TS_OK);
  }

  // Paths and lists of this program's own are of the C heap, too; from the library nothing is thrown.
  ts_status attempt(const LongCall &call) {
    try {
      return call.run(s_, nullptr, nullptr);
    } catch (const std::bad_alloc &) {
      return TS_E_OUT_OF_MEMORY;
    }
  }

  // How much of the call's memory is not of the context's allocator.
  bool outside(const LongCall &call) {
    if (!heap::can_fail) return true;
    hook_.peak = hook_.bytes;
    const long before = heap::live();
    heap::forget_peak();
    finish(call);
    const double inside = static_cast<double>(hook_.peak), out = static_cast<double>(heap::peak() - before);
    std::printf("%-34s %8.2f MB inside, %6.2f MB outside: %.2f %%\n", call.name().c_str(), inside / 1e6, out / 1e6,
                100 * out / inside);
    if (out <= kOutside * inside) return true;
    std::printf("%s: more than %.0f %% is outside\n", call.name().c_str(), 100 * kOutside);
    return false;
  }

  Stage &s_;
  Hook &hook_;
  int samples_;
  long total_ = 0;
};

}  // namespace

int sampled_faults(const std::string &in, unsigned triangles, int samples, const std::string &only) {
  const std::string folder = in + "/faults-sampled" + only;
  std::filesystem::create_directories(folder);
  static Hook hook;
  ts_context_options options;
  HOLDS(ts_context_options_init(&options, sizeof options) == TS_OK);
  options.threads = 1;
  options.alloc = take, options.free = give, options.alloc_user = &hook;
  int failed = 0;
  {
    Stage stage(made<ts_context>([&](ts_context **out) { return ts_context_create(&options, out); }),
                arch_mesh(triangles, 1), folder);
    Sampler sampler(stage, hook, samples);
    for (const LongCall &call : long_calls())
      if (only.empty() || call.name() == only) failed += !sampler.run(call);
    if (sampler.total() == 0) std::printf("no call is named %s\n", only.c_str()), ++failed;
    std::printf("%u triangles: %ld allocations failed, %d calls did not hold\n", triangles, sampler.total(), failed);
  }
  if (hook.live != 0) std::printf("%ld blocks are left\n", hook.live), ++failed;
  std::filesystem::remove_all(folder);
  return failed != 0;
}
