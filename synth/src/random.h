// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "vec3.h"

namespace tsa {

// SplitMix64: the standard library's distributions differ between implementations, the arch must not.
inline uint64_t mix(uint64_t z) {
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

class Random {
 public:
  explicit Random(uint64_t seed) : state_(mix(seed)) {}
  uint64_t next() {
    state_ += 0x9e3779b97f4a7c15u;
    return mix(state_);
  }
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double symmetric() { return 2 * uniform() - 1; }
  double gaussian() {
    const double r = std::sqrt(-2 * std::log(1 - uniform()));
    return r * std::cos(6.283185307179586 * uniform());
  }

 private:
  uint64_t state_;
};

// Value noise in [-1, 1] with unit cells, C1.
inline double smoothNoise(Vec3 p, uint32_t seed) {
  const double fx = std::floor(p.x), fy = std::floor(p.y), fz = std::floor(p.z);
  const auto ix = static_cast<uint32_t>(static_cast<int32_t>(fx)), iy = static_cast<uint32_t>(static_cast<int32_t>(fy)),
             iz = static_cast<uint32_t>(static_cast<int32_t>(fz));
  const auto corner = [&](uint32_t dx, uint32_t dy, uint32_t dz) {
    uint32_t h = (ix + dx) * 0x8da6b343u ^ (iy + dy) * 0xd8163841u ^ (iz + dz) * 0xcb1ab31fu ^ seed;
    h = (h ^ (h >> 16)) * 0x7feb352du;
    h = (h ^ (h >> 15)) * 0x846ca68bu;
    return static_cast<double>(h >> 8) * (2.0 / 16777216.0) - 1;
  };
  const auto fade = [](double t) { return t * t * (3 - 2 * t); };
  const double x = fade(p.x - fx), y = fade(p.y - fy), z = fade(p.z - fz);
  const auto row = [&](uint32_t dy, uint32_t dz) {
    const double a = corner(0, dy, dz);
    return a + x * (corner(1, dy, dz) - a);
  };
  const double a = row(0, 0), b = row(1, 0), c = row(0, 1), d = row(1, 1);
  const double low = a + y * (b - a), high = c + y * (d - c);
  return low + z * (high - low);
}

}  // namespace tsa
