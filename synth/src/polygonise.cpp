// SPDX-License-Identifier: Apache-2.0
#include "polygonise.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

namespace tsa {
namespace {

constexpr int kBlock = 8;

// Values at grid corners, kept in blocks that are made when first touched.
class Grid {
 public:
  Grid(const Dentition &dentition, double spacing) : dentition_(dentition), spacing_(spacing) {
    origin_ = {-52, -82, -38};
    for (int i = 0; i < 3; ++i) blocks_[i] = static_cast<int>(kExtent[i] / (spacing * kBlock)) + 2;
    table_.resize(static_cast<size_t>(blocks_[0]) * blocks_[1] * blocks_[2]);
  }

  struct Block {
    std::array<float, kBlock * kBlock * kBlock> value;
    std::array<bool, kBlock * kBlock * kBlock> visited{};
    Block() { value.fill(std::numeric_limits<float>::quiet_NaN()); }
  };

  Vec3 position(int i, int j, int k) const { return origin_ + spacing_ * Vec3{double(i), double(j), double(k)}; }
  bool inside(int i, int j, int k) const {
    return i >= 0 && j >= 0 && k >= 0 && i + 1 < blocks_[0] * kBlock && j + 1 < blocks_[1] * kBlock &&
           k + 1 < blocks_[2] * kBlock;
  }
  float value(int i, int j, int k) {
    float &v = block(i, j, k).value[within(i, j, k)];
    if (std::isnan(v)) v = static_cast<float>(dentition_.field(position(i, j, k)));
    return v;
  }
  // True the first time.
  bool visit(int i, int j, int k) {
    bool &seen = block(i, j, k).visited[within(i, j, k)];
    return !std::exchange(seen, true);
  }
  uint64_t corner(int i, int j, int k) const {
    return (static_cast<uint64_t>(k) * (blocks_[1] * kBlock) + j) * (blocks_[0] * kBlock) + i;
  }
  std::array<int, 3> cell(Vec3 p) const {
    const Vec3 q = (1 / spacing_) * (p - origin_);
    return {static_cast<int>(q.x), static_cast<int>(q.y), static_cast<int>(q.z)};
  }

 private:
  static constexpr double kExtent[3] = {104, 104, 46};
  static size_t within(int i, int j, int k) { return (i % kBlock) + kBlock * ((j % kBlock) + kBlock * (k % kBlock)); }
  Block &block(int i, int j, int k) {
    auto &b = table_[(static_cast<size_t>(k / kBlock) * blocks_[1] + j / kBlock) * blocks_[0] + i / kBlock];
    if (!b) b = std::make_unique<Block>();
    return *b;
  }
  const Dentition &dentition_;
  double spacing_;
  Vec3 origin_;
  int blocks_[3];
  std::vector<std::unique_ptr<Block>> table_;
};

// Vertex of a grid edge: open addressing, keys are corner * 8 + direction.
class EdgeMap {
 public:
  EdgeMap() : slots_(1 << 16) {}
  uint32_t &operator[](uint64_t key) {
    if (2 * (size_ + 1) > slots_.size()) grow();
    Slot &s = find(key);
    if (s.key == kFree) s.key = key, ++size_;
    return s.value;
  }
  static constexpr uint32_t kNew = UINT32_MAX;

 private:
  static constexpr uint64_t kFree = UINT64_MAX;
  struct Slot {
    uint64_t key = kFree;
    uint32_t value = kNew;
  };
  Slot &find(uint64_t key) {
    size_t i = mix(key) & (slots_.size() - 1);
    while (slots_[i].key != kFree && slots_[i].key != key) i = (i + 1) & (slots_.size() - 1);
    return slots_[i];
  }
  void grow() {
    std::vector<Slot> old(slots_.size() * 2);
    old.swap(slots_);
    for (const Slot &s : old)
      if (s.key != kFree) find(s.key) = s;
  }
  std::vector<Slot> slots_;
  size_t size_ = 0;
};

class Walk {
 public:
  Walk(const Dentition &dentition, double spacing)
      : dentition_(dentition), spacing_(spacing), grid_(dentition, spacing) {}

  TriMesh run() {
    start();
    while (!queue_.empty()) {
      const auto c = queue_.back();
      queue_.pop_back();
      visit(c);
    }
    return std::move(mesh_);
  }

 private:
  using Cell = std::array<int, 3>;

