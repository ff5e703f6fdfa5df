#include "geometry/paths.h"

#include <cmath>

namespace ts::geometry {
namespace {

// Vertices to go on from, by distance in steps of a mean edge: in a queue as coarse as that a vertex may be gone on
// from twice, but it costs no logarithm. The distances are the same, since there is one least sum for each vertex.
class Buckets {
 public:
  explicit Buckets(double width) : width_(width) {}

  void push(Index v, double distance) {
    const double place = distance / width_;
    const std::size_t b = std::max(at_, place < most ? static_cast<std::size_t>(place) : most);
    if (b >= bucket_.size()) bucket_.resize(b + 1);
    bucket_[b].push_back({v, distance});
  }

  // The next vertex and the distance it was pushed with; false at the end.
  bool pop(Index &v, double &distance) {
    for (; at_ < bucket_.size(); ++at_, next_ = 0) {
      Vec<Entry> &here = bucket_[at_];
      if (next_ < here.size()) {
        v = here[next_].vertex;
        distance = here[next_++].distance;
        return true;
      }
      here = {};
    }
    return false;
  }

 private:
  static constexpr std::size_t most = 1 << 16;  // what is further away shares the last one

  struct Entry {
    Index vertex;
    double distance;
  };

  double width_;
  Vec<Vec<Entry>> bucket_;
  std::size_t at_ = 0, next_ = 0;
};

}  // namespace

Vec<double> edge_distances(const Surface &surface, std::span<const PathStart> starts, double limit) {
  Vec<double> distance(surface.vertices(), std::numeric_limits<double>::infinity());
  Buckets open(std::max(surface.mean_edge, std::numeric_limits<double>::min()));
  const auto offer = [&](Index v, double d) {
    if (d > limit || !(d < distance[v])) return;
    distance[v] = d;
    open.push(v, d);
  };
  for (const PathStart &s : starts) offer(s.vertex, s.distance);
  Index v = 0;
  for (double d = 0; open.pop(v, d);) {
    if (d != distance[v]) continue;  // reached on a shorter way since
    for (const Index e : surface.vertex_edges[v]) offer(surface.other_end(e, v), d + surface.edge_length(e));
  }
  return distance;
}

}  // namespace ts::geometry
