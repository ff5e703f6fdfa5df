// Of toothseg.hpp: exceptions, context and job. SPDX-License-Identifier: Apache-2.0
#ifndef TOOTHSEG_BASE_HPP
#define TOOTHSEG_BASE_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "../toothseg.h"

namespace toothseg {

using Index = std::uint32_t;
using Point = std::array<double, 3>;
using Triangle = std::array<Index, 3>;

inline const char *version() noexcept {
  return ts_version();
}

class Exception : public std::runtime_error {
 public:
  Exception(ts_status status, const std::string &what) : std::runtime_error(what), status_(status) {}
  ts_status status() const noexcept { return status_; }
  const char *name() const noexcept { return ts_status_name(status_); }  // "TS_E_NO_TEETH"

 private:
  ts_status status_;
};

namespace detail {

inline void check(ts_status status) {
  if (status != TS_OK) throw Exception(status, ts_last_error_message());
}

inline std::uint32_t count32(std::size_t n) {
  if (n > std::numeric_limits<std::uint32_t>::max())
    throw Exception(TS_E_INVALID_ARGUMENT, "more than 2^32 - 1 elements");
  return static_cast<std::uint32_t>(n);
}

template <auto destroy>
struct Destroy {
  template <class Handle>
  void operator()(Handle *handle) const noexcept {
    destroy(handle);
  }
};
template <class Handle, auto destroy>
using Owner = std::unique_ptr<Handle, Destroy<destroy>>;

// The options or the result of a struct that begins with struct_size.
template <class Struct, class Init>
Struct initialised(Init init) {
  Struct s{};
  check(init(&s, static_cast<std::uint32_t>(sizeof(Struct))));
  return s;
}
template <class Struct, class Get>
Struct info(Get get) {
  Struct s{};
  s.struct_size = static_cast<std::uint32_t>(sizeof(Struct));
  check(get(&s));
  return s;
}

// The two calls of a getter: for the size, for the elements. get(T *, capacity, count).
template <class T, class Container = std::vector<T>, class Get>
Container elements(Get get) {
  std::uint32_t n = 0;
  check(get(static_cast<T *>(nullptr), 0u, &n));
  Container out(n, T{});
  if (n != 0) check(get(out.data(), n, &n));
  return out;
}

// The same where three doubles, or three indices, make an element.
static_assert(sizeof(Point) == 3 * sizeof(double), "points are packed");
template <class Get>
std::vector<Point> points(Get get) {
  return elements<Point>([&](Point *p, std::uint32_t capacity, std::uint32_t *count) {
    return get(p ? p->data() : nullptr, capacity, count);
  });
}
static_assert(sizeof(Triangle) == 3 * sizeof(Index), "triangles are packed");
template <class Get>
std::vector<Triangle> triangles(Get get) {
  return elements<Triangle>([&](Triangle *t, std::uint32_t capacity, std::uint32_t *count) {
    return get(t ? t->data() : nullptr, capacity, count);
  });
}

}  // namespace detail

inline ts_context_options context_options() {
  return detail::initialised<ts_context_options>(ts_context_options_init);
}

// ------------------------------------------------------------------------------------------------------------- context

// The hooks in the options, and what their user pointers point to, must outlive every object made from the context, not
// only the Context itself.
class Context {
 public:
  explicit Context(const ts_context_options &options = context_options()) {
    ts_context *handle = nullptr;
    detail::check(ts_context_create(&options, &handle));
    handle_.reset(handle);
  }

  ts_context *get() const noexcept { return handle_.get(); }

 private:
  detail::Owner<ts_context, ts_context_destroy> handle_;
};

// ----------------------------------------------------------------------------------------------------------------- job

class Job {
 public:
  // Called during a long call, from a thread that works for it. True: go on; false: cancel.
  using Callback = std::function<bool(double fraction, const char *stage)>;

  explicit Job(const Context &context, Callback callback = {}) : state_(std::make_unique<State>()) {
    const bool calls_back = static_cast<bool>(callback);
    state_->callback = std::move(callback);
    ts_job *handle = nullptr;
    detail::check(ts_job_create(context.get(), calls_back ? &proceed : nullptr, state_.get(), &handle));
    handle_.reset(handle);
  }

  void cancel() noexcept { ts_job_cancel(handle_.get()); }  // from any thread
  void reset() noexcept { ts_job_reset(handle_.get()); }
  double progress() const noexcept { return ts_job_progress(handle_.get()); }
  ts_job *get() const noexcept { return handle_.get(); }

  // Throws what the callback threw, else what the status says.
  void check(ts_status status) {
    if (std::exception_ptr thrown = std::exchange(state_->thrown, nullptr)) std::rethrow_exception(thrown);
    detail::check(status);
  }

 private:
  struct State {
    Callback callback;
    std::exception_ptr thrown;
  };

  static int proceed(double fraction, const char *stage, void *user) noexcept {
    State &state = *static_cast<State *>(user);
    try {
      return state.callback(fraction, stage) ? 0 : 1;
    } catch (...) {
      state.thrown = std::current_exception();
      return 1;
    }
  }

  std::unique_ptr<State> state_;  // at an address of its own, which the handle knows; outlives it
  detail::Owner<ts_job, ts_job_destroy> handle_;
};

namespace detail {
inline ts_job *handle(Job *job) noexcept {
  return job ? job->get() : nullptr;
}
inline void check(ts_status status, Job *job) {
  job ? job->check(status) : check(status);
}

// What a function of the library makes, owned before its status is looked at: a callback may throw at the very end.
template <class Owner, class Make>
Owner made(Make make, Job *job = nullptr) {
  typename Owner::pointer handle = nullptr;
  const ts_status status = make(&handle);
  Owner owner(handle);
  check(status, job);
  return owner;
}
}  // namespace detail

}  // namespace toothseg

#endif  // TOOTHSEG_BASE_HPP
