// The same work over and over, on several threads, beside a case that stays open: what is taken is given back, results
// stay the same, and the process does not grow.
//   soak SECONDS [--threads N]
// With GLIBC_TUNABLES=glibc.malloc.tcache_count=0 what malloc has in use is exact: threads keep nothing back.
// SPDX-License-Identifier: Apache-2.0
#include <malloc.h>
#include <toothseg_arch.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "arch.h"
#include "check.h"
#include "soak_session.h"

namespace {

// ------------------------------------------------------------------------------------------------- the hook's memory

struct Heap {
  std::atomic<long long> bytes{0}, blocks{0}, taken{0};
  bool empty() const { return bytes == 0 && blocks == 0; }
};
constexpr std::size_t kFront = 16;  // holds the size
void *take(std::size_t bytes, void *user) {
  Heap &h = *static_cast<Heap *>(user);
  void *const p = std::malloc(kFront + bytes);
  if (p == nullptr) return nullptr;
  std::memcpy(p, &bytes, sizeof bytes);
  h.bytes += static_cast<long long>(bytes), ++h.blocks, ++h.taken;
  return static_cast<char *>(p) + kFront;
}
void give(void *memory, void *user) {
  Heap &h = *static_cast<Heap *>(user);
  void *const p = static_cast<char *>(memory) - kFront;
  std::size_t bytes;
  std::memcpy(&bytes, p, sizeof bytes);
  h.bytes -= static_cast<long long>(bytes), --h.blocks;
  std::free(p);
}

// Without a heap: the system's memory.
Handle<ts_context> context_on(Heap *heap, std::uint32_t threads) {
  ts_context_options o;
  HOLDS(ts_context_options_init(&o, sizeof o) == TS_OK);
  o.threads = threads;
  if (heap) o.alloc = take, o.free = give, o.alloc_user = heap;
  auto context = made<ts_context>([&](ts_context **out) { return ts_context_create(&o, out); });
  HOLDS(context != nullptr);
  return context;
}

// ------------------------------------------------------------------------------------------------------------ scans

Scan arch(std::uint32_t jaw, std::uint32_t triangles, std::uint64_t seed, double crowding) {
  tsa_options o;
  HOLDS(tsa_options_init(&o, sizeof o) == TSA_OK);
  o.jaw = jaw, o.triangles = triangles, o.seed = seed, o.crowding = crowding;
  Mesh m = arch_mesh(o);
  return {std::move(m.xyz), std::move(m.triangles)};
}

// ------------------------------------------------------------------------------------------------------------ rounds

struct Outcome {
  std::uint64_t hash = 0;  // of all labels
  long edits = 0;          // that were taken
  bool operator==(const Outcome &o) const { return hash == o.hash && edits == o.edits; }
};

// One worker's share of a round: every scan once, in contexts that are shared or made for it, with and without hooks.
Outcome work(std::size_t worker, const std::vector<Scan> &scans, ts_context *shared, Heap &heap,
             const std::string &folder) {
  Outcome all;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const std::size_t scan = (k + worker) % scans.size();
    Handle<ts_context> own;
    if ((scan + worker) % 2 == 1)
      own = context_on(scan < 2 ? &heap : nullptr, static_cast<std::uint32_t>(1 + scan % 3));
    const SessionOutcome one = soak_session(own ? own.get() : shared, scans[scan], scan % 2 == 1,
                                            folder + "/" + std::to_string(worker) + "-" + std::to_string(scan));
    // The order of the scans is not the same for all workers: a sum.
    all.hash += one.hash;
    all.edits += one.edits;
  }
  return all;
}

// A case that is open all the while, as in a program that somebody sits before: corrections that are taken back again
// leave it as large as it was. Each further thread makes itself a work space in each of the two pools of a
// segmentation (field::Solver, cut::Spaces) when it first finds all in use, which is a matter of chance, and leaves it
// there, to grow to what its cuts need: that much larger a case may become in all its life. On one thread it never may.
class OpenCase {
 public:
  OpenCase(const Scan &scan, std::uint32_t threads)
      : context_(context_on(&heap_, threads)),
        case_(soak_case(context_.get(), scan)),
        may_rise_(0.08 * (threads - 1)) {}
  void round() {
    soak_corrections(case_.get());
    const long long bytes = heap_.bytes;
    if (first_ == 0) first_ = before_ = bytes;
    if (bytes != before_) std::printf("the open case: from %lld to %lld bytes\n", before_, bytes);
    HOLDS(bytes >= before_ && static_cast<double>(bytes - first_) <= may_rise_ * static_cast<double>(first_));
    before_ = bytes;
  }
  double mib() const { return static_cast<double>(before_) / (1 << 20); }

 private:
  Heap heap_;  // has to outlive the others
  Handle<ts_context> context_;
  Handle<ts_segmentation> case_;
  double may_rise_;  // as a share of its size: both spaces of one thread are 5.5 %, and may grow
  long long first_ = 0, before_ = 0;
};

