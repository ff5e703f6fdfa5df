#include "mesh/clean.h"

#include <algorithm>
#include <limits>

#include "base/stop.h"
#include "mesh/rows.h"
#include "mesh/triangulate.h"

namespace ts::mesh {
namespace {

// Three distinct corners and an area: a height of more than 1e-12 of the longest side, which is what rounding leaves.
bool is_proper(std::span<const Vec3> position, const Triangle &t) {
  const auto [a, b, c] = t;
  if (a == b || b == c || c == a) return false;
  const Vec3 u = position[b] - position[a], v = position[c] - position[a], w = position[c] - position[b];
  const double longest = std::max({u.squaredNorm(), v.squaredNorm(), w.squaredNorm()});
  return u.cross(v).norm() > 1e-12 * longest;
}

constexpr std::size_t kCleanGrain = 1 << 14;

// Faces that are triangles as they are: what is to go is marked by a corner that is none, and then left out.
void take_triangles(const RawMesh &raw, std::span<const Index> kept, CleanFaces &clean, const Executor &executor) {
  clean.triangle.resize(raw.faces());
  clean.source.resize(raw.faces());
  executor.ranges(raw.faces(), kCleanGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const std::span<const Index> corners = raw.face(f);
      const Triangle t{kept[corners[0]], kept[corners[1]], kept[corners[2]]};
      clean.triangle[f] = is_proper(raw.position, t) ? t : Triangle{none, none, none};
      clean.source[f] = static_cast<Index>(f);
    }
  });
  std::size_t size = 0;
  for (std::size_t f = 0; f < raw.faces(); ++f) {
    if (clean.triangle[f][0] == none) continue;
    if (size != f) clean.triangle[size] = clean.triangle[f], clean.source[size] = clean.source[f];
    ++size;
  }
  clean.degenerate = static_cast<Index>(raw.faces() - size);
  clean.triangle.resize(size);
  clean.source.resize(size);
}

void cut_polygons(const RawMesh &raw, std::span<const Index> kept, CleanFaces &clean, Progress progress) {
  Triangulator triangulate;
  Vec<Index> polygon;
  Vec<Triangle> parts;
  clean.triangle.reserve(raw.faces());
  clean.source.reserve(raw.faces());
  for (Index f = 0; f < raw.faces(); ++f) {
    if (f % 65536 == 0) progress(static_cast<double>(f) / static_cast<double>(raw.faces()));
    const std::span<const Index> corners = raw.face(f);
    parts.clear();
    if (corners.size() == 3) {
      parts.push_back({kept[corners[0]], kept[corners[1]], kept[corners[2]]});
    } else if (corners.size() > 3) {
      ++clean.polygons;
      polygon.clear();
      for (const Index v : corners) polygon.push_back(kept[v]);
      if (!triangulate(raw.position, polygon, parts))
        throw Error(Fault::mesh_too_large, "face " + std::to_string(f) + " is concave and has " +
                                               std::to_string(corners.size()) + " corners: at most " +
                                               std::to_string(most_concave_corners) + " can be cut into triangles");
    }
    const std::size_t before = clean.triangle.size();
    for (const Triangle &t : parts) {
      if (!is_proper(raw.position, t)) continue;
      clean.triangle.push_back(t);
      clean.source.push_back(f);
    }
    clean.degenerate += clean.triangle.size() == before;
  }
}

struct Corners {
  Index middle, high, triangle;
  bool operator<(const Corners &o) const {
    return middle != o.middle ? middle < o.middle : high != o.high ? high < o.high : triangle < o.triangle;
  }
  bool are(const Corners &o) const { return middle == o.middle && high == o.high; }
};

// The upper corners of the triangles of which v is the lowest.
void gather(std::span<const Triangle> triangle, std::span<const Index> around, Index v, Vec<Corners> &corners) {
  corners.resize(around.size());
  std::size_t size = 0;
  for (const Index t : around) {
    const auto [a, b, c] = triangle[t];
    const Index low = std::min({a, b, c}), high = std::max({a, b, c});
    corners[size] = {a ^ b ^ c ^ low ^ high, high, t};
    size += low == v;
  }
  corners.resize(size);
}

bool any_duplicate(std::span<const Triangle> triangle, const Rows &around, const Executor &executor) {
  constexpr std::size_t few = 8;
  Vec<std::uint8_t> found((around.size() + kCleanGrain - 1) / kCleanGrain, 0);
  executor.ranges(around.size(), kCleanGrain, [&](std::size_t begin, std::size_t end) {
    Vec<Corners> corners;
    bool any = false;
    for (std::size_t v = begin; v < end; ++v) {
      gather(triangle, around[v], static_cast<Index>(v), corners);
      if (corners.size() > few) std::sort(corners.begin(), corners.end());
      for (std::size_t i = 1; i < corners.size(); ++i)
        for (std::size_t j = corners.size() > few ? i - 1 : 0; j < i; ++j) any |= corners[i].are(corners[j]);
    }
    found[begin / kCleanGrain] = any;
  });
  return std::find(found.begin(), found.end(), 1) != found.end();
}