  void start() {
    const PlacedTooth &tooth = dentition_.teeth().front();
    const double v = 0.5 * (tooth.shape.facial(0.5) - tooth.shape.lingual(0.5));
    Cell c = grid_.cell(tooth.world(0, v, 0.4 * tooth.shape.height));
    while (grid_.inside(c[0], c[1], c[2]) && grid_.value(c[0], c[1], c[2] + 1) < 0) ++c[2];
    push(c);
  }

  void push(Cell c) {
    if (!grid_.inside(c[0], c[1], c[2])) throw std::logic_error("the arch leaves its grid");
    if (grid_.visit(c[0], c[1], c[2])) queue_.push_back(c);
  }

  void visit(const Cell &c) {
    std::array<float, 8> v;
    int mask = 0;
    for (int m = 0; m < 8; ++m) {
      v[m] = grid_.value(c[0] + (m & 1), c[1] + (m >> 1 & 1), c[2] + (m >> 2));
      if (v[m] < 0) mask |= 1 << m;
    }
    if (mask == 0 || mask == 255) return;
    if (dentition_.trim(grid_.position(c[0], c[1], c[2])) < -3 * spacing_) return;
    triangulate(c, v);
    for (int axis = 0; axis < 3; ++axis)
      for (int far = 0; far < 2; ++far) {
        int negative = 0;
        for (int m = 0; m < 8; ++m)
          if ((m >> axis & 1) == far) negative += mask >> m & 1;
        if (negative == 0 || negative == 4) continue;
        Cell next = c;
        next[axis] += far ? 1 : -1;
        push(next);
      }
  }

  uint32_t vertex(const Cell &c, const std::array<float, 8> &v, int p, int q) {
    const int from = std::min(p, q),
              to = std::max(p, q);  // of two corners of a tetrahedron the lower is part of the higher
    const int i = c[0] + (from & 1), j = c[1] + (from >> 1 & 1), k = c[2] + (from >> 2);
    uint32_t &id = edges_[grid_.corner(i, j, k) * 8 + static_cast<uint64_t>(from ^ to)];
    if (id != EdgeMap::kNew) return id;
    id = static_cast<uint32_t>(mesh_.points.size());
    const int d = from ^ to;
    const double t = std::clamp(double(v[from]) / (double(v[from]) - double(v[to])), 0.02, 0.98);
    mesh_.points.push_back(grid_.position(i, j, k) +
                           (t * spacing_) * Vec3{double(d & 1), double(d >> 1 & 1), double(d >> 2)});
    return id;
  }

  // Kuhn's six tetrahedra around the diagonal 0-7; they match across cell faces.
  void triangulate(const Cell &c, const std::array<float, 8> &v) {
    static constexpr int kTets[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                                        {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
    for (const auto &t : kTets) {
      int in[4], out[4], ni = 0, no = 0;
      for (int k = 0; k < 4; ++k) (v[t[k]] < 0 ? in[ni++] : out[no++]) = k;
      const auto e = [&](int a, int b) { return vertex(c, v, t[a], t[b]); };
      // All six are wound alike; the sign of the permutation (in..., out...) tells the winding of the section.
      if (ni == 1 || ni == 3) {
        const int a = ni == 1 ? in[0] : out[0];
        const int *o = ni == 1 ? out : in;
        const bool flip = (a % 2 == 1) != (ni == 3);
        add(e(a, o[0]), e(a, o[1]), e(a, o[2]), flip);
      } else if (ni == 2) {
        // Even permutations of (in, out): 01|23, 03|12, 12|03, 23|01.
        const int code = in[0] * 4 + in[1];
        const bool flip = code == 2 || code == 7;
        const uint32_t p = e(in[0], out[0]), q = e(in[0], out[1]), r = e(in[1], out[1]), s = e(in[1], out[0]);
        add(p, q, r, flip);
        add(p, r, s, flip);
      }
    }
  }

  void add(uint32_t a, uint32_t b, uint32_t c, bool flip) {
    if (flip) std::swap(b, c);
    mesh_.faces.push_back({a, b, c});
  }

  const Dentition &dentition_;
  double spacing_;
  Grid grid_;
  EdgeMap edges_;
  std::vector<Cell> queue_;
  TriMesh mesh_;
};

}  // namespace

TriMesh polygonise(const Dentition &dentition, double spacing) {
  return Walk(dentition, spacing).run();
}

}  // namespace tsa
