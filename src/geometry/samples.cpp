#include "geometry/samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace ts::geometry {
namespace {

constexpr int cell_bits = 21;  // a coordinate in the key of a cube

// Cubes by key: open addressing, so that a mesh of millions of triangles costs one probe or two a triangle.
class CubeMap {
 public:
  CubeMap() : slot_(std::size_t{1} << 12, Slot{0, mesh::none}) {}

  Sample &at(std::uint64_t key) {
    if (2 * sample_.size() >= slot_.size()) grow();
    std::size_t i = hash(key);
    while (slot_[i].index != mesh::none && slot_[i].key != key) i = (i + 1) & (slot_.size() - 1);
    if (slot_[i].index == mesh::none) {
      slot_[i] = {key, static_cast<mesh::Index>(sample_.size())};
      sample_.emplace_back();
      key_.push_back(key);
    }
    return sample_[slot_[i].index];
  }

  // Calls visit(key, sums) for each cube.
  void each(const auto &visit) const {
    for (std::size_t i = 0; i < key_.size(); ++i) visit(key_[i], sample_[i]);
  }

 private:
  struct Slot {
    std::uint64_t key;
    mesh::Index index;
  };

  std::size_t hash(std::uint64_t key) const {
    key *= 0x9e3779b97f4a7c15ull;
    return (key ^ (key >> 29)) & (slot_.size() - 1);
  }

  void grow() {
    Vec<Slot> bigger(4 * slot_.size(), Slot{0, mesh::none});
    slot_.swap(bigger);
    for (std::size_t s = 0; s < key_.size(); ++s) {
      std::size_t i = hash(key_[s]);
      while (slot_[i].index != mesh::none) i = (i + 1) & (slot_.size() - 1);
      slot_[i] = {key_[s], static_cast<mesh::Index>(s)};
    }
  }

  Vec<Slot> slot_;
  Vec<Sample> sample_;
  Vec<std::uint64_t> key_;
};

constexpr std::size_t kMaps = 16;

// Cubes next to each other are in different maps, so that all have their share of any part of the surface.
mesh::Index map_of(std::uint64_t key) {
  return static_cast<mesh::Index>((key ^ key >> cell_bits ^ key >> 2 * cell_bits) % kMaps);
}

struct Corners {
  Vec3 p[3];
};

// Calls piece(centroid, share of the triangle's area) for pieces with no edge over `limit`.
template <class Piece>
void split(const Corners &whole, double limit, Vec<std::pair<Corners, double>> &stack, Piece &&piece) {
  stack.clear();
  stack.push_back({whole, 1});
  while (!stack.empty()) {
    const auto [t, share] = stack.back();
    stack.pop_back();
    int longest = 0;
    double longest2 = 0;
    for (int k = 0; k < 3; ++k) {
      const double l2 = (t.p[k] - t.p[(k + 1) % 3]).squaredNorm();
      if (l2 > longest2) longest2 = l2, longest = k;
    }
    if (longest2 <= limit * limit) {
      piece(Vec3((t.p[0] + t.p[1] + t.p[2]) / 3), share);
      continue;
    }
    const Vec3 &a = t.p[longest], &b = t.p[(longest + 1) % 3], &c = t.p[(longest + 2) % 3];
    const Vec3 middle = (a + b) / 2;
    stack.push_back({{{a, middle, c}}, share / 2});
    stack.push_back({{{middle, b, c}}, share / 2});
  }
}

// The pieces of a range of faces, in the order of the faces, shared out among the maps.
struct Pieces {
  struct Piece {
    std::uint64_t key;
    mesh::Index face, map;
    double area;
    Vec3 centre;
  };
  Vec<Piece> piece;
  Vec<mesh::Index> order;  // of the pieces, map by map
  std::array<std::size_t, kMaps + 1> first{};

