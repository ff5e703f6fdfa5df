#include "mesh/check.h"

#include <algorithm>
#include <limits>
#include <mutex>

#include "base/error.h"
#include "base/shown.h"
#include "mesh/file_size.h"

namespace ts::mesh {
namespace {

constexpr std::size_t kCheckGrain = 1 << 15;
constexpr double furthest = 1e9;                              // mm
constexpr double least_diagonal = 9, largest_diagonal = 400;  // mm: an incisor's crown; a tray with both plaster bases

std::string vertex_text(std::size_t v, const Vec3 &p) {
  return "vertex " + std::to_string(v) + " " + shown(p);
}

// The first i in [0, n) for which bad(i), n if none: the same for any number of threads.
std::size_t first_bad(std::size_t n, const Executor &executor, const auto &bad) {
  std::size_t first = n;
  std::mutex guard;
  executor.ranges(n, kCheckGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (bad(i)) {
        const std::lock_guard lock(guard);
        first = std::min(first, i);
        return;
      }
  });
  return first;
}

double in_millimetres(Unit unit) {
  switch (unit) {
    case Unit::checked_mm:
    case Unit::mm: return 1;
    case Unit::cm: return 10;
    case Unit::m: return 1000;
    case Unit::inch: return 25.4;
  }
  throw Error(Fault::invalid_argument, "unit " + std::to_string(static_cast<int>(unit)) + " is not one");
}

void check_size(const RawMesh &raw, const Executor &executor) {
  const double inf = std::numeric_limits<double>::infinity();
  Vec3 low(inf, inf, inf), high = -low;
  std::mutex guard;
  executor.ranges(raw.corner.size(), kCheckGrain, [&](std::size_t begin, std::size_t end) {
    Vec3 least(inf, inf, inf), most = -least;
    for (std::size_t c = begin; c < end; ++c) {
      const Vec3 &p = raw.position[raw.corner[c]];
      least = least.cwiseMin(p), most = most.cwiseMax(p);
    }
    const std::lock_guard lock(guard);
    low = low.cwiseMin(least), high = high.cwiseMax(most);
  });
  const double diagonal = (high - low).norm();
  const auto fits = [&](double scale) {
    return scale * diagonal >= least_diagonal && scale * diagonal <= largest_diagonal;
  };
  if (raw.corner.empty() || fits(1)) return;
  std::string guess;
  const std::pair<Unit, const char *> units[] = {{Unit::cm, "cm"}, {Unit::m, "m"}, {Unit::inch, "inch"}};
  for (const auto &[unit, name] : units)
    if (fits(in_millimetres(unit)))
      guess += (guess.empty() ? "; it would be plausible in " : " or ") + std::string(name) + " (" +
               shown(in_millimetres(unit) * diagonal) + " mm)";
  throw Error(Fault::mesh_units, "the bounding box has a diagonal of " + shown(diagonal) +
                                     ", but a scan in mm has 9 to 400" +
                                     (guess.empty() ? "; no unit known here makes it plausible" : guess));
}

}  // namespace

void check_elements(const RawMesh &raw, const Executor &executor) {
  const std::size_t vertices = raw.position.size(), faces = raw.faces();
  // A face of n corners becomes n - 2 triangles, so the corners bound the faces of the model.
  if (vertices > most_elements || faces > most_elements || raw.corner.size() > 3 * most_elements)
    throw Error(Fault::mesh_too_large,
                std::to_string(vertices) + " vertices and " + std::to_string(faces) + " faces: at most 2^30 of either");
  if (faces == 0) throw Error(Fault::mesh_empty, "the mesh has no face");
  const std::size_t v = first_bad(vertices, executor, [&](std::size_t i) { return !raw.position[i].allFinite(); });
  if (v < vertices) throw Error(Fault::mesh_non_finite, vertex_text(v, raw.position[v]) + " is not finite");
  const std::size_t c =
      first_bad(raw.corner.size(), executor, [&](std::size_t i) { return raw.corner[i] >= vertices; });
  if (c == raw.corner.size()) return;
  std::size_t f = c / 3;
  if (!raw.face_start.empty())
    f = static_cast<std::size_t>(std::upper_bound(raw.face_start.begin(), raw.face_start.end(), c) -
                                 raw.face_start.begin()) -
        1;
  throw Error(Fault::mesh_index_range, "face " + std::to_string(f) + " names vertex " + std::to_string(raw.corner[c]) +
                                           ", but there are only " + std::to_string(vertices));
}

void to_millimetres(RawMesh &raw, Unit unit, const Executor &executor) {
  const double scale = in_millimetres(unit);
  const std::size_t v = first_bad(raw.position.size(), executor, [&](std::size_t i) {
    return !(raw.position[i].cwiseAbs().maxCoeff() <= furthest / scale);
  });
  if (v < raw.position.size())
    throw Error(Fault::mesh_too_large, vertex_text(v, raw.position[v]) + " lies beyond 1e9 mm");
  if (scale != 1)
    for (Vec3 &p : raw.position) p *= scale;
  if (unit == Unit::checked_mm) check_size(raw, executor);
}

}  // namespace ts::mesh
