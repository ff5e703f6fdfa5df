// A synthetic arch as arrays. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <toothseg_arch.h>

#include <cstdint>
#include <vector>

#include "check.h"

struct Mesh {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
};

inline Mesh arch_mesh(const tsa_options &options) {
  tsa_arch *arch = nullptr;
  HOLDS(tsa_create(&options, &arch) == TSA_OK);
  Mesh m;
  m.xyz = check::all<double>([&](double *p, std::uint32_t n,
                                 std::uint32_t *c) { return static_cast<ts_status>(tsa_get_positions(arch, p, n, c)); },
                             3);
  m.triangles = check::all<std::uint32_t>(
      [&](std::uint32_t *p, std::uint32_t n, std::uint32_t *c) {
        return static_cast<ts_status>(tsa_get_triangles(arch, p, n, c));
      },
      3);
  tsa_destroy(arch);
  return m;
}

inline Mesh arch_mesh(std::uint32_t triangles, std::uint64_t seed) {
  tsa_options o;
  HOLDS(tsa_options_init(&o, sizeof o) == TSA_OK);
  o.triangles = triangles, o.seed = seed;
  return arch_mesh(o);
}
