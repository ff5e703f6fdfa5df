// An array over a whole surface of which few elements are ever set: it is cleared by what was touched, so that work on
// a part costs what the part costs.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>

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

  // The elements that are not clean, ascending: by looking through all between the first and the last, which for small
  // elements is quicker than sorting.
  Vec<Index> ascending() const {
    Vec<Index> found;
    if (touched_.empty()) return found;
    const auto [first, last] = std::ranges::minmax(touched_);
    Index i = first;
    if constexpr (sizeof(T) == 1)
      while (i <= last && last - i >= 8) {
        std::uint64_t eight, clean;
        std::memcpy(&eight, value_.data() + i, 8);
        std::memset(&clean, static_cast<unsigned char>(clean_), 8);
        if (eight != clean)
          for (Index k = i; k < i + 8; ++k)
            if (value_[k] != clean_) found.push_back(k);
        i += 8;
      }
    for (; i <= last; ++i)
      if (value_[i] != clean_) found.push_back(i);
    return found;
  }

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
