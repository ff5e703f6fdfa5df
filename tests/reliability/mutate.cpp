// Damaged files of every format that is read, each refused with a reason or loaded with a report that is true; none
// takes more than 5 s, or memory that it does not give back.
//   mutate COUNT [SEED]. SPDX-License-Identifier: Apache-2.0
#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <thread>

#include "check.h"
#include "damage.h"

namespace {

// ------------------------------------------------------------------------------------------------- the hook's memory

struct Hook {
  long long live = 0, bytes = 0, most = 0;  // most: of `bytes`, since it was last set
};
constexpr std::size_t kFront = 16;  // holds the size
void *take(std::size_t bytes, void *user) {
  Hook &h = *static_cast<Hook *>(user);
  void *const p = std::malloc(kFront + bytes);
  if (p == nullptr) return nullptr;
  std::memcpy(p, &bytes, sizeof bytes);
  ++h.live;
  h.most = std::max(h.most, h.bytes += static_cast<long long>(bytes));
  return static_cast<char *>(p) + kFront;
}
void give(void *memory, void *user) {
  Hook &h = *static_cast<Hook *>(user);
  std::size_t bytes;
  std::memcpy(&bytes, static_cast<char *>(memory) - kFront, sizeof bytes);
  --h.live;
  h.bytes -= static_cast<long long>(bytes);
  std::free(static_cast<char *>(memory) - kFront);
}

Handle<ts_context> context_on(Hook &hook) {
  ts_context_options o;
  HOLDS(ts_context_options_init(&o, sizeof o) == TS_OK);
  o.threads = 1;  // so that the time is that of this thread
  o.alloc = take, o.free = give, o.alloc_user = &hook;
  auto context = made<ts_context>([&](ts_context **out) { return ts_context_create(&o, out); });
  HOLDS(context != nullptr);
  return context;
}

// ---------------------------------------------------------------------------------------------------------- no hang

double seconds_of(clockid_t clock) {
  timespec t;
  HOLDS(clock_gettime(clock, &t) == 0);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// Ends the program where a file takes the thread that made this more than 5 s of its own time, however busy the machine
// is, or where it waits for something that does not come.
class Watchdog {
 public:
  Watchdog() {
    HOLDS(pthread_getcpuclockid(pthread_self(), &clock_) == 0);
    thread_ = std::thread([this] { watch(); });
  }
  ~Watchdog() {
    over_ = true;
    thread_.join();
  }
  void begin() { began_ = seconds_of(clock_), began_waiting_ = seconds_of(CLOCK_MONOTONIC); }
  // Seconds of the thread's own time since begin().
  double end() {
    const double took = seconds_of(clock_) - began_;
    began_ = -1;
    HOLDS(took <= kMost);
    return took;
  }

 private:
  static constexpr double kMost = 5, kMostWaiting = 120;
  void watch() {
    while (!over_) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      const double began = began_, waiting = began_waiting_;
      if (began < 0) continue;
      HOLDS(seconds_of(clock_) - began <= 2 * kMost);  // it may have begun the next file meanwhile
      HOLDS(seconds_of(CLOCK_MONOTONIC) - waiting <= kMostWaiting);
    }
  }

  clockid_t clock_{};
  std::atomic<double> began_{-1}, began_waiting_{0};
  std::atomic<bool> over_{false};
  std::thread thread_;
};

// ------------------------------------------------------------------------------------------------------------ files

void write(const std::string &path, const std::string &bytes) {
  std::ofstream file(path, std::ios::binary);
  file << bytes;
  HOLDS(file.flush().good());
}

// From a file, from memory with the format given, or told from the content. The copy has no byte more than the file.
ts_status load(ts_context *context, const GoodFile &kind, const std::string &path, unsigned way, ts_model **out) {
  ts_intake_options options;
  HOLDS(ts_intake_options_init(&options, sizeof options) == TS_OK);
  if (way % 2 == 1) options.unit = TS_UNIT_MM;  // gets past the check of the size
  if (way < 2) return ts_model_load(context, path.c_str(), &options, nullptr, out);
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  return ts_model_read(context, bytes.data(), bytes.size(), way < 4 ? kind.format : TS_FORMAT_AUTO, &options, nullptr,
                       out);
}

ts_status try_model(ts_context *context, const GoodFile &kind, const std::string &path, unsigned way) {
  ts_status got;
  const auto model = made<ts_model>([&](ts_model **out) { return load(context, kind, path, way, out); }, &got);
  check::status(got, {3, 4});
  HOLDS(got != TS_E_FILE_OPEN);
  HOLDS((got == TS_OK) == (model != nullptr));
  if (model) check::model(model.get());
  return got;
}

// A session that is read is one: it can be written, and read again with the same teeth.
ts_status try_session(const ts_model *model, const std::string &path) {
  ts_status got;
  ts_features *features = nullptr;
  const auto s = made<ts_segmentation>(
      [&](ts_segmentation **out) { return ts_session_load(model, path.c_str(), nullptr, &features, out); }, &got);
  const Handle<ts_features> kept(features);
  check::status(got, {1, 3});
  HOLDS(got / 100 != 1 || got == TS_E_MISMATCH);
  HOLDS(got != TS_E_FILE_OPEN);
  HOLDS((got == TS_OK) == (s != nullptr) && (s != nullptr) == (features != nullptr));
  if (!s) return got;
  check::features(model, features);
  check::segmentation(model, s.get(), false);
  const auto text_of = [](const ts_segmentation *of) {
    return check::all<char>([&](char *p, std::uint32_t n, std::uint32_t *c) { return ts_session_write(of, p, n, c); });
  };
  const auto text = text_of(s.get());
  const auto again = made<ts_segmentation>(
      [&](ts_segmentation **out) { return ts_session_read(model, text.data(), text.size(), nullptr, nullptr, out); });
  HOLDS(again != nullptr && text_of(again.get()) == text);
  return got;
}

// As they are, all have to load, with the counts that they were written with.
void all_are_good(ts_context *context, const ts_model *scene, const std::vector<GoodFile> &files,
                  const std::string &path) {
  for (const GoodFile &f : files) {
    write(path, f.bytes);
    if (f.session()) {
      HOLDS(try_session(scene, path) == TS_OK);
      continue;
    }
    for (unsigned way = 0; way < 6; ++way) HOLDS(try_model(context, f, path, way) == TS_OK);
    const auto model = made<ts_model>([&](ts_model **out) { return load(context, f, path, 0, out); });
    ts_intake_report report;
    report.struct_size = sizeof report;
    HOLDS(ts_model_get_report(model.get(), &report) == TS_OK);
    HOLDS(report.input_vertices == f.vertices && report.input_faces == f.faces);
    HOLDS(report.degenerate_faces == 0 && report.duplicate_faces == 0);
  }
}

void print(const std::vector<GoodFile> &kinds, const std::map<std::pair<std::string, int>, long> &outcomes) {
  for (const GoodFile &kind : kinds) {
    std::printf("%s:", kind.name.c_str());
    for (const auto &[outcome, n] : outcomes)
      if (outcome.first == kind.name)
        std::printf(" %s %ld",
                    outcome.second == TS_OK ? "loaded" : ts_status_name(static_cast<ts_status>(outcome.second)) + 5, n);
    std::printf("\n");
  }
}

}  // namespace