double resident_mib() {
  long whole = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> whole >> resident;
  return static_cast<double>(resident * sysconf(_SC_PAGESIZE)) / (1 << 20);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// How much the median of the last tenth of the rounds is over that of the second; the first is warming up.
double growth_of(const char *name, const std::vector<double> &mib) {
  const std::size_t tenth = mib.size() / 10;
  HOLDS(tenth >= 2);  // of fewer rounds nothing can be said
  const auto part = [&](std::size_t from) {
    const auto begin = mib.begin() + static_cast<std::ptrdiff_t>(from);
    return median({begin, begin + static_cast<std::ptrdiff_t>(tenth)});
  };
  const double first = part(tenth), last = part(mib.size() - tenth);
  std::printf("%s: median of the second tenth %.3f MiB, of the last %.3f MiB: %+.3f %%\n", name, first, last,
              100 * (last / first - 1));
  return last / first - 1;
}

// What glibc keeps back of freed memory is now more and now less: its thresholds move as it goes, and with many arenas,
// and large blocks among the small ones, so does what stays between blocks in use. Here that is small, and stays so.
void settle_malloc() {
  constexpr int mmap_from = 16 << 10, trim_from = 128 << 10;
  HOLDS(mallopt(M_MMAP_THRESHOLD, mmap_from) == 1 && mallopt(M_TRIM_THRESHOLD, trim_from) == 1);
  HOLDS(mallopt(M_ARENA_MAX, 1) == 1);
  const char *const tunables = std::getenv("GLIBC_TUNABLES");
  std::printf("malloc: M_ARENA_MAX 1, M_MMAP_THRESHOLD %d, M_TRIM_THRESHOLD %d, GLIBC_TUNABLES %s; no malloc_trim\n",
              mmap_from, trim_from, tunables ? tunables : "unset");
}

// Bytes that the C library has given out and not got back.
double in_use_mib() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd) / (1 << 20);
}

// Bytes of freed blocks that it keeps, since they lie below a block in use. Where resident memory has risen and this
// with it, it is no leak.
double kept_back_mib() {
  return static_cast<double>(mallinfo2().fordblks) / (1 << 20);
}

}  // namespace

int main(int argc, char **argv) {
  const bool usage = argc != 2 && !(argc == 4 && std::strcmp(argv[2], "--threads") == 0);
  const double seconds = usage ? 0 : std::atof(argv[1]);
  const std::size_t workers = argc == 4 ? std::strtoul(argv[3], nullptr, 10) : 2;
  if (seconds <= 0 || workers < 1 || workers > 64)
    return std::fprintf(stderr, "usage: soak SECONDS [--threads N]\n"), 2;
  std::setvbuf(stdout, nullptr, _IOLBF, 1024);
  settle_malloc();
  constexpr double kLong = 600;  // from here on resident memory is judged: less is warming up
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("toothseg-soak-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const std::vector<Scan> scans = {arch(TSA_JAW_UPPER, 6000, 1, 0), arch(TSA_JAW_LOWER, 12000, 2, 0.35),
                                   arch(TSA_JAW_UPPER, 25000, 3, 0.65)};
  Heap shared_heap, own_heap;
  const auto shared = context_on(&shared_heap, 2);
  const Scan large = arch(TSA_JAW_LOWER, 60000, 4, 0);
  OpenCase open(large, 2), open_on_one(large, 1);
  HOLDS(shared_heap.empty());

  const auto at_once = [&](std::size_t many) {
    std::vector<Outcome> outcomes(many);
    std::vector<std::thread> threads;
    for (std::size_t w = 0; w < many; ++w)
      threads.emplace_back([&, w] { outcomes[w] = work(w, scans, shared.get(), own_heap, folder.string()); });
    for (std::thread &t : threads) t.join();
    return outcomes;
  };
  // oneTBB starts a thread when it first wants one, be it after an hour. What glibc has of a thread (a kilobyte, as
  // long as that lives) then lies above all that is in use at that moment, and none of it goes back to the system. So
  // here all start before memory is looked at: more is asked of them at once than in any round.
  if (seconds >= kLong) at_once(8);
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const auto since = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  std::vector<double> resident, in_use;
  std::vector<Outcome> first;
  for (double printed = -1e9; resident.empty() || since() < seconds;) {
    const std::vector<Outcome> outcomes = at_once(workers);
    open.round(), open_on_one.round();
    if (resident.empty()) first = outcomes;
    HOLDS(outcomes == first);
    HOLDS(outcomes[0].edits > 0);
    HOLDS(shared_heap.empty() && own_heap.empty());
    resident.push_back(resident_mib()), in_use.push_back(in_use_mib());
    if (since() - printed >= 10) {
      printed = since();
      std::printf(
          "%7.0f s, round %zu: resident %.2f MiB, of malloc in use %.2f, kept back %.2f; hooks: %lld bytes live, "
          "%.2f MiB of the open cases, %lld allocations\n",
          printed, resident.size(), resident.back(), in_use.back(), kept_back_mib(),
          static_cast<long long>(shared_heap.bytes + own_heap.bytes), open.mib() + open_on_one.mib(),
          static_cast<long long>(shared_heap.taken + own_heap.taken));
    }
  }
  std::filesystem::remove_all(folder);
  HOLDS(shared_heap.taken > 1000 && own_heap.taken > 1000);
  std::printf("%zu rounds on %zu threads in %.0f s, %ld edits a round; 0 bytes live after each\n", resident.size(),
              workers, since(), first[0].edits);
  bool good = true;
  if (seconds >= kLong) {
    good = growth_of("malloc in use", in_use) <= 0.01;
    good = growth_of("resident", resident) <= 0.01 && good;
  }
  std::printf("%d passed, %d failed\n", good, !good);
  return !good;
}
