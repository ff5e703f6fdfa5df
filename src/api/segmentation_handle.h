#pragma once

#include "api/features_handle.h"
#include "tooth/session.h"

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

 private:
  mutable std::mutex guard_;
  mutable Vec<std::optional<tooth::ClickDetails>> known_;
};

}  // namespace ts::api

struct ts_segmentation {
  std::unique_ptr<const ts::api::Prepared> prepared;
  ts::tooth::Session session;
  ts::api::ViewCache views;
  ts::api::DetailsCache details;
};

namespace ts::api {

// By its id for the caller; throws not_found.
const tooth::Tooth &find_tooth(const ts_segmentation *segmentation, uint32_t id);

}  // namespace ts::api
