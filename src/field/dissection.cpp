#include "field/dissection.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace ts::field {
namespace {

using mesh::Vec3;

// Most vertices of a piece that is not cut again. Smaller pieces mean fewer entries but more work around each; 16 to 40
// take the same time within a tenth.
constexpr std::size_t kLeaf = 12;
// Pieces above this size are cut in parallel.
constexpr std::size_t kParallel = 4096;

using Coordinates = std::array<float, 3>;

// Coordinates of the vertices along the principal axes of their positions; those of other vertices stay as they are.
void own_coordinates(const mesh::Surface &surface, std::span<const Index> vertices, Vec<Coordinates> &own) {
  Vec3 mean = Vec3::Zero();
  for (const Index v : vertices) mean += surface.position[v];
  mean /= static_cast<double>(std::max<std::size_t>(1, vertices.size()));
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const Index v : vertices) {
    const Vec3 d = surface.position[v] - mean;
    second += d * d.transpose();
  }
  const Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(second).eigenvectors();
  for (const Index v : vertices) {
    const Vec3 p = axes.transpose() * (surface.position[v] - mean);
    own[v] = {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
  }
}

class Dissector {
 public:
  Dissector(const mesh::Surface &surface, std::span<const Index> vertices, const Executor &executor)
      : surface_(surface), executor_(executor), ordered_(surface.vertices(), 1), at_(surface.vertices()) {
    own_coordinates(surface, vertices, at_);
    item_.resize(vertices.size());
    executor.ranges(item_.size(), kParallel, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Index v = vertices[i];
        double reach = 0;
        for (const Index e : surface.vertex_edges[v]) reach = std::max(reach, surface.edge_length(e));
        // A little more than the longest edge: the coordinates are rounded.
        item_[i] = {at_[v], static_cast<float>(reach * 1.001 + 1e-5 * surface.diagonal), v};
        ordered_[v] = 0;
      }
    });
  }

  Dissection run() {
    Dissection d;
    if (item_.empty()) return d;
    d.parts = cut(0, item_.size());
    for (Index i = 0; i < d.parts.size(); ++i)
      for (const Index c : d.parts[i].children)
        if (c != mesh::none) d.parts[c].parent = i;
    d.order.resize(item_.size());
    for (std::size_t i = 0; i < item_.size(); ++i) d.order[i] = item_[i].vertex;
    return d;
  }

 private:
  struct Item {
    Coordinates at;
    float reach;  // no edge of the vertex is longer
    Index vertex;
  };

  // Orders the items [begin, end) and gives their parts, the indices of which count from the first of them.
  Vec<Part> cut(std::size_t begin, std::size_t end) {
    const auto place = [](std::size_t i) { return static_cast<Index>(i); };
    if (end - begin <= kLeaf) return {Part{place(begin), place(end), place(begin)}};
    Coordinates low = item_[begin].at, high = low;
    for (std::size_t i = begin; i < end; ++i)
      for (int k = 0; k < 3; ++k)
        low[k] = std::min(low[k], item_[i].at[k]), high[k] = std::max(high[k], item_[i].at[k]);
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (high[k] - low[k] > high[axis] - low[axis]) axis = k;
    const auto item = [&](std::size_t i) { return item_.begin() + static_cast<std::ptrdiff_t>(i); };
    const auto place_of = [&](auto i) { return static_cast<std::size_t>(i - item_.begin()); };
    const std::size_t middle = begin + (end - begin) / 2;
    std::nth_element(item(begin), item(middle), item(end), [&](const Item &a, const Item &b) {
      return a.at[axis] != b.at[axis] ? a.at[axis] < b.at[axis] : a.vertex < b.vertex;
    });
    const float level = item_[middle].at[axis];
    const Index first = item_[middle].vertex;  // of the upper half
    const auto is_upper = [&](Index v) { return at_[v][axis] != level ? at_[v][axis] > level : v >= first; };
    // What is beside a vertex and not yet ordered lies in this piece: all around the piece is ordered.
    const auto crosses = [&](const Item &i, bool upper) {
      if (std::abs(i.at[axis] - level) > i.reach) return false;
      for (const Index e : surface_.vertex_edges[i.vertex])
        if (const Index w = surface_.other_end(e, i.vertex); !ordered_[w] && is_upper(w) != upper) return true;
      return false;
    };
    // Of either half the vertices that touch the other separate the halves; the fewer are taken.
    std::size_t crossing[2] = {0, 0};
    for (std::size_t i = begin; i < end; ++i) crossing[i >= middle] += crosses(item_[i], i >= middle);
    const bool upper = crossing[1] < crossing[0];
    const auto stays = [&](const Item &i) { return !crosses(i, upper); };
    std::size_t left = middle, right = end - crossing[upper];  // where the halves end
    if (upper) {
      std::partition(item(middle), item(end), stays);
    } else {
      left = place_of(std::partition(item(begin), item(middle), stays));
      std::rotate(item(left), item(middle), item(end));
    }
    for (std::size_t i = right; i < end; ++i) ordered_[item_[i].vertex] = 1;

    Vec<Part> halves[2];
    const auto go = [&](std::size_t k) {
      if (k == 0 && begin < left) halves[0] = cut(begin, left);
      if (k == 1 && left < right) halves[1] = cut(left, right);
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
  Vec<std::uint8_t> ordered_;  // a vertex: 1 once it separates, or if it is not to be ordered
  Vec<Coordinates> at_;        // a vertex
};

}  // namespace

Dissection dissect(const mesh::Surface &surface, std::span<const Index> vertices, const Executor &executor) {
  return Dissector(surface, vertices, executor).run();
}

}  // namespace ts::field
