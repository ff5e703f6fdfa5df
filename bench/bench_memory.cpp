#include <malloc.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "bench/bench_pipeline.h"
#include "bench/bench_run.h"

namespace ts::bench {
namespace {

constexpr double kGb = 1e9;

// A line of /proc/self/status, GB; not_measured where there is none.
double status_gb(const char *name) {
  std::FILE *file = std::fopen("/proc/self/status", "r");
  if (!file) return not_measured;
  double gb = not_measured;
  for (char line[256]; std::fgets(line, sizeof line, file);)
    if (std::strncmp(line, name, std::strlen(name)) == 0) gb = std::atof(line + std::strlen(name)) * 1024 / kGb;
  std::fclose(file);
  return gb;
}

// What the library holds of the caller's allocator.
struct Held {
  std::atomic<std::size_t> now{0}, most{0};
};

void *counted_alloc(std::size_t bytes, void *user) {
  void *memory = std::malloc(bytes);
  if (!memory) return nullptr;
  Held &held = *static_cast<Held *>(user);
  const std::size_t now = held.now += malloc_usable_size(memory);
  for (std::size_t most = held.most; most < now && !held.most.compare_exchange_weak(most, now);) {
  }
  return memory;
}

void counted_free(void *memory, void *user) {
  static_cast<Held *>(user)->now -= malloc_usable_size(memory);
  std::free(memory);
}

}  // namespace

void measure_memory(const std::string &mesh_file, Figures &figures) {
  Held held;
  ts_context_options hooks{};
  hooks.alloc = counted_alloc;
  hooks.free = counted_free;
  hooks.alloc_user = &held;
  {
    Pipeline p = prepare(read_mesh(mesh_file), 0, &hooks);
    figures.set("peak_prepare_gb", status_gb("VmHWM:"));
    figures.set("steady_gb", status_gb("VmRSS:"));
    figures.set("steady_hook_gb", static_cast<double>(held.now) / kGb);
    const std::vector<Point> points = proposed_clicks(p);
    for (const Point &at : points)  // one that fails is counted where times are taken
      if (ts_segment_click(p.segmentation.get(), at.data(), nullptr, nullptr) != TS_OK) continue;
    forget_clicks(p);
    click_all(p, points);
    uint32_t count = 0;
    need_ok(ts_get_labels(p.segmentation.get(), nullptr, 0, &count), "ts_get_labels");
    std::vector<uint32_t> labels(count);
    need_ok(ts_get_labels(p.segmentation.get(), labels.data(), count, &count), "ts_get_labels");
    figures.set("peak_gb", status_gb("VmHWM:"));
    figures.set("peak_hook_gb", static_cast<double>(held.most) / kGb);
  }
}

}  // namespace ts::bench
