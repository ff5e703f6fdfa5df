#include <algorithm>
#include <unordered_set>

#include "tooth/crossings.h"
#include "tooth/fill.h"
#include "tooth/tooth_mesh.h"

namespace ts::tooth {
namespace {

// Cuts make edges of any length: points of a fill need not be nearer to each other than this share of the mean edge.
constexpr double kLeastSpacing = 0.7;

class Closer {
 public:
  explicit Closer(PartMesh &part, const Executor &executor)
      : part_(part), surface_(mesh::make_surface(part.position, part.triangle, executor)) {
    for (const auto &[a, b] : surface_.edge)
      if (surface_.on_boundary[a] && surface_.on_boundary[b]) joined_.insert(key(a, b));
  }

  const mesh::Rows &loops() const { return surface_.boundary; }

  // Appends the fill of a loop. False, with nothing done, if it would cross the mesh.
  bool fill(std::size_t loop, const FillOptions &options, const Progress &progress) {
    // Against the half-edges of the mesh.
    const std::span<const Index> along = surface_.boundary[loop];
    const Vec<Index> ring(along.rbegin(), along.rend());
    Vec<Vec3> points;
    Vec<double> spacing;
    for (const Index v : ring) {
      points.push_back(part_.position[v]);
      double sum = 0;
      for (const Index e : surface_.vertex_edges[v]) sum += surface_.edge_length(e);
      const double mean = sum / static_cast<double>(surface_.vertex_edges[v].size());
      spacing.push_back(std::max(mean, kLeastSpacing * surface_.mean_edge));
    }
    const Index n = static_cast<Index>(ring.size());
    const auto taken = [&](Index i, Index j) {
      const bool side = (i + 1) % n == j || (j + 1) % n == i;
      return !side && joined_.contains(key(ring[i], ring[j]));
    };
    const Fill fill = fill_loop(points, spacing, taken, options, progress);

    const std::size_t vertices = part_.position.size(), triangles = part_.triangle.size();
    part_.position.insert(part_.position.end(), fill.position.begin() + n, fill.position.end());
    for (Triangle t : fill.triangle) {
      for (Index &v : t) v = v < n ? ring[v] : static_cast<Index>(vertices) + v - n;
      part_.triangle.push_back(t);
    }
    if (crossings(part_.position, part_.triangle, static_cast<Index>(triangles)).empty()) return true;
    part_.position.resize(vertices);
    part_.triangle.resize(triangles);
    return false;
  }

 private:
  static std::uint64_t key(Index a, Index b) { return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b); }

  PartMesh &part_;
  mesh::Surface surface_;
  std::unordered_set<std::uint64_t> joined_;  // edges between vertices on loops
};

}  // namespace

void close(PartMesh &part, const Executor &executor, const Progress &progress) {
  PartMesh closed = part;
  Closer closer(closed, executor);
  // The membrane; where it crosses the crown, flatter ones.
  constexpr FillOptions ways[] = {{1.15, 3}, {1.15, 1}, {1.15, 0}, {1e9, 0}};
  const std::size_t n = closer.loops().size();
  for (std::size_t k = 0; k < n; ++k) {
    const Progress share = progress.part(static_cast<double>(k) / static_cast<double>(n),
                                         static_cast<double>(k + 1) / static_cast<double>(n), "closing");
    if (std::ranges::none_of(ways, [&](const FillOptions &way) { return closer.fill(k, way, share); })) {
      const Vec3 &at = closed.position[closer.loops()[k].front()];
      throw Error(Fault::not_closed, "the rim at (" + std::to_string(at.x()) + ", " + std::to_string(at.y()) + ", " +
                                         std::to_string(at.z()) + ") cannot be closed without crossing the crown");
    }
  }
  closed.filled = static_cast<Index>(n);
  closed.flag.resize(closed.position.size(), VertexFlag::of_fill);
  closed.source.resize(closed.triangle.size(), mesh::none);
  measure(closed, executor);
  part = std::move(closed);
}

}  // namespace ts::tooth