// same[t]: the first triangle with the corners of t, whichever way round.
Vec<Index> find_duplicates(std::span<const Triangle> triangle, const Rows &around) {
  Vec<Index> same(triangle.size());
  Vec<Corners> corners;
  StopNowAndThen stop(1 << 14);
  for (std::size_t v = 0; v < around.size(); ++v) {
    stop();
    gather(triangle, around[v], static_cast<Index>(v), corners);
    std::sort(corners.begin(), corners.end());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const bool again = i > 0 && corners[i].are(corners[i - 1]);
      same[corners[i].triangle] = again ? same[corners[i - 1].triangle] : corners[i].triangle;
    }
  }
  return same;
}

void drop_duplicates(CleanFaces &clean, std::size_t vertices, const Executor &executor) {
  clean.around = faces_around(vertices, clean.triangle);
  if (!any_duplicate(clean.triangle, clean.around, executor)) {
    for (std::size_t t = clean.triangle.size(); t-- > 0;) clean.label[clean.source[t]] = static_cast<Index>(t);
    return;
  }
  const Vec<Index> same = find_duplicates(clean.triangle, clean.around);
  Vec<Index> place(same.size());  // of a triangle, or of the one it duplicates, among those kept
  Index size = 0, last_counted = none;
  for (Index t = 0; t < same.size(); ++t) {
    const Index f = clean.source[t];
    place[t] = same[t] == t ? size : place[same[t]];
    // Its own first triangle, if one is kept; else the first that one of its triangles duplicates.
    Index &label = clean.label[f];
    if (label == none || (same[t] == t && clean.source[label] != f)) label = place[t];
    if (same[t] != t) {
      clean.duplicate += last_counted != f;
      last_counted = f;
      continue;
    }
    clean.triangle[size] = clean.triangle[t];
    clean.source[size++] = f;
  }
  clean.triangle.resize(size);
  clean.source.resize(size);
  clean.around = faces_around(vertices, clean.triangle);
}

// A face that is gone takes the label of the triangle nearest to it among those at its corners (of the first 64 at
// each: a vertex with more is no place on a tooth, and many such faces at one would take the square of them).
void label_degenerate(const RawMesh &raw, std::span<const Index> kept, CleanFaces &clean) {
  constexpr std::size_t most = 64;
  Vec<std::uint8_t> wanted(raw.position.size(), 0);
  for (Index f = 0; f < raw.faces(); ++f)
    if (clean.label[f] == none)
      for (const Index v : raw.face(f)) wanted[kept[v]] = 1;
  const Rows around = rows_by(raw.position.size(), clean.triangle.size(), [&](std::size_t t, const auto &add) {
    for (const Index v : clean.triangle[t])
      if (wanted[v]) add(v);
  });
  StopNowAndThen stop(1 << 14);
  for (Index f = 0; f < raw.faces(); ++f) {
    stop();
    const std::span<const Index> corners = raw.face(f);
    if (clean.label[f] != none || corners.empty()) continue;
    Vec3 centre(0, 0, 0);
    for (const Index v : corners) centre += raw.position[v] / static_cast<double>(corners.size());
    double least = std::numeric_limits<double>::infinity();
    for (const Index v : corners) {
      const std::span<const Index> touching = around[kept[v]];
      for (const Index t : touching.first(std::min(most, touching.size()))) {
        const auto [a, b, c] = clean.triangle[t];
        const double d = ((raw.position[a] + raw.position[b] + raw.position[c]) / 3 - centre).squaredNorm();
        if (d < least) least = d, clean.label[f] = t;
      }
    }
  }
}

}  // namespace

CleanFaces clean_faces(const RawMesh &raw, std::span<const Index> kept, const Executor &executor, Progress progress) {
  CleanFaces clean;
  bool triangles = true;
  for (std::size_t f = 0; f < raw.face_start.size() && triangles; ++f) triangles = raw.face_start[f] == 3 * f;
  if (triangles)
    take_triangles(raw, kept, clean, executor);
  else
    cut_polygons(raw, kept, clean, progress.part(0, 0.5, "intake"));
  progress(0.5);
  clean.label.assign(raw.faces(), none);
  drop_duplicates(clean, raw.position.size(), executor);
  if (clean.degenerate > 0) label_degenerate(raw, kept, clean);
  return clean;
}

}  // namespace ts::mesh
