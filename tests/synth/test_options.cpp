// SPDX-License-Identifier: Apache-2.0
#include <cstring>
#include <limits>

#include "arch_mesh.h"

TEST_CASE("options out of range are refused, with a reason, and leave the output alone") {
  tsa_arch *const untouched = reinterpret_cast<tsa_arch *>(0x10);
  const auto refused = [&](int status, auto change) {
    tsa_options o = archOptions(TSA_JAW_UPPER, 10000);
    change(o);
    tsa_arch *arch = untouched;
    CHECK(tsa_create(&o, &arch) == status);
    CHECK(arch == untouched);
    CHECK(std::strlen(tsa_last_error_message()) > 0);
  };
  const uint32_t lower[] = {36}, wisdom[] = {18}, twice[] = {16, 16};
  refused(TSA_E_STRUCT_SIZE, [](tsa_options &o) { o.struct_size = 0; });
  refused(TSA_E_STRUCT_SIZE, [](tsa_options &o) { o.struct_size += 8; });
  refused(TSA_E_INVALID_ARGUMENT, [](tsa_options &o) { o.jaw = 0; });
  refused(TSA_E_INVALID_ARGUMENT, [](tsa_options &o) { o.triangles = 4999; });
  refused(TSA_E_INVALID_ARGUMENT, [](tsa_options &o) { o.triangles = 4000001; });
  refused(TSA_E_INVALID_ARGUMENT, [](tsa_options &o) { o.crowding = 1.01; });
  refused(TSA_E_INVALID_ARGUMENT, [](tsa_options &o) { o.crowding = std::numeric_limits<double>::quiet_NaN(); });
  refused(TSA_E_INVALID_ARGUMENT, [](tsa_options &o) { o.noise = -0.1; });
  refused(TSA_E_INVALID_ARGUMENT, [](tsa_options &o) { o.noise_kind = 2; });
  refused(TSA_E_INVALID_ARGUMENT, [](tsa_options &o) { o.base = 2; });
  refused(TSA_E_NULL, [](tsa_options &o) { o.missing_count = 1; });
  refused(TSA_E_INVALID_ARGUMENT, [&](tsa_options &o) { o.missing = lower, o.missing_count = 1; });
  refused(TSA_E_INVALID_ARGUMENT, [&](tsa_options &o) { o.missing = wisdom, o.missing_count = 1; });
  refused(TSA_E_INVALID_ARGUMENT, [&](tsa_options &o) { o.missing = twice, o.missing_count = 2; });
  refused(TSA_E_INVALID_ARGUMENT, [&](tsa_options &o) { o.missing = lower, o.missing_count = 14; });
}

TEST_CASE("null pointers are refused") {
  tsa_options o = archOptions(TSA_JAW_UPPER, 5000);
  CHECK(tsa_options_init(nullptr, sizeof o) == TSA_E_NULL);
  CHECK(tsa_options_init(&o, 3) == TSA_E_STRUCT_SIZE);
  CHECK(tsa_create(&o, nullptr) == TSA_E_NULL);
  uint32_t n = 7;
  CHECK(tsa_get_labels(nullptr, nullptr, 0, &n) == TSA_E_NULL);
  CHECK(n == 7);
  tsa_destroy(nullptr);
}

TEST_CASE("getters count first, fill what fits, refuse what does not") {
  const tsa_options o = archOptions(TSA_JAW_LOWER, 5000);
  tsa_arch *arch = nullptr;
  REQUIRE(tsa_create(&o, &arch) == TSA_OK);
  uint32_t n = 0, m = 0;
  REQUIRE(tsa_get_positions(arch, nullptr, 0, &n) == TSA_OK);
  std::vector<double> wide(3 * size_t{n});
  std::vector<float> narrow(3 * size_t{n});
  CHECK(tsa_get_positions(arch, wide.data(), n - 1, &m) == TSA_E_BUFFER_TOO_SMALL);
  CHECK(m == 0);
  CHECK(tsa_get_positions(arch, nullptr, 1, &m) == TSA_E_NULL);
  CHECK(tsa_get_positions(arch, wide.data(), n, nullptr) == TSA_E_NULL);
  REQUIRE(tsa_get_positions(arch, wide.data(), n, &m) == TSA_OK);
  REQUIRE(tsa_get_positions_f32(arch, narrow.data(), n, &m) == TSA_OK);
  CHECK(m == n);
  bool same = true;
  for (size_t i = 0; i < wide.size(); ++i) same = same && narrow[i] == static_cast<float>(wide[i]);
  CHECK(same);
  tsa_destroy(arch);
}
