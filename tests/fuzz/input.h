// The fuzzer's bytes as numbers. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

class Input {
 public:
  Input(const std::uint8_t *data, std::size_t size) : data_(data), left_(size) {}

  bool empty() const { return left_ == 0; }
  std::size_t left() const { return left_; }
  const std::uint8_t *rest() const { return data_; }

  // 0 where there is nothing left.
  std::uint8_t byte() {
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
  }
  std::uint32_t below(std::uint32_t n) { return n == 0 ? 0 : (byte() | std::uint32_t{byte()} << 8) % n; }
  // In [0, 1].
  double share() { return (byte() | byte() << 8) / 65535.0; }
  // Any double, or a plain one.
  double any() {
    std::uint64_t bits = 0;
    for (int k = 0; k < 8; ++k) bits = bits << 8 | byte();
    double value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

 private:
  const std::uint8_t *data_;
  std::size_t left_;
};
