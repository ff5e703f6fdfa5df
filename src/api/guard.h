// The border: nothing but a status leaves, and what went wrong is kept for ts_last_error_message.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <exception>
#include <initializer_list>
#include <new>
#include <span>
#include <string>

#include "base/error.h"
#include "mesh/surface.h"
#include "toothseg.h"

namespace ts::api {

ts_status status_of(Fault fault) noexcept;
void keep_message(const char *function, const char *what) noexcept;

// Runs `body`; every exception becomes a status and a message that begins with the function's name.
template <class Body>
ts_status guarded(const char *function, Body &&body) noexcept {
  try {
    body();
    return TS_OK;
  } catch (const Error &e) {
    keep_message(function, e.what());
    return status_of(e.fault());
  } catch (const std::bad_alloc &) {
    keep_message(function, "out of memory");
    return TS_E_OUT_OF_MEMORY;
  } catch (const std::exception &e) {
    keep_message(function, e.what());
    return TS_E_INTERNAL;
  } catch (...) {
    keep_message(function, "unknown exception");
    return TS_E_INTERNAL;
  }
}

inline void need(const void *pointer, const char *name) {
  if (!pointer) throw Error(Fault::null, std::string(name) + " is NULL");
}

// Three coordinates of the caller's.
inline mesh::Vec3 point_of(const double *p, const char *name) {
  need(p, name);
  for (int k = 0; k < 3; ++k)
    if (!std::isfinite(p[k])) throw Error(Fault::invalid_argument, std::string(name) + " is not finite");
  return {p[0], p[1], p[2]};
}

// The number of an enumeration that comes from the caller: in C it may be any, of which C++ may not load every one as
// an E.
template <class E>
uint32_t caller_number(const E &value) {
  return std::bit_cast<uint32_t>(value);
}

// For enumerations whose values are 0 to `last`.
template <class E>
void need_value(const E &value, E last, const char *name) {
  if (caller_number(value) > caller_number(last))
    throw Error(Fault::invalid_argument, std::string(name) + " is " + std::to_string(caller_number(value)));
}

// The sizes that a public struct has had, oldest first; the last is today's. A struct that grows adds a line here.
template <class T>
struct Released {
  static constexpr uint32_t sizes[] = {sizeof(T)};
};

template <>
struct Released<ts_features_info> {
  static constexpr uint32_t sizes[] = {16, sizeof(ts_features_info)};  // without the warnings
};

template <>
struct Released<ts_segment_options> {
  static constexpr uint32_t sizes[] = {offsetof(ts_segment_options, memory_limit), sizeof(ts_segment_options)};
};

template <class T>
void check_size(uint32_t struct_size, const char *name) {
  if (std::ranges::find(Released<T>::sizes, struct_size) == std::end(Released<T>::sizes))
    throw Error(Fault::struct_size, std::string(name) + " has struct_size " + std::to_string(struct_size) +
                                        ", this library knows " + std::to_string(sizeof(T)) +
                                        "; call its init function with sizeof");
}

// The caller's options over the defaults: an older, shorter struct leaves the newer fields as `defaults` has them.
template <class T>
T read_options(const T *given, T defaults, const char *name) {
  if (!given) return defaults;
  check_size<T>(given->struct_size, name);
  std::memcpy(&defaults, given, given->struct_size);
  return defaults;
}

// Fills as much of the caller's struct as the caller knows.
template <class T>
void write_struct(T *out, T value, uint32_t struct_size, const char *name) {
  check_size<T>(struct_size, name);
  value.struct_size = struct_size;
  std::memcpy(static_cast<void *>(out), &value, struct_size);
}

// The two-call idiom: buffer NULL asks for the count only. `count` and `buffer` are touched on success only.
template <class T, class Range, class Convert>
void copy_out(const Range &items, std::size_t per_item, T *buffer, uint32_t capacity, uint32_t *count,
              Convert &&write) {
  const std::size_t n = std::size(items);
  if (!buffer && !count) throw Error(Fault::null, "buffer and count are both NULL");
  if (buffer && capacity < n)
    throw Error(Fault::buffer_too_small,
                "capacity " + std::to_string(capacity) + " is less than the " + std::to_string(n) + " elements");
  if (buffer) {
    std::size_t i = 0;
    for (const auto &item : items) write(item, buffer + per_item * i++);
  }
  if (count) *count = static_cast<uint32_t>(n);
}

template <class T, class Range>
void copy_out(const Range &items, T *buffer, uint32_t capacity, uint32_t *count) {
  copy_out(items, 1, buffer, capacity, count, [](const auto &item, T *to) { *to = static_cast<T>(item); });
}

}  // namespace ts::api
