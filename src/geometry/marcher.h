// Distances along the surface across its faces: fast marching on triangles (Kimmel and Sethian, PNAS 95, 1998). In
// triangles through which no front comes, the edges are taken.
#pragma once

#include <algorithm>
#include <limits>

#include "base/stop.h"
#include "mesh/surface.h"

namespace ts::geometry {

using mesh::Index;
using mesh::Surface;
using mesh::Vec3;

// Keeps its buffers between uses, and takes them when it is first used: a march costs what it visits.
class Marcher {
 public:
  explicit Marcher(const Surface &surface) : surface_(&surface) {}

  // A front that crosses a triangle is taken for straight, as from a line, or for a circle, as from a point: then
  // distances on what can be laid flat are exact.
  enum class Front { straight, round };
  void begin(Front front);
  void start(Index v, double distance) { offer(v, distance); }

  // reach(vertex, distance) is called in the order of distance and returns false to end the march. Vertices beside
  // those reached have a distance too, from what was reached.
  template <class Reach>
  void run(const Reach &reach) {
    StopNowAndThen stop(1 << 12);
    while (!heap_.empty()) {
      stop();
      std::pop_heap(heap_.begin(), heap_.end());
      const Entry top = heap_.back();
      heap_.pop_back();
      if (stamp_[top.vertex] != open_ || top.distance != distance_[top.vertex]) continue;
      if (!reach(top.vertex, top.distance)) return;
      stamp_[top.vertex] = open_ + 1;
      spread(top.vertex);
    }
  }

  // Infinite where nothing has come near.
  double distance(Index v) const { return stamp_[v] >= open_ ? distance_[v] : std::numeric_limits<double>::infinity(); }

 private:
  struct Entry {
    double distance;
    Index vertex;
    bool operator<(const Entry &o) const { return distance != o.distance ? distance > o.distance : vertex > o.vertex; }
  };
  void offer(Index v, double d);
  void spread(Index v);
  bool settled(Index v) const { return stamp_[v] == open_ + 1; }

  const Surface *surface_;
  Vec<double> distance_;
  Vec<std::uint32_t> stamp_;
  std::uint32_t open_ = 0;  // stamp of a vertex that has a distance; one more: a final one
  Vec<Entry> heap_;
  Front front_ = Front::straight;
};

}  // namespace ts::geometry
