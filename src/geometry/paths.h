// Shortest paths along edges (Dijkstra), from one or many vertices, stopped as soon as the caller has seen enough.
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "base/stop.h"
#include "mesh/surface.h"

namespace ts::geometry {

using mesh::Index;
using mesh::Surface;

struct PathStart {
  Index vertex;
  double distance = 0;
  Index tag = 0;  // handed on to the vertices reached from here
};

// Keeps its buffers between searches: a search costs what it visits, not the size of the mesh.
class PathFinder {
 public:
  explicit PathFinder(const Surface &surface)
      : surface_(&surface), distance_(surface.vertices()), tag_(surface.vertices()), stamp_(surface.vertices(), 0) {}

  // The vertices within `limit` of a start, in no order of meaning; their distances are those of a search. cost(edge)
  // >= 0. Goes on from vertices in the order they are reached: one may have to be gone on from again, but there is no
  // heap, and on a scan that takes a third of the time. Where costs are so uneven that it would not, it searches.
  template <class Cost>
  std::span<const Index> within(std::span<const PathStart> starts, const Cost &cost, double limit) {
    begin();
    reached_.clear();
    queue_.clear();
    const auto offer = [&](Index v, double d) {
      if (d > limit || (stamp_[v] >= open_ && !(d < distance_[v]))) return;
      if (stamp_[v] < open_) reached_.push_back(v);
      distance_[v] = d;
      if (stamp_[v] != open_ + 1) queue_.push_back(v);
      stamp_[v] = open_ + 1;  // in the queue
    };
    for (const PathStart &s : starts) offer(s.vertex, s.distance);
    StopNowAndThen stop(kOften);
    for (std::size_t at = 0; at < queue_.size(); ++at) {
      stop();
      if (at > 16 * reached_.size()) return within_by_search(starts, cost, limit);
      const Index v = queue_[at];
      stamp_[v] = open_;
      for (const Index e : surface_->vertex_edges[v]) offer(surface_->other_end(e, v), distance_[v] + cost(e));
    }
    return reached_;
  }
  double distance(Index v) const { return distance_[v]; }  // of one reached by the last search

  // cost(edge) >= 0; reach(vertex, distance, tag) is called for each vertex in the order of distance (ties: smaller
  // vertex first) and returns false to end the search.
  template <class Cost, class Reach>
  void search(std::span<const PathStart> starts, const Cost &cost, const Reach &reach) {
    begin();
    for (const PathStart &s : starts) offer(s.vertex, s.distance, s.tag);
    StopNowAndThen stop(kOften);
    while (!heap_.empty()) {
      stop();
      std::pop_heap(heap_.begin(), heap_.end());
      const Entry top = heap_.back();
      heap_.pop_back();
      if (stamp_[top.vertex] != open_ || top.distance != distance_[top.vertex]) continue;
      stamp_[top.vertex] = open_ + 1;  // settled
      if (!reach(top.vertex, top.distance, tag_[top.vertex])) return;
      for (const Index e : surface_->vertex_edges[top.vertex])
        offer(surface_->other_end(e, top.vertex), top.distance + cost(e), tag_[top.vertex]);
    }
  }

 private:
  static constexpr unsigned kOften = 1 << 13;

  template <class Cost>
  std::span<const Index> within_by_search(std::span<const PathStart> starts, const Cost &cost, double limit) {
    reached_.clear();
    search(starts, cost, [&](Index v, double d, Index) {
      if (d > limit) return false;
      reached_.push_back(v);
      return true;
    });
    return reached_;
  }

  struct Entry {
    double distance;
    Index vertex;
    bool operator<(const Entry &o) const { return distance != o.distance ? distance > o.distance : vertex > o.vertex; }
  };

  void begin() {
    if (open_ >= UINT32_MAX - 3) std::fill(stamp_.begin(), stamp_.end(), 0), open_ = 0;
    open_ += 2;
    heap_.clear();
  }
  void offer(Index v, double d, Index tag) {
    if (stamp_[v] > open_) return;  // settled
    const bool fresh = stamp_[v] != open_;
    if (!fresh && (d > distance_[v] || (d == distance_[v] && tag >= tag_[v]))) return;
    const bool queued = !fresh && d == distance_[v];
    stamp_[v] = open_;
    distance_[v] = d;
    tag_[v] = tag;
    if (queued) return;
    heap_.push_back({d, v});
    std::push_heap(heap_.begin(), heap_.end());
  }

  const Surface *surface_;
  Vec<double> distance_;
  Vec<Index> tag_;
  Vec<std::uint32_t> stamp_;
  std::uint32_t open_ = 0;  // stamp of a vertex in the queue of this search; one more: settled
  Vec<Entry> heap_;
  Vec<Index> reached_, queue_;  // of within
};

// Distance along edges from the nearest start, infinity beyond `limit`.
Vec<double> edge_distances(const Surface &surface, std::span<const PathStart> starts,
                           double limit = std::numeric_limits<double>::infinity());

}  // namespace ts::geometry
