// Work space that is used again: made when all there is is in use, given back when a lease ends.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace ts {

// T has a member clear() noexcept, which makes it as good as new. Safe for concurrent use.
template <class T>
class Pool {
 public:
  class Lease {
   public:
    Lease(Pool &pool, std::unique_ptr<T> item) : pool_(&pool), item_(std::move(item)) {}
    Lease(Lease &&) noexcept = default;
    Lease &operator=(Lease &&) = delete;
    ~Lease() {
      if (!item_) return;
      item_->clear();
      pool_->put(std::move(item_));
    }
    T &operator*() const { return *item_; }
    T *operator->() const { return item_.get(); }

   private:
    Pool *pool_;
    std::unique_ptr<T> item_;
  };

  // make() returns a unique_ptr to a new item.
  template <class Make>
  Lease take(const Make &make) {
    {
      const std::lock_guard lock(guard_);
      if (!idle_.empty()) {
        std::unique_ptr<T> item = std::move(idle_.back());
        idle_.pop_back();
        return Lease(*this, std::move(item));
      }
    }
    return Lease(*this, make());
  }

 private:
  void put(std::unique_ptr<T> item) noexcept {
    const std::lock_guard lock(guard_);
    try {
      idle_.push_back(std::move(item));
    } catch (...) {  // no memory for the list: the item goes
    }
  }

  std::mutex guard_;
  std::vector<std::unique_ptr<T>> idle_;
};

}  // namespace ts
