// An array over a whole surface of which few elements are ever set: it is cleared by what was touched, so that work on
// a part costs what the part costs.
#pragma once

#include "base/memory.h"

namespace ts {

template <class T, class Index = std::uint32_t>
class SparseArray {
 public:
  SparseArray() = default;
  SparseArray(std::size_t n, T clean) : value_(n, clean), clean_(clean) {}

  std::size_t size() const { return value_.size(); }
  const T &operator[](std::size_t i) const { return value_[i]; }

  void set(Index i, T value) {
    if (value_[i] == clean_) touched_.push_back(i);  // before the value: a failure leaves nothing that is not listed
    value_[i] = value;
  }
  // Whatever was set since the last clear, in the order of its first setting; elements set back to the clean value and
  // set again are there twice.
  const Vec<Index> &touched() const { return touched_; }

  void clear() noexcept {
    for (const Index i : touched_) value_[i] = clean_;
    touched_.clear();
  }

 private:
  Vec<T> value_;
  Vec<Index> touched_;
  T clean_{};
};

}  // namespace ts
