#include <algorithm>
#include <unordered_set>

#include "base/shown.h"
#include "mesh/bvh.h"
#include "tooth/crossings.h"
#include "tooth/fill.h"
#include "tooth/tooth_mesh.h"

namespace ts::tooth {
namespace {

// Cuts make edges of any length: points of a fill need not be nearer to each other than this share of the mean edge.
constexpr double kLeastSpacing = 0.7;

// A collar goes at most this share of the way to what lies opposite inside.
constexpr double kOfWay = 0.4;

// Share of a part's area that may be taken off at its rims where it crosses itself or its fill.
constexpr double kMostTrimmed = 0.03;

// How a rim is closed: a collar of this height, mm, goes from it into the part, at right angles to its surface, and the
// membrane spans its other end. So the fill leaves the surface to the inside also where that is nearly level at the
// rim, and where a ragged rim would have a membrane run in and out.
struct Way {
  double collar;
  FillOptions fill;
};

// What is put into a loop.
struct Plug {
  Vec<Vec3> position;      // new points
  Vec<Triangle> triangle;  // of the loop's points, then these
};

class Closer {
 public:
  explicit Closer(PartMesh &part, const Executor &executor)
      : part_(part),
        surface_(mesh::make_surface(part.position, part.triangle, executor)),
        bvh_(surface_, executor),
        normal_(part.normal) {
    for (const auto &[a, b] : surface_.edge)
      if (surface_.on_boundary[a] && surface_.on_boundary[b]) joined_.insert(key(a, b));
  }

  const mesh::Rows &loops() const { return surface_.boundary; }

  // The triangles of the part that the best of the fills that failed crossed.
  const Vec<Index> &crossed() const { return crossed_; }

  // Appends the fill of a loop. False, with nothing done, if it would cross the mesh.
  bool fill(std::size_t loop, const Way &way, const Progress &progress) {
    // Against the half-edges of the mesh.
    const std::span<const Index> along = surface_.boundary[loop];
    const Vec<Index> ring(along.rbegin(), along.rend());
    const Plug plug = way.collar > 0 ? with_collar(ring, way, progress) : plain(ring, way, progress);
    if (plug.triangle.empty()) return false;
    const Index n = static_cast<Index>(ring.size());
    const std::size_t vertices = part_.position.size(), triangles = part_.triangle.size();
    part_.position.insert(part_.position.end(), plug.position.begin(), plug.position.end());
    for (Triangle t : plug.triangle) {
      for (Index &v : t) v = v < n ? ring[v] : static_cast<Index>(vertices) + v - n;
      part_.triangle.push_back(t);
    }
    if (settle(static_cast<Index>(triangles), static_cast<Index>(vertices))) return true;
    Vec<Index> crossed;
    for (const auto &pair : crossings(part_.position, part_.triangle, static_cast<Index>(triangles)))
      if (pair[0] < own_) crossed.push_back(pair[0]);
    std::sort(crossed.begin(), crossed.end());
    crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());
    if (!crossed.empty() && (crossed_.empty() || crossed.size() < crossed_.size())) crossed_ = std::move(crossed);
    part_.position.resize(vertices);
    part_.triangle.resize(triangles);
    return false;
  }

 private:
  static std::uint64_t key(Index a, Index b) { return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b); }

  double spacing_at(Index v) const {
    double sum = 0;
    for (const Index e : surface_.vertex_edges[v]) sum += surface_.edge_length(e);
    return std::max(sum / static_cast<double>(surface_.vertex_edges[v].size()), kLeastSpacing * surface_.mean_edge);
  }

  // Moves points of the fill, from `vertices` on, into the part where its triangles, from `triangles` on, cross it:
  // against the normals of what they cross, their neighbours half as far. False if some still do.
  bool settle(Index triangles, Index vertices) {
    constexpr int most = 40, patience = 8;  // rounds, and those without getting better
    constexpr double step = 0.04;           // mm
    Vec<Vec3> move(part_.position.size(), Vec3::Zero());
    std::size_t least = SIZE_MAX;
    int best_round = 0;
    for (int round = 0; round < most; ++round) {
      const auto found = crossings(part_.position, part_.triangle, triangles);
      if (found.empty()) return true;
      if (found.size() < least) least = found.size(), best_round = round;
      if (round - best_round > patience) return false;
      std::ranges::fill(move, Vec3::Zero());
      const auto push = [&](Index f, const Vec3 &by) {
        for (const Index v : part_.triangle[f])
          if (v >= vertices) move[v] += by;
      };
      for (const auto &[a, b] : found) {
        if (a < triangles) {
          push(b, -normal_of(a));
          continue;
        }
        const Vec3 apart = centre_of(b) - centre_of(a);  // two of the fill
        push(b, apart.normalized());
        push(a, -apart.normalized());
      }
      for (Vec3 &m : move)
        if (!m.isZero()) m.normalize();
      Vec<Vec3> spread = move;
      for (std::size_t f = triangles; f < part_.triangle.size(); ++f)
        for (const Index v : part_.triangle[f])
          for (const Index w : part_.triangle[f])
            if (v >= vertices && move[v].isZero()) spread[v] += move[w] / 4;
      for (std::size_t v = vertices; v < part_.position.size(); ++v) {
        const double length = spread[v].norm();
        if (length > 0) part_.position[v] += (move[v].isZero() ? std::min(0.5, length) : 1) * step / length * spread[v];
      }
    }
    return false;
  }

