// The C++ header compiles alone. SPDX-License-Identifier: Apache-2.0
#include <toothseg.hpp>

// Owners move and do not copy.
template <class T>
constexpr bool move_only = std::is_nothrow_move_constructible_v<T> &&std::is_nothrow_move_assignable_v<T> &&
                           !std::is_copy_constructible_v<T> && !std::is_copy_assignable_v<T>;
static_assert(move_only<toothseg::Context> && move_only<toothseg::Job> && move_only<toothseg::Model> &&
              move_only<toothseg::Features> && move_only<toothseg::Segmentation> && move_only<toothseg::Mesh> &&
              move_only<toothseg::Session>);
