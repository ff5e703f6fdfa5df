#include "field/dissection.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <atomic>

namespace ts::field {
namespace {

using mesh::Vec3;

// Most vertices of a piece that is not cut again. Smaller pieces mean fewer entries but more work around each; 16 to 40
// take the same time within a tenth.
constexpr std::size_t kLeaf = 24;
// Pieces above this size are cut in parallel.
constexpr std::size_t kParallel = 4096;

// Coordinates of the vertices along the principal axes of their positions.
Vec<Vec3> own_coordinates(const mesh::Surface &surface, std::span<const Index> vertices) {
  Vec3 mean = Vec3::Zero();
  for (const Index v : vertices) mean += surface.position[v];
  mean /= static_cast<double>(std::max<std::size_t>(1, vertices.size()));
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const Index v : vertices) {
    const Vec3 d = surface.position[v] - mean;
    second += d * d.transpose();
  }
  const Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(second).eigenvectors();
  Vec<Vec3> own(vertices.size());
  for (std::size_t i = 0; i < own.size(); ++i) own[i] = axes.transpose() * (surface.position[vertices[i]] - mean);
  return own;
}

class Dissector {
 public:
  Dissector(const mesh::Surface &surface, std::span<const Index> vertices, const Executor &executor)
      : surface_(surface), executor_(executor), piece_(surface.vertices(), 0) {
    const Vec<Vec3> own = own_coordinates(surface, vertices);
    item_.resize(vertices.size());
    for (std::size_t i = 0; i < item_.size(); ++i) {
      item_[i] = {own[i], vertices[i]};
      piece_[vertices[i]] = 1;
    }
  }

  Dissection run() {
    Dissection d;
    if (item_.empty()) return d;
    d.parts = cut(0, item_.size(), 1);
    for (Index i = 0; i < d.parts.size(); ++i)
      for (const Index c : d.parts[i].children)
        if (c != mesh::none) d.parts[c].parent = i;
    d.order.resize(item_.size());
    for (std::size_t i = 0; i < item_.size(); ++i) d.order[i] = item_[i].vertex;
    return d;
  }

 private:
  struct Item {
    Vec3 at;
    Index vertex;
  };

  // Neighbouring pieces are cut at the same time, and a look at a vertex of theirs may find either name: neither is
  // one of this piece's.
  std::uint64_t piece_of(Index v) const { return std::atomic_ref(piece_[v]).load(std::memory_order_relaxed); }
  void set_piece(Index v, std::uint64_t name) { std::atomic_ref(piece_[v]).store(name, std::memory_order_relaxed); }

  bool touches(Index v, std::uint64_t name) const {
    for (const Index e : surface_.vertex_edges[v])
      if (piece_of(surface_.other_end(e, v)) == name) return true;
    return false;
  }

  // Orders the items [begin, end), the piece `name`; the parts' indices count from the first of them. Halves of piece
  // n are 2n and 2n + 1.
  Vec<Part> cut(std::size_t begin, std::size_t end, std::uint64_t name) {
    const auto place = [](std::size_t i) { return static_cast<Index>(i); };
    if (end - begin <= kLeaf) return {Part{place(begin), place(end), place(begin)}};
    Vec3 low = item_[begin].at, high = low;
    for (std::size_t i = begin; i < end; ++i) low = low.cwiseMin(item_[i].at), high = high.cwiseMax(item_[i].at);
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    const auto at = item_.begin();
    const auto offset = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
    std::size_t middle = begin + (end - begin) / 2;
    std::nth_element(at + offset(begin), at + offset(middle), at + offset(end), [&](const Item &a, const Item &b) {
      return a.at[axis] != b.at[axis] ? a.at[axis] < b.at[axis] : a.vertex < b.vertex;
    });
    for (std::size_t i = begin; i < end; ++i) set_piece(item_[i].vertex, 2 * name + (i >= middle));
    // Of either half the vertices that touch the other separate; the fewer are taken.
    std::size_t touching[2] = {0, 0};
    for (std::size_t i = begin; i < end; ++i)
      touching[i >= middle] += touches(item_[i].vertex, 2 * name + (i < middle));
    const bool upper = touching[1] < touching[0];
    const auto separates = [&](const Item &item) { return touches(item.vertex, 2 * name + !upper); };
    std::size_t left, right;  // where the halves end
    if (upper) {
      left = middle;
      right = begin + static_cast<std::size_t>(std::partition(at + offset(middle), at + offset(end),
                                                              [&](const Item &i) { return !separates(i); }) -
                                               (at + offset(begin)));
    } else {
      const auto kept =
          std::partition(at + offset(begin), at + offset(middle), [&](const Item &i) { return !separates(i); });
      left = static_cast<std::size_t>(kept - at);
      std::rotate(kept, at + offset(middle), at + offset(end));
      right = end - (middle - left);
    }
    for (std::size_t i = right; i < end; ++i) set_piece(item_[i].vertex, 0);

    Vec<Part> halves[2];
    const auto go = [&](std::size_t k) {
      if (k == 0 && begin < left) halves[0] = cut(begin, left, 2 * name);
      if (k == 1 && left < right) halves[1] = cut(left, right, 2 * name + 1);
    };
    if (end - begin > kParallel)
      executor_.each(2, go);
    else
      go(0), go(1);
    Vec<Part> parts = std::move(halves[0]);
    Part whole{place(right), place(end), place(begin)};
    if (!parts.empty()) whole.children[0] = place(parts.size() - 1);
    const Index base = place(parts.size());
    for (Part p : halves[1]) {
      for (Index &c : p.children)
        if (c != mesh::none) c += base;
      parts.push_back(p);
    }
    if (!halves[1].empty()) whole.children[1] = place(parts.size() - 1);
    parts.push_back(whole);
    return parts;
  }

  const mesh::Surface &surface_;
  const Executor &executor_;
  Vec<Item> item_;
  mutable Vec<std::uint64_t> piece_;  // a vertex: its piece, 0 for what is ordered last or not at all
};

}  // namespace

Dissection dissect(const mesh::Surface &surface, std::span<const Index> vertices, const Executor &executor) {
  return Dissector(surface, vertices, executor).run();
}

}  // namespace ts::field
