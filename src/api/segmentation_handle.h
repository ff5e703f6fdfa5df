#pragma once

#include "api/features_handle.h"
#include "api/history.h"
#include "toothseg.h"

namespace ts::api {

// What a segmentation is made of; the session is replaced as a whole when clicks are added.
struct Prepared {
  std::shared_ptr<const FeaturesState> features;
  std::unique_ptr<const tooth::Segmenter> segmenter;

  const mesh::Surface &surface() const { return features->model->model.surface; }
  const Context &context() const { return *features->model->context; }
};

// The view of one click, kept because its contours are read one by one. Safe for concurrent readers.
class ViewCache {
 public:
  template <class Make>
  std::shared_ptr<const tooth::ClickView> get(uint32_t click, Make &&make) const {
    {
      const std::lock_guard lock(guard_);
      if (view_ && click_ == click) return view_;
    }
    auto view = std::make_shared<const tooth::ClickView>(make());
    const std::lock_guard lock(guard_);
    click_ = click;
    return view_ = std::move(view);
  }
  void forget() {
    const std::lock_guard lock(guard_);
    view_.reset();
  }

 private:
  mutable std::mutex guard_;
  mutable uint32_t click_ = 0;
  mutable std::shared_ptr<const tooth::ClickView> view_;
};

// What is worked out of a click when it is first asked for. Safe for concurrent readers.
class DetailsCache {
 public:
  template <class Make>
  tooth::ClickDetails get(uint32_t click, Make &&make) const {
    {
      const std::lock_guard lock(guard_);
      if (click < known_.size() && known_[click]) return *known_[click];
    }
    const tooth::ClickDetails details = make();
    const std::lock_guard lock(guard_);
    if (click >= known_.size()) known_.resize(click + 1);
    known_[click] = details;
    return details;
  }
  void forget() {
    const std::lock_guard lock(guard_);
    known_.clear();
  }

 private:
  mutable std::mutex guard_;
  mutable Vec<std::optional<tooth::ClickDetails>> known_;
};

// Who is told what changed.
struct Listener {
  ts_change_fn call = nullptr;
  void *user = nullptr;
};

}  // namespace ts::api

struct ts_segmentation {
  std::unique_ptr<const ts::api::Prepared> prepared;
  ts::tooth::Session session;
  ts::api::ViewCache views{};
  ts::api::DetailsCache details{};
  ts::api::History history{};
  ts::Vec<uint32_t> changes{};  // ids, by the last call that changed something
  ts::api::Listener listener{};
  bool telling = false;  // the listener is being called
};

namespace ts::api {

// Ids, as the caller has them, and groups. The groups of the features have theirs; those made afterwards follow.
uint32_t id_of(const ts_segmentation &s, mesh::Index group);
mesh::Index group_of(const ts_segmentation *s, uint32_t id);  // of a tooth that stands separated; throws not_found
const tooth::Tooth &find_tooth(const ts_segmentation *s, uint32_t id);

// What the command makes of the session. `outcomes`: of each click of a batch, nullptr where there are none. Clicks
// that came to nothing are taken out of the command.
tooth::Session execute(const Prepared &prepared, const tooth::Session &session, Command &command,
                       const Progress &progress, Vec<tooth::Segmenter::Outcome> *outcomes = nullptr);

// The numbers that assign_numbers or set_number gives.
tooth::Numbers numbers_after(const Prepared &prepared, const tooth::Session &session, const Command &command);

// Puts it in the place of the present one, remembers how it came and tells the listener. Strong: where it throws,
// nothing has changed.
void commit(ts_segmentation &s, tooth::Session next, Command command);
void tell(ts_segmentation &s);              // the listener, of `changes`
void need_quiet(const ts_segmentation &s);  // throws invalid_argument while the listener is being called
void change(ts_segmentation &s, Command command, const Progress &progress = {});  // both, with the context's allocator

// Edits of cuts that `before` had are made again where the tooth was cut anew; those that cannot be are told in the
// log.
void edit_again(const Prepared &prepared, const tooth::Session &before, tooth::Session &next);
// The tooth of an edit command, edited.
void edit(const Prepared &prepared, tooth::Session &next, const Command &command, const Progress &progress);

}  // namespace ts::api
