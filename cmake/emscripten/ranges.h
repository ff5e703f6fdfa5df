// The algorithms of C++20 on ranges that src/ uses and the libc++ 13 of Emscripten 3.1 has not: included before each of
// the library's files by CMakeLists.txt, so that these are written for C++20 alone. Goes with that libc++.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <ranges>

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 15000

// NOLINTBEGIN(cert-dcl58-cpp): the names are those that the standard gives
namespace std::ranges {
namespace ts_missing {

// A comparison of what `projection` makes of two elements.
template <class Compare, class Projection>
auto by(Compare &compare, Projection &projection) {
  return [&](auto &&a, auto &&b) -> bool {
    return std::invoke(compare, std::invoke(projection, a), std::invoke(projection, b));
  };
}
// A condition on what `projection` makes of an element.
template <class Condition, class Projection>
auto on(Condition &condition, Projection &projection) {
  return [&](auto &&x) -> bool { return std::invoke(condition, std::invoke(projection, x)); };
}

struct Sort {
  template <class R, class C = less, class P = identity>
  void operator()(R &&r, C c = {}, P p = {}) const {
    std::sort(ranges::begin(r), ranges::end(r), by(c, p));
  }
};
struct StableSort {
  template <class R, class C = less, class P = identity>
  void operator()(R &&r, C c = {}, P p = {}) const {
    std::stable_sort(ranges::begin(r), ranges::end(r), by(c, p));
  }
};
struct Reverse {
  template <class R>
  void operator()(R &&r) const {
    std::reverse(ranges::begin(r), ranges::end(r));
  }
};
struct Fill {
  template <class R, class T>
  void operator()(R &&r, const T &value) const {
    std::fill(ranges::begin(r), ranges::end(r), value);
  }
};
struct Move {
  template <class R, class Out>
  void operator()(R &&r, Out out) const {
    std::move(ranges::begin(r), ranges::end(r), out);
  }
};
struct Transform {
  template <class R, class Out, class F>
  void operator()(R &&r, Out out, F f) const {
    for (auto &&x : r) *out++ = std::invoke(f, x);
  }
};

struct FindIf {
  template <class R, class F, class P = identity>
  auto operator()(R &&r, F f, P p = {}) const {
    return std::find_if(ranges::begin(r), ranges::end(r), on(f, p));
  }
};
struct Find {
  template <class R, class T, class P = identity>
  auto operator()(R &&r, const T &value, P p = {}) const {
    return std::find_if(ranges::begin(r), ranges::end(r), [&](auto &&x) { return std::invoke(p, x) == value; });
  }
};
struct AdjacentFind {
  template <class R>
  auto operator()(R &&r) const {
    return std::adjacent_find(ranges::begin(r), ranges::end(r));
  }
};
struct Count {
  template <class R, class T>
  auto operator()(R &&r, const T &value) const {
    return std::count(ranges::begin(r), ranges::end(r), value);
  }
};
struct CountIf {
  template <class R, class F, class P = identity>
  auto operator()(R &&r, F f, P p = {}) const {
    return std::count_if(ranges::begin(r), ranges::end(r), on(f, p));
  }
};
struct AllOf {
  template <class R, class F, class P = identity>
  bool operator()(R &&r, F f, P p = {}) const {
    return std::all_of(ranges::begin(r), ranges::end(r), on(f, p));
  }
};
struct AnyOf {
  template <class R, class F, class P = identity>
  bool operator()(R &&r, F f, P p = {}) const {
    return std::any_of(ranges::begin(r), ranges::end(r), on(f, p));
  }
};
struct NoneOf {
  template <class R, class F, class P = identity>
  bool operator()(R &&r, F f, P p = {}) const {
    return std::none_of(ranges::begin(r), ranges::end(r), on(f, p));
  }
};

struct LowerBound {
  template <class R, class T, class C = less, class P = identity>
  auto operator()(R &&r, const T &value, C c = {}, P p = {}) const {
    return std::lower_bound(ranges::begin(r), ranges::end(r), value,
                            [&](auto &&x, auto &&v) -> bool { return std::invoke(c, std::invoke(p, x), v); });
  }
};
struct UpperBound {
  template <class R, class T, class C = less, class P = identity>
  auto operator()(R &&r, const T &value, C c = {}, P p = {}) const {
    return std::upper_bound(ranges::begin(r), ranges::end(r), value,
                            [&](auto &&v, auto &&x) -> bool { return std::invoke(c, v, std::invoke(p, x)); });
  }
};
struct BinarySearch {
  template <class R, class T>
  bool operator()(R &&r, const T &value) const {
    return std::binary_search(ranges::begin(r), ranges::end(r), value);
  }
};

struct MinElement {
  template <class R, class C = less, class P = identity>
  auto operator()(R &&r, C c = {}, P p = {}) const {
    return std::min_element(ranges::begin(r), ranges::end(r), by(c, p));
  }
};
struct MaxElement {
  template <class R, class C = less, class P = identity>
  auto operator()(R &&r, C c = {}, P p = {}) const {
    return std::max_element(ranges::begin(r), ranges::end(r), by(c, p));
  }
};
struct Min {
  template <class R, class C = less, class P = identity>
  range_value_t<R> operator()(R &&r, C c = {}, P p = {}) const {
    return *std::min_element(ranges::begin(r), ranges::end(r), by(c, p));
  }
};
struct Max {
  template <class R, class C = less, class P = identity>
  range_value_t<R> operator()(R &&r, C c = {}, P p = {}) const {
    return *std::max_element(ranges::begin(r), ranges::end(r), by(c, p));
  }
};
// Of equal ones the first is the least and the last the greatest.
struct Minmax {
  template <class T>
  struct Result {
    T min, max;
  };
  template <class R, class C = less, class P = identity>
  Result<range_value_t<R>> operator()(R &&r, C c = {}, P p = {}) const {
    const auto [least, most] = std::minmax_element(ranges::begin(r), ranges::end(r), by(c, p));
    return {*least, *most};
  }
};

}  // namespace ts_missing

inline constexpr ts_missing::Sort sort;
inline constexpr ts_missing::StableSort stable_sort;
inline constexpr ts_missing::Reverse reverse;
inline constexpr ts_missing::Fill fill;
inline constexpr ts_missing::Move move;
inline constexpr ts_missing::Transform transform;
inline constexpr ts_missing::FindIf find_if;
inline constexpr ts_missing::Find find;
inline constexpr ts_missing::AdjacentFind adjacent_find;
inline constexpr ts_missing::Count count;
inline constexpr ts_missing::CountIf count_if;
inline constexpr ts_missing::AllOf all_of;
inline constexpr ts_missing::AnyOf any_of;
inline constexpr ts_missing::NoneOf none_of;
inline constexpr ts_missing::LowerBound lower_bound;
inline constexpr ts_missing::UpperBound upper_bound;
inline constexpr ts_missing::BinarySearch binary_search;
inline constexpr ts_missing::MinElement min_element;
inline constexpr ts_missing::MaxElement max_element;
inline constexpr ts_missing::Min min;
inline constexpr ts_missing::Max max;
inline constexpr ts_missing::Minmax minmax;

}  // namespace std::ranges
// NOLINTEND(cert-dcl58-cpp)

#endif
