// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <new>
#include <stdexcept>
#include <string>

#include "generate.h"
#include "toothseg_arch.h"

struct tsa_arch {
  tsa::Arch arch;
};

namespace {

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): each thread's own
thread_local char lastMessage[200] = "";

int fail(int status, const std::string &message) noexcept {
  const size_t n = std::min(message.size(), sizeof lastMessage - 1);
  std::copy_n(message.data(), n, lastMessage);
  lastMessage[n] = 0;
  return status;
}

template <class Body>
int guarded(Body body) noexcept {
  try {
    return body();
  } catch (const std::bad_alloc &) {
    return fail(TSA_E_OUT_OF_MEMORY, "out of memory");
  } catch (const std::exception &e) {
    return fail(TSA_E_INTERNAL, e.what());
  } catch (...) {
    return fail(TSA_E_INTERNAL, "unknown fault");
  }
}

bool isOfJaw(uint32_t fdi, bool upper) {
  const uint32_t quadrant = fdi / 10, position = fdi % 10;
  return position >= 1 && position <= 7 && (upper ? quadrant == 1 || quadrant == 2 : quadrant == 3 || quadrant == 4);
}

int read(const tsa_options &o, tsa::Settings &s) {
  if (o.struct_size != sizeof(tsa_options)) return fail(TSA_E_STRUCT_SIZE, "struct_size: not that of tsa_options");
  if (o.jaw != TSA_JAW_UPPER && o.jaw != TSA_JAW_LOWER)
    return fail(TSA_E_INVALID_ARGUMENT, "jaw: neither upper nor lower");
  if (o.triangles < 5000 || o.triangles > 4000000)
    return fail(TSA_E_INVALID_ARGUMENT, "triangles: not in 5000 to 4000000");
  if (o.base > 1) return fail(TSA_E_INVALID_ARGUMENT, "base: neither 0 nor 1");
  if (!(o.crowding >= 0 && o.crowding <= 1)) return fail(TSA_E_INVALID_ARGUMENT, "crowding: not in 0 to 1");
  if (!(o.noise >= 0 && o.noise <= 1)) return fail(TSA_E_INVALID_ARGUMENT, "noise: not in 0 to 1");
  if (o.noise_kind > TSA_NOISE_ISOTROPIC)
    return fail(TSA_E_INVALID_ARGUMENT, "noise_kind: neither normal nor isotropic");
  if (o.missing_count > 0 && !o.missing) return fail(TSA_E_NULL, "missing: NULL");
  s.upper = o.jaw == TSA_JAW_UPPER;
  s.triangles = o.triangles;
  s.base = o.base == 1;
  s.seed = o.seed;
  s.crowding = o.crowding;
  s.noise = o.noise;
  s.isotropic = o.noise_kind == TSA_NOISE_ISOTROPIC;
  if (o.missing_count > 13) return fail(TSA_E_INVALID_ARGUMENT, "missing: more than 13 teeth");
  for (uint32_t i = 0; i < o.missing_count; ++i) {
    if (!isOfJaw(o.missing[i], s.upper))
      return fail(TSA_E_INVALID_ARGUMENT, "missing: no tooth " + std::to_string(o.missing[i]) + " in this jaw");
    if (std::find(s.missing.begin(), s.missing.end(), o.missing[i]) != s.missing.end())
      return fail(TSA_E_INVALID_ARGUMENT, "missing: tooth " + std::to_string(o.missing[i]) + " twice");
    s.missing.push_back(o.missing[i]);
  }
  return TSA_OK;
}

// `size` elements of `width` values each; write(i, target) puts element i.
template <class T, class Write>
int fill(const void *arch, T *buffer, uint32_t capacity, uint32_t *count, size_t size, uint32_t width, Write write) {
  if (!arch || !count) return fail(TSA_E_NULL, !arch ? "arch: NULL" : "count: NULL");
  if (!buffer && capacity > 0) return fail(TSA_E_NULL, "buffer: NULL with a capacity");
  if (buffer && capacity < size) return fail(TSA_E_BUFFER_TOO_SMALL, "capacity: " + std::to_string(size) + " needed");
  if (buffer)
    for (size_t i = 0; i < size; ++i) write(i, buffer + i * width);
  *count = static_cast<uint32_t>(size);
  return TSA_OK;
}

template <class T>
int fillPositions(const tsa_arch *arch, T *positions, uint32_t capacity, uint32_t *count) {
  return fill(arch, positions, capacity, count, arch ? arch->arch.mesh.points.size() : 0, 3, [&](size_t i, T *out) {
    const tsa::Vec3 p = arch->arch.mesh.points[i];
    out[0] = static_cast<T>(p.x), out[1] = static_cast<T>(p.y), out[2] = static_cast<T>(p.z);
  });
}

}  // namespace

extern "C" {

int tsa_options_init(tsa_options *options, uint32_t struct_size) {
  if (!options) return fail(TSA_E_NULL, "options: NULL");
  if (struct_size != sizeof(tsa_options)) return fail(TSA_E_STRUCT_SIZE, "struct_size: not that of tsa_options");
  *options = {};
  options->struct_size = struct_size;
  options->jaw = TSA_JAW_UPPER;
  options->triangles = 100000;
  options->seed = 1;
  return TSA_OK;
}

int tsa_create(const tsa_options *options, tsa_arch **out) {
  if (!out) return fail(TSA_E_NULL, "out: NULL");
  return guarded([&] {
    tsa::Settings settings;
    if (options)
      if (const int status = read(*options, settings); status != TSA_OK) return status;
    *out = new tsa_arch{tsa::generate(settings)};
    return static_cast<int>(TSA_OK);
  });
}

void tsa_destroy(tsa_arch *arch) {
  delete arch;
}

const char *tsa_last_error_message(void) {
  return lastMessage;
}

int tsa_get_positions(const tsa_arch *arch, double *positions, uint32_t capacity, uint32_t *count) {
  return fillPositions(arch, positions, capacity, count);
}

int tsa_get_positions_f32(const tsa_arch *arch, float *positions, uint32_t capacity, uint32_t *count) {
  return fillPositions(arch, positions, capacity, count);
}

int tsa_get_triangles(const tsa_arch *arch, uint32_t *triangles, uint32_t capacity, uint32_t *count) {
  return fill(arch, triangles, capacity, count, arch ? arch->arch.mesh.faces.size() : 0, 3,
              [&](size_t i, uint32_t *out) { std::copy_n(arch->arch.mesh.faces[i].data(), 3, out); });
}

int tsa_get_labels(const tsa_arch *arch, uint32_t *labels, uint32_t capacity, uint32_t *count) {
  return fill(arch, labels, capacity, count, arch ? arch->arch.labels.size() : 0, 1,
              [&](size_t i, uint32_t *out) { *out = arch->arch.labels[i]; });
}

int tsa_get_teeth(const tsa_arch *arch, uint32_t *fdi, uint32_t capacity, uint32_t *count) {
  return fill(arch, fdi, capacity, count, arch ? arch->arch.fdi.size() : 0, 1,
              [&](size_t i, uint32_t *out) { *out = arch->arch.fdi[i]; });
}

int tsa_get_features(const tsa_arch *arch, tsa_feature *features, uint32_t capacity, uint32_t *count) {
  return fill(arch, features, capacity, count, arch ? arch->arch.features.size() : 0, 1,
              [&](size_t i, tsa_feature *out) {
                const tsa::Feature &f = arch->arch.features[i];
                *out = {f.label, f.kind, {f.position.x, f.position.y, f.position.z}};
              });
}

}  // extern "C"
