// Random sequences of calls, against what must hold whatever comes: handles in any order, edits, undo and redo,
// cancelling, destroying. SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "check.h"
#include "input.h"
#include "scene.h"

namespace {

using Text = std::vector<char>;

struct Stop {
  int after;  // callbacks
};
int progress(double, const char *, void *user) {
  return --static_cast<Stop *>(user)->after < 0;
}

// A segmentation and what is known of it.
struct Session {
  Handle<ts_segmentation> handle;
  std::vector<Text> past, future;  // as ts_session_write gives them, without what is undone
  Text now;
};

Text labels_of(const ts_segmentation *s) {
  const auto labels = check::all<std::uint32_t>(
      [&](std::uint32_t *p, std::uint32_t n, std::uint32_t *c) { return ts_get_labels(s, p, n, c); });
  const auto *bytes = reinterpret_cast<const char *>(labels.data());
  return Text(bytes, bytes + labels.size() * sizeof labels[0]);
}

class Model {
 public:
  explicit Model(Input &in) : in_(in), context_(one_thread()), bumps_(make_bumps(3, 5, 5)) {
    model_ = model_of(context_.get(), bumps_);
    features_ = features_of(model_.get(), bumps_);
  }

  void run() {
    for (int step = 0; step < 12 && !in_.empty(); ++step) one();
    for (const Session &s : sessions_) check::segmentation(model_.get(), s.handle.get(), false);
  }

 private:
  void one() {
    if (sessions_.empty() || in_.byte() % 16 == 0) return create();
    Session &s = sessions_[in_.below(static_cast<std::uint32_t>(sessions_.size()))];
    switch (in_.byte() % 20) {
      case 0: return destroy(s);
      case 1: return let_go_of_parents();
      case 2: return undo(s);
      case 3: return redo(s);
      case 4: return edit_features();
      case 5: return save_and_resume(s);
      default: return change(s);
    }
  }

  void create() {
    if (!features_ || sessions_.size() > 2) return;
    ts_status got;
    Session s{made<ts_segmentation>(
                  [&](ts_segmentation **out) { return ts_segmentation_create(features_.get(), nullptr, nullptr, out); },
                  &got),
              {},
              {},
              {}};
    check::status(got, {5, 6});
    if (!s.handle) return;
    s.now = labels_of(s.handle.get());
    sessions_.push_back(std::move(s));
  }

  void destroy(Session &s) { sessions_.erase(sessions_.begin() + (&s - sessions_.data())); }

  // Children keep their parents alive.
  void let_go_of_parents() {
    if (in_.byte() % 2)
      features_.reset();
    else
      context_.reset();
  }

  void edit_features() {
    if (!features_) return;
    const auto point = [&] { return in_.below(8); };
    const std::array<double, 3> at = place();
    switch (in_.byte() % 5) {
      case 0:
        check::status(ts_features_add_point(features_.get(), at.data(), in_.below(6), nullptr, nullptr), {1});
        break;
      case 1: check::status(ts_features_move_point(features_.get(), point(), at.data()), {1}); break;
      case 2: check::status(ts_features_remove_point(features_.get(), point()), {1}); break;
      case 3: check::status(ts_features_set_group(features_.get(), point(), in_.below(6), nullptr), {1}); break;
      default: check::status(ts_features_remove_group(features_.get(), in_.below(6)), {1}); break;
    }
    check::features(model_.get(), features_.get());
  }

  std::array<double, 3> place() { return {in_.share() * 20 - 1, in_.share() * 14 - 7, in_.share() * 6}; }

  std::uint32_t tooth(const Session &s) {
    const auto teeth = check::all<std::uint32_t>(
        [&](std::uint32_t *p, std::uint32_t n, std::uint32_t *c) { return ts_get_teeth(s.handle.get(), p, n, c); });
    return teeth.empty() || in_.byte() % 16 == 0 ? in_.below(10)
                                                 : teeth[in_.below(static_cast<std::uint32_t>(teeth.size()))];
  }