  Vec3 normal_of(Index f) const {
    const auto &[a, b, c] = part_.triangle[f];
    return (part_.position[b] - part_.position[a]).cross(part_.position[c] - part_.position[a]).normalized();
  }
  Vec3 centre_of(Index f) const {
    const auto &[a, b, c] = part_.triangle[f];
    return (part_.position[a] + part_.position[b] + part_.position[c]) / 3;
  }

  Plug plain(const Vec<Index> &ring, const Way &way, const Progress &progress) const {
    const Index n = static_cast<Index>(ring.size());
    Vec<Vec3> points;
    Vec<double> spacing;
    for (const Index v : ring) points.push_back(part_.position[v]), spacing.push_back(spacing_at(v));
    const auto taken = [&](Index i, Index j) {
      const bool side = (i + 1) % n == j || (j + 1) % n == i;
      return !side && joined_.contains(key(ring[i], ring[j]));
    };
    Fill fill = fill_loop(points, spacing, taken, way.fill, progress);
    return {{fill.position.begin() + n, fill.position.end()}, std::move(fill.triangle)};
  }

  // Mean of the values along the ring within `reach` of each point, by length.
  Vec<Vec3> smoothed(const Vec<Index> &ring, const Vec<Vec3> &value, double reach) const {
    const std::size_t n = ring.size();
    const auto step = [&](std::size_t i) {
      return (part_.position[ring[(i + 1) % n]] - part_.position[ring[i]]).norm();
    };
    Vec<Vec3> mean(n);
    for (std::size_t i = 0; i < n; ++i) {
      Vec3 sum = Vec3::Zero();
      double weight = 0, away = 0;
      const auto add = [&](std::size_t k) {
        const double w = (reach - away) * (step(k) + step((k + n - 1) % n));
        sum += w * value[k];
        weight += w;
      };
      add(i);
      for (std::size_t k = i; (away += step(k)) < reach && (k + 1) % n != i; k = (k + 1) % n) add((k + 1) % n);
      away = 0;
      for (std::size_t k = (i + n - 1) % n; (away += step(k)) < reach && k != i; k = (k + n - 1) % n) add(k);
      mean[i] = weight > 0 ? Vec3(sum / weight) : value[i];
    }
    return mean;
  }

  Plug with_collar(const Vec<Index> &ring, const Way &way, const Progress &progress) const {
    const std::size_t n = ring.size();
    double around = 0;
    for (std::size_t i = 0; i < n; ++i) around += (part_.position[ring[(i + 1) % n]] - part_.position[ring[i]]).norm();
    // Higher than its rim is long it would be filled with points without end: a mesh in other units than it says.
    if (way.collar > around) return {};
    const double reach = std::max(way.collar, 2 * surface_.mean_edge);
    Vec<Vec3> inwards, end(n);
    for (const Index v : ring) inwards.push_back(-normal_[v]);
    inwards = smoothed(ring, inwards, reach);
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3 d = inwards[i].norm() > 0 ? Vec3(inwards[i].normalized()) : Vec3(0, 0, 0);
      const Vec3 &p = part_.position[ring[i]];
      double height = way.collar;
      constexpr double clear = 0.05;  // mm: past the surface that it comes from
      if (!d.isZero())
        if (const auto hit = bvh_.raycast(surface_, p + clear * d, d))
          height = std::min(height, kOfWay * (hit->distance + clear));
      end[i] = p + height * d;
    }
    end = smoothed(ring, end, reach);
    // The end of the collar has points of the mesh's own density, each beside one of the rim.
    Vec<Index> beside;  // of each point of the end: its point of the rim
    double since = 0;
    for (Index i = 0; i < n; ++i) {
      if (i == 0 || since >= spacing_at(ring[i])) beside.push_back(i), since = 0;
      since += (part_.position[ring[(i + 1) % n]] - part_.position[ring[i]]).norm();
    }
    const Index m = static_cast<Index>(beside.size());
    if (m < 4) return {};
    Vec<Vec3> points;
    Vec<double> spacing;
    for (const Index i : beside) points.push_back(end[i]), spacing.push_back(spacing_at(ring[i]));
    const Fill fill = fill_loop(
        points, spacing, [](Index, Index) { return false; }, way.fill, progress);

