// The thread rules of the header: what may go on at the same time does, with the same results. For ThreadSanitizer
// above all. SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <thread>

#include "check.h"
#include "scene.h"

namespace {

int passed = 0;
void run(const char *name, const std::function<void()> &test) {
  test();  // what does not hold ends the program
  ++passed;
  std::printf("%s\n", name);
}

// work(k) on n threads at once.
void at_once(int n, const std::function<void(int)> &work) {
  std::vector<std::thread> threads;
  for (int k = 0; k < n; ++k) threads.emplace_back(work, k);
  for (std::thread &t : threads) t.join();
}

Handle<ts_context> context_with(std::uint32_t threads) {
  ts_context_options o;
  HOLDS(ts_context_options_init(&o, sizeof o) == TS_OK);
  o.threads = threads;
  return made<ts_context>([&](ts_context **out) { return ts_context_create(&o, out); });
}

std::vector<std::uint32_t> labels_of(const ts_segmentation *s) {
  return check::all<std::uint32_t>(
      [&](std::uint32_t *p, std::uint32_t n, std::uint32_t *c) { return ts_get_labels(s, p, n, c); });
}

Handle<ts_segmentation> session_on(const ts_features *f) {
  auto s =
      made<ts_segmentation>([&](ts_segmentation **out) { return ts_segmentation_create(f, nullptr, nullptr, out); });
  HOLDS(s != nullptr);
  return s;
}

const Bumps &bumps() {
  static const Bumps made = make_bumps(4, 6, 5);
  return made;
}

void separate_sessions_on_one_model() {
  const auto context = context_with(2);
  const auto model = model_of(context.get(), bumps());
  const auto features = features_of(model.get(), bumps());
  const auto alone = session_on(features.get());
  HOLDS(ts_segment_all(alone.get(), nullptr) == TS_OK);
  const auto expected = labels_of(alone.get());
  at_once(8, [&](int k) {
    const auto s = session_on(features.get());
    for (int i = 0; i < 4; ++i)
      check::status(ts_segment_click(s.get(), bumps().top[(k + i) % 4].data(), nullptr, nullptr), {});
    HOLDS(labels_of(s.get()) == expected);
    HOLDS(ts_undo(s.get()) == TS_OK && ts_redo(s.get()) == TS_OK);
    check::model(model.get());
    check::segmentation(model.get(), s.get(), k == 0);
    ts_surface_point p;
    HOLDS(ts_model_nearest(model.get(), bumps().top[0].data(), &p) == TS_OK);
  });
}

// All that takes a const segmentation, eight times at once.
void one_session_read_by_all() {
  const auto context = context_with(2);
  const auto model = model_of(context.get(), bumps());
  const auto features = features_of(model.get(), bumps());
  const auto s = session_on(features.get());
  HOLDS(ts_segment_all(s.get(), nullptr) == TS_OK);
  HOLDS(ts_assign_numbers(s.get(), nullptr) == TS_OK);
  at_once(8, [&](int) {
    check::features(model.get(), features.get());
    check::segmentation(model.get(), s.get(), true);
    const auto text = check::all<char>(
        [&](char *p, std::uint32_t n, std::uint32_t *c) { return ts_session_write(s.get(), p, n, c); });
    const auto again = made<ts_segmentation>([&](ts_segmentation **out) {
      return ts_session_read(model.get(), text.data(), text.size(), nullptr, nullptr, out);
    });
    HOLDS(again != nullptr && labels_of(again.get()) == labels_of(s.get()));
  });
}

// Each long call is cancelled sooner and later on its way: it gives nothing and changes nothing, and works afterwards.
void cancelled_from_another_thread() {
  const auto context = context_with(2);
  const auto model = model_of(context.get(), bumps());
  const auto features = features_of(model.get(), bumps());
  const auto whole = session_on(features.get());
  HOLDS(ts_segment_all(whole.get(), nullptr) == TS_OK);
  const auto text = check::all<char>(
      [&](char *p, std::uint32_t n, std::uint32_t *c) { return ts_session_write(whole.get(), p, n, c); });
  const auto s = session_on(features.get());
  const auto all_undone = [&](ts_status got) {
    if (got == TS_OK) HOLDS(ts_undo(s.get()) == TS_OK);
    const auto labels = labels_of(s.get());
    HOLDS(std::count(labels.begin(), labels.end(), 0u) == static_cast<std::ptrdiff_t>(labels.size()));
    return got;
  };
  const auto maker = []<class T>(ts_status got, T *out) {
    HOLDS((got == TS_OK) == (out != nullptr));
    Destroy()(out);
    return got;
  };
  const std::function<ts_status(ts_job *)> calls[] = {
      [&](ts_job *job) { return all_undone(ts_segment_all(s.get(), job)); },
      [&](ts_job *job) {
        const ts_mesh_input input = input_of(bumps());
        ts_model *out = nullptr;
        const ts_status got = ts_model_create(context.get(), &input, nullptr, job, &out);
        return maker(got, out);
      },
      [&](ts_job *job) {
        ts_segmentation *out = nullptr;
        const ts_status got = ts_segmentation_create(features.get(), nullptr, job, &out);
        return maker(got, out);
      },
      [&](ts_job *job) {
        ts_segmentation *out = nullptr;
        const ts_status got = ts_session_read(model.get(), text.data(), text.size(), job, nullptr, &out);
        return maker(got, out);
      },
  };
  const auto job = made<ts_job>([&](ts_job **out) { return ts_job_create(context.get(), nullptr, nullptr, out); });
  for (const auto &call : calls)
    for (int round = 0; round < 8; ++round) {
      std::thread other([&] {
        double last = 0;
        for (int k = 0; k < round * 40000; ++k) last = std::max(last, ts_job_progress(job.get()));
        HOLDS(last <= 1);
        ts_job_cancel(job.get());
      });
      const ts_status got = call(job.get());
      HOLDS(got == TS_OK || got == TS_E_CANCELLED);
      other.join();
      HOLDS(call(job.get()) == TS_E_CANCELLED);  // sticky
      ts_job_reset(job.get());
      HOLDS(call(job.get()) == TS_OK);
    }
}

// Half of the threads work in a context that stays.
void contexts_come_and_go() {
  const auto staying = context_with(2);
  at_once(8, [&](int k) {
    for (int round = 0; round < 3; ++round) {
      Handle<ts_context> own;
      if (k % 2 == 0) own = context_with(1 + k % 3);
      auto model = model_of(own ? own.get() : staying.get(), bumps());
      auto features = features_of(model.get(), bumps());
      own.reset();  // its children keep it
      auto s = session_on(features.get());
      features.reset();
      model.reset();
      HOLDS(ts_segment_click(s.get(), bumps().top[k % 4].data(), nullptr, nullptr) == TS_OK);
    }
  });
}

struct Heap {
  std::atomic<long> live{0}, taken{0};
  long mark;
};
void *take(std::size_t bytes, void *user) {
  auto &h = *static_cast<Heap *>(user);
  void *p = nullptr;
  if (posix_memalign(&p, 16, bytes + 16) != 0) return nullptr;
  std::memcpy(p, &h.mark, sizeof h.mark);
  ++h.live, ++h.taken;
  return static_cast<char *>(p) + 16;
}
void give(void *memory, void *user) {
  auto &h = *static_cast<Heap *>(user);
  long mark;
  void *const p = static_cast<char *>(memory) - 16;
  std::memcpy(&mark, p, sizeof mark);
  HOLDS(mark == h.mark);  // to whom it belongs
  --h.live;
  std::free(p);
}

void allocators_are_kept_apart() {
  static Heap heaps[2];
  heaps[0].mark = 111, heaps[1].mark = 222;
  at_once(4, [&](int k) {
    Heap &h = heaps[k % 2];
    ts_context_options o;
    HOLDS(ts_context_options_init(&o, sizeof o) == TS_OK);
    o.threads = 2;
    o.alloc = take, o.free = give, o.alloc_user = &h;
    const auto context = made<ts_context>([&](ts_context **out) { return ts_context_create(&o, out); });
    const auto model = model_of(context.get(), bumps());
    const auto features = features_of(model.get(), bumps());
    const auto s = session_on(features.get());
    HOLDS(ts_segment_all(s.get(), nullptr) == TS_OK);
    check::segmentation(model.get(), s.get(), true);
  });
  for (const Heap &h : heaps) HOLDS(h.live == 0 && h.taken > 100);
}

// One context given to many calls at once; messages are a thread's own.
void one_context_for_all() {
  const auto context = context_with(2);
  at_once(8, [&](int k) {
    const auto model = model_of(context.get(), bumps());
    const auto job = made<ts_job>([&](ts_job **out) { return ts_job_create(context.get(), nullptr, nullptr, out); });
    HOLDS(job != nullptr);
    const std::string path = "/nowhere/" + std::to_string(k);
    ts_model *none = nullptr;
    HOLDS(ts_model_load(context.get(), path.c_str(), nullptr, nullptr, &none) == TS_E_FILE_OPEN);
    std::this_thread::yield();
    HOLDS(std::strstr(ts_last_error_message(), path.c_str()) != nullptr);
  });
}

}  // namespace

int main() {
  run("separate sessions on one model", separate_sessions_on_one_model);
  run("one session read by all", one_session_read_by_all);
  run("cancelled from another thread", cancelled_from_another_thread);
  run("contexts come and go", contexts_come_and_go);
  run("allocators are kept apart", allocators_are_kept_apart);
  run("one context for all", one_context_for_all);
  std::printf("%d passed, 0 failed\n", passed);
  return 0;
}
