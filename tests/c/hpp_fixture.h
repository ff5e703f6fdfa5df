// What the tests of the C++ layer share. SPDX-License-Identifier: Apache-2.0
#ifndef HPP_FIXTURE_H
#define HPP_FIXTURE_H

#include <cstring>
#include <optional>
#include <toothseg.hpp>

extern "C" {
#include "fixture.h"
#include "harness.h"
}

struct ArchMesh {
  std::vector<double> xyz;
  std::vector<toothseg::Index> triangles;
};

inline ArchMesh arch_mesh(std::uint32_t triangles) {
  mesh m = make_arch(triangles);
  ArchMesh out{{m.xyz, m.xyz + 3 * std::size_t{m.vertices}}, {m.triangles, m.triangles + 3 * std::size_t{m.faces}}};
  free_mesh(&m);
  return out;
}

template <class Call>
std::optional<ts_status> status_thrown(Call call) {
  try {
    call();
  } catch (const toothseg::Exception &e) {
    CHECK(std::strlen(e.what()) > 0);
    return e.status();
  }
  return std::nullopt;
}

inline const toothseg::Point far_away{1000, 0, 0};

#endif