    Plug plug;
    plug.position = fill.position;
    const Index base = static_cast<Index>(n);
    for (Index k = 0; k < m; ++k) {
      const Index from = beside[k], to = k + 1 < m ? beside[k + 1] : base, q = base + k, next = base + (k + 1) % m;
      const Index middle = (from + to + 1) / 2;  // up to here the rim hangs on this point, from here on on the next
      for (Index i = from; i < to; ++i) {
        if (i == middle) plug.triangle.push_back({i % base, next, q});
        plug.triangle.push_back({i, (i + 1) % base, i < middle ? q : next});
      }
      if (middle == to) plug.triangle.push_back({to % base, next, q});
    }
    for (const auto &[a, b, c] : fill.triangle) plug.triangle.push_back({base + a, base + b, base + c});
    return plug;
  }

  PartMesh &part_;
  mesh::Surface surface_;
  mesh::Bvh bvh_;
  Vec<Vec3> normal_;
  Index own_ = static_cast<Index>(part_.triangle.size());
  Vec<Index> crossed_;
  std::unordered_set<std::uint64_t> joined_;  // edges between vertices on loops
};

// Triangles at a rim that run through others of the part.
Vec<Index> crossed_at_rims(const PartMesh &part, const Executor &executor) {
  const mesh::Surface s = mesh::make_surface(part.position, part.triangle, executor);
  Vec<Index> order, inner;
  for (Index f = 0; f < s.faces(); ++f)
    (std::ranges::any_of(s.triangle[f], [&](Index v) { return s.on_boundary[v] != 0; }) ? order : inner).push_back(f);
  const Index first = static_cast<Index>(inner.size());
  order.insert(order.begin(), inner.begin(), inner.end());
  Vec<Triangle> triangle;
  for (const Index f : order) triangle.push_back(part.triangle[f]);
  Vec<Index> crossed;
  for (const auto &[a, b] : crossings(part.position, triangle, first)) {
    if (a >= first) crossed.push_back(order[a]);
    crossed.push_back(order[b]);
  }
  std::sort(crossed.begin(), crossed.end());
  crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());
  return crossed;
}

// Fills all rims; empty if that went well, else what stands in the way.
Vec<Index> fill_all(PartMesh &part, const Executor &executor, const Progress &progress) {
  // Where a fill crosses the part: other collars, then none.
  constexpr FillOptions membrane{1.15, 3};
  constexpr Way ways[] = {{0.2, membrane}, {0.4, membrane}, {0, membrane}};
  PartMesh closed = part;
  Closer closer(closed, executor);
  const std::size_t n = closer.loops().size();
  for (std::size_t k = 0; k < n; ++k) {
    const Progress share = progress.part(static_cast<double>(k) / static_cast<double>(n),
                                         static_cast<double>(k + 1) / static_cast<double>(n), "closing");
    if (std::ranges::any_of(ways, [&](const Way &way) { return closer.fill(k, way, share); })) continue;
    if (!closer.crossed().empty()) return closer.crossed();
    const Vec3 &at = closed.position[closer.loops()[k].front()];
    throw Error(Fault::not_closed, "the rim at " + shown(at) + " cannot be closed without crossing itself");
  }
  closed.filled = static_cast<Index>(n);
  closed.flag.resize(closed.position.size(), VertexFlag::of_fill);
  closed.source.resize(closed.triangle.size(), mesh::none);
  part = std::move(closed);
  return {};
}

double extent_of(const PartMesh &part) {
  if (part.position.empty()) return 0;
  Vec3 low = part.position[0], high = low;
  for (const Vec3 &p : part.position) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return (high - low).norm();
}

}  // namespace

void close(PartMesh &part, const Executor &executor, const Progress &progress) {
  constexpr int most_rounds = 12;
  // What closes a part is shaped in steps of hundredths of a millimetre.
  constexpr double least_extent = 0.5;  // mm
  if (const double extent = extent_of(part); extent < least_extent)
    throw Error(Fault::not_closed, "the part is but " + shown(extent) + " mm across");
  const double most_area = kMostTrimmed * part.area;
  PartMesh closed = part;
  for (int round = 0; round < most_rounds; ++round) {
    // The scan folds over itself here and there, above all between teeth.
    Vec<Index> off = crossed_at_rims(closed, executor);
    if (off.empty()) off = fill_all(closed, executor, progress);
    if (off.empty()) {
      measure(closed, executor);
      part = std::move(closed);
      return;
    }
    take_off(closed, off, executor);
    if (closed.area < part.area - most_area) break;
  }
  const Vec3 &at = part.position.front();  // of `closed` nothing may be left
  throw Error(Fault::not_closed, "the part at " + shown(at) + " cannot be closed without crossing itself");
}

}  // namespace ts::tooth