  void share_out() {
    first.fill(0);
    for (const Piece &p : piece) ++first[p.map + 1];
    for (std::size_t m = 0; m < kMaps; ++m) first[m + 1] += first[m];
    std::array<std::size_t, kMaps + 1> at = first;
    order.resize(piece.size());
    for (std::size_t i = 0; i < piece.size(); ++i) order[at[piece[i].map]++] = static_cast<mesh::Index>(i);
  }
};

// The sums as means, sorted by cube.
Vec<Sample> means(std::span<const CubeMap> maps) {
  Vec<std::pair<std::uint64_t, const Sample *>> cube;
  for (const CubeMap &m : maps) m.each([&](std::uint64_t key, const Sample &s) { cube.push_back({key, &s}); });
  std::sort(cube.begin(), cube.end());
  Vec<Sample> result;
  result.reserve(cube.size());
  for (const auto &[key, s] : cube)
    if (s->area > 0) result.push_back({s->position / s->area, s->normal / s->area, s->area});
  return result;
}

}  // namespace

Vec<Sample> area_samples(const mesh::Surface &surface, double spacing, const Frame &frame, const Executor &executor) {
  constexpr double most = (1 << cell_bits) - 1;
  // Half a cube aside, so that a flat surface lies within a layer of cubes, not between two.
  constexpr double middle = (1 << (cell_bits - 1)) + 0.5;
  // A block of faces at a time: its pieces are cut range by range, then summed map by map, in the order of the faces.
  constexpr std::size_t grain = 1 << 11, block = 1 << 16;
  Vec<CubeMap> maps(kMaps);
  Vec<Pieces> ranges(block / grain);
  for (std::size_t from = 0; from < surface.faces(); from += block) {
    const std::size_t faces = std::min(block, surface.faces() - from);
    executor.ranges(faces, grain, [&](std::size_t begin, std::size_t end) {
      Pieces &here = ranges[begin / grain];
      here.piece.clear();
      Vec<std::pair<Corners, double>> stack;
      for (std::size_t f = from + begin; f < from + end; ++f) {
        const auto [i, j, k] = surface.triangle[f];
        const double area = surface.face_area[f];
        if (!(area > 0)) continue;
        const Corners corners{{surface.position[i], surface.position[j], surface.position[k]}};
        split(corners, spacing, stack, [&](const Vec3 &p, double share) {
          const Vec3 q = frame.of(p) / spacing;
          std::uint64_t key = 0;
          for (int c = 0; c < 3; ++c)
            key = key << cell_bits | static_cast<std::uint64_t>(std::clamp(q[c] + middle, 0.0, most));
          here.piece.push_back({key, static_cast<mesh::Index>(f), map_of(key), area * share, p});
        });
      }
      here.share_out();
    });
    executor.each(kMaps, [&](std::size_t m) {
      for (std::size_t r = 0; r * grain < faces; ++r)
        for (std::size_t i = ranges[r].first[m]; i < ranges[r].first[m + 1]; ++i) {
          const Pieces::Piece &p = ranges[r].piece[ranges[r].order[i]];
          Sample &s = maps[m].at(p.key);
          s.position += p.area * p.centre;
          s.normal += p.area * surface.face_normal[p.face];
          s.area += p.area;
        }
    });
  }
  return means(maps);
}

SampleBins::SampleBins(std::span<const Sample> samples, double bin) : bin_(bin) {
  if (samples.empty()) return;
  Vec3 high = low_ = samples[0].position;
  for (const Sample &s : samples) {
    low_ = low_.cwiseMin(s.position);
    high = high.cwiseMax(s.position);
  }
  constexpr double most_bins = 1 << 23;
  while (((high - low_) / bin_).array().floor().operator+(1).prod() > most_bins) bin_ *= 2;
  count_ = ((high - low_) / bin_).array().floor().cast<int>() + 1;
  const auto bin_of = [&](const Sample &s) {
    std::size_t b = 0;
    for (int k = 0; k < 3; ++k) b = b * count_[k] + clamped((s.position[k] - low_[k]) / bin_, count_[k]);
    return b;
  };
  start_.assign(static_cast<std::size_t>(count_.cast<std::int64_t>().prod()) + 1, 0);
  for (const Sample &s : samples) ++start_[bin_of(s) + 1];
  for (std::size_t b = 1; b < start_.size(); ++b) start_[b] += start_[b - 1];
  Vec<mesh::Index> fill(start_.begin(), start_.end() - 1);
  sample_.resize(samples.size());
  for (const Sample &s : samples) sample_[fill[bin_of(s)]++] = s;
}

}  // namespace ts::geometry