int main(int argc, char **argv) {
  if (argc < 2 || argc > 3) return std::fprintf(stderr, "usage: mutate COUNT [SEED]\n"), 2;
  std::setvbuf(stdout, nullptr, _IOLBF, 1024);
  const unsigned long count = std::strtoul(argv[1], nullptr, 10);
  const unsigned long seed = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1;
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("toothseg-mutate-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const std::string path = folder / "file";
  std::printf("if this ends early, the file that did it is %s\n", path.c_str());

  const std::vector<GoodFile> kinds = good_files(folder);
  Hook hook, scene_hook;
  const auto context = context_on(hook), scene_context = context_on(scene_hook);
  const auto scene = model_of(scene_context.get(), session_bumps());
  const long long scene_live = scene_hook.live;
  all_are_good(context.get(), scene.get(), kinds, path);

  std::map<std::pair<std::string, int>, long> outcomes;
  unsigned long loaded = 0;
  double longest = 0;
  {
    Watchdog dog;
    for (unsigned long i = 0; i < count; ++i) {
      std::mt19937_64 random(seed * 1000003 + i);
      const GoodFile &kind = kinds[i % kinds.size()];
      const std::string bytes = damaged(kind, random);
      write(path, bytes);
      hook.most = scene_hook.most = 0;
      dog.begin();
      const ts_status got = kind.session() ? try_session(scene.get(), path)
                                           : try_model(context.get(), kind, path, static_cast<unsigned>(random() % 6));
      longest = std::max(longest, dog.end());
      HOLDS(hook.live == 0 && hook.bytes == 0 && scene_hook.live == scene_live);
      // Not what a count in the file says: these files have some ten thousand bytes.
      HOLDS(std::max(hook.most, scene_hook.most) < (32 << 20));
      ++outcomes[{kind.name, got}];
      loaded += got == TS_OK;
    }
  }
  std::filesystem::remove_all(folder);
  print(kinds, outcomes);
  std::printf("%lu files of seed %lu: %lu refused, %lu loaded; the longest took %.3f s\n", count, seed, count - loaded,
              loaded, longest);
  std::printf("%lu passed, 0 failed\n", count);
  return 0;
}
