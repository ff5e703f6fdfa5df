// std::bit_cast, which libc++ 13 has not; see ranges.h. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 14000

// NOLINTBEGIN(cert-dcl58-cpp): the name is that which the standard gives
namespace std {

template <class To, class From>
constexpr To bit_cast(const From &from) noexcept {
  return __builtin_bit_cast(To, from);
}

}  // namespace std
// NOLINTEND(cert-dcl58-cpp)

#endif
