#include "geometry/samples.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/stop.h"

namespace ts::geometry {
namespace {

constexpr int cell_bits = 21;  // a coordinate in the key of a cube

// Cubes by key: open addressing, so that a mesh of millions of triangles costs one probe or two a triangle.
class CubeMap {
 public:
  CubeMap() : slot_(std::size_t{1} << 14, Slot{0, mesh::none}) {}

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

  // The sums as means, sorted by cube.
  Vec<Sample> means() const {
    Vec<mesh::Index> order(sample_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<mesh::Index>(i);
    std::sort(order.begin(), order.end(), [&](mesh::Index a, mesh::Index b) { return key_[a] < key_[b]; });
    Vec<Sample> result;
    result.reserve(order.size());
    for (const mesh::Index i : order) {
      const Sample &s = sample_[i];
      if (s.area > 0) result.push_back({s.position / s.area, s.normal / s.area, s.area});
    }
    return result;
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

}  // namespace

Vec<Sample> area_samples(const mesh::Surface &surface, double spacing, const Frame &frame) {
  CubeMap cubes;
  constexpr double most = (1 << cell_bits) - 1;
  // Half a cube aside, so that a flat surface lies within a layer of cubes, not between two.
  constexpr double middle = (1 << (cell_bits - 1)) + 0.5;
  Vec<std::pair<Corners, double>> stack;
  StopNowAndThen stop(1 << 13);
  for (std::size_t f = 0; f < surface.faces(); ++f) {
    stop();
    const auto [i, j, k] = surface.triangle[f];
    const double area = surface.face_area[f];
    if (!(area > 0)) continue;
    const Corners corners{{surface.position[i], surface.position[j], surface.position[k]}};
    split(corners, spacing, stack, [&](const Vec3 &p, double share) {
      const Vec3 q = frame.of(p) / spacing;
      std::uint64_t key = 0;
      for (int c = 0; c < 3; ++c)
        key = key << cell_bits | static_cast<std::uint64_t>(std::clamp(q[c] + middle, 0.0, most));
      Sample &s = cubes.at(key);
      s.position += area * share * p;
      s.normal += area * share * surface.face_normal[f];
      s.area += area * share;
    });
  }
  return cubes.means();
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