  void change(Session &s) {
    ts_segmentation *h = s.handle.get();
    Stop stop{in_.byte() % 4 == 0 ? in_.byte() % 8 : 1 << 20};
    Handle<ts_job> job;
    if (context_) job = made<ts_job>([&](ts_job **out) { return ts_job_create(context_.get(), progress, &stop, out); });
    const std::array<double, 3> a = place(), b = place();
    const std::uint32_t t = tooth(s);
    ts_history_info before{}, after{};
    before.struct_size = after.struct_size = sizeof before;
    HOLDS(ts_get_history(h, &before) == TS_OK);
    ts_status got;
    switch (in_.byte() % 15) {
      case 0: got = ts_segment_all(h, job.get()); break;
      case 1: got = ts_tooth_include(h, t, a.data(), job.get()); break;
      case 2: got = ts_tooth_exclude(h, t, a.data(), job.get()); break;
      case 3: got = ts_tooth_split(h, t, a.data(), b.data(), job.get(), nullptr); break;
      case 4: got = ts_tooth_merge(h, t, tooth(s), job.get()); break;
      case 5: got = ts_tooth_remove(h, t); break;
      case 6: got = ts_tooth_set_locked(h, t, in_.byte() % 2); break;
      case 7: got = ts_tooth_move_point(h, t, bumps_.top[in_.below(3)].data(), a.data(), job.get()); break;
      case 8: got = ts_cut_drag(h, t, 0, in_.below(40), a.data(), in_.share() * 4, job.get()); break;
      case 9: got = ts_cut_offset(h, t, in_.share() * 3 - 1.5, job.get()); break;
      case 10: got = ts_cut_smooth(h, t, in_.share() * 2, job.get()); break;
      case 11: got = ts_assign_numbers(h, nullptr); break;
      case 12: got = ts_set_number(h, t, in_.below(50)); break;
      case 13: {
        double stroke[9];
        std::copy(a.begin(), a.end(), stroke), std::copy(b.begin(), b.end(), stroke + 3);
        const auto c = place();
        std::copy(c.begin(), c.end(), stroke + 6);
        got = ts_cut_draw(h, t, stroke, 3, job.get());
        break;
      }
      default: got = ts_segment_click(h, a.data(), job.get(), nullptr); break;
    }
    check::status(got, {1, 2, 6, 7});
    HOLDS(got != TS_E_OUT_OF_MEMORY);
    const Text labels = labels_of(h);
    HOLDS(ts_get_history(h, &after) == TS_OK);
    if (got != TS_OK) {  // nothing has changed
      HOLDS(labels == s.now && after.undo == before.undo && after.redo == before.redo);
      return;
    }
    HOLDS(after.undo == before.undo + 1 && after.redo == 0);
    s.past.push_back(s.now);
    s.future.clear();
    s.now = labels;
  }

  void undo(Session &s) {
    const ts_status got = ts_undo(s.handle.get());
    HOLDS(got == (s.past.empty() ? TS_E_NO_HISTORY : TS_OK));
    if (got != TS_OK) return;
    s.future.push_back(s.now);
    s.now = s.past.back();
    s.past.pop_back();
    HOLDS(labels_of(s.handle.get()) == s.now);
  }

  void redo(Session &s) {
    const ts_status got = ts_redo(s.handle.get());
    HOLDS(got == (s.future.empty() ? TS_E_NO_HISTORY : TS_OK));
    if (got != TS_OK) return;
    s.past.push_back(s.now);
    s.now = s.future.back();
    s.future.pop_back();
    HOLDS(labels_of(s.handle.get()) == s.now);
  }

  void save_and_resume(Session &s) {
    const Text text = check::all<char>(
        [&](char *p, std::uint32_t n, std::uint32_t *c) { return ts_session_write(s.handle.get(), p, n, c); });
    ts_status got;
    auto resumed = made<ts_segmentation>(
        [&](ts_segmentation **out) {
          return ts_session_read(model_.get(), text.data(), text.size(), nullptr, nullptr, out);
        },
        &got);
    HOLDS(got == TS_OK && labels_of(resumed.get()) == s.now);
    s.handle = std::move(resumed);  // and on with that
  }

  Input &in_;
  Handle<ts_context> context_;
  Bumps bumps_;
  Handle<ts_model> model_;
  Handle<ts_features> features_;
  std::vector<Session> sessions_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  Input in(data, size);
  Model(in).run();
  return 0;
}
