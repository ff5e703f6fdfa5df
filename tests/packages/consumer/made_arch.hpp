// The arch that count_labels.c makes. SPDX-License-Identifier: Apache-2.0
#ifndef MADE_ARCH_HPP
#define MADE_ARCH_HPP
#include <toothseg_arch.h>

#include <cstdint>
#include <stdexcept>
#include <vector>

struct MadeArch {
  std::vector<double> positions;
  std::vector<std::uint32_t> triangles;

  MadeArch() {
    tsa_options options;
    need(tsa_options_init(&options, sizeof options));
    options.triangles = 6000;
    tsa_arch *arch = nullptr;
    need(tsa_create(&options, &arch));
    std::uint32_t vertices = 0, faces = 0;
    need(tsa_get_positions(arch, nullptr, 0, &vertices));
    need(tsa_get_triangles(arch, nullptr, 0, &faces));
    positions.resize(3 * std::size_t{vertices});
    triangles.resize(3 * std::size_t{faces});
    need(tsa_get_positions(arch, positions.data(), vertices, &vertices));
    need(tsa_get_triangles(arch, triangles.data(), faces, &faces));
    tsa_destroy(arch);
  }

 private:
  static void need(int status) {
    if (status != TSA_OK) throw std::runtime_error(tsa_last_error_message());
  }
};
#endif
