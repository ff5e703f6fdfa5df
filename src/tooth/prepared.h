// What all clicks on a scan share.
#pragma once

#include <chrono>
#include <memory>

#include "cut/space.h"
#include "features/features.h"
#include "field/border.h"
#include "field/outliers.h"
#include "tooth/segmenter.h"

namespace ts::tooth {

// What no group changes.
struct Relief {
  Vec<double> concavity;   // a vertex, 1/mm
  Vec<double> length;      // an edge, mm
  Vec<double> price;       // an edge: of the min-cut that runs along it
  Vec<double> cotangent;   // an edge, for the smoothing of lines
  Vec<double> click_cost;  // an edge
};

// A copy shares all that is large but what there is a vertex: groups are added to a copy (make_group).
struct Prepared {
  const mesh::Surface *surface = nullptr;
  const Executor *executor = nullptr;
  Options options;
  bool inside_out = false;  // the faces look inwards
  Vec3 occlusal = Vec3::Zero();
  Index groups = 0;
  Index found = 0;           // groups of the features; those made by clicks come after them
  Vec<Index> live;           // groups with a point in use, along the arch
  field::Sites sites;        // the points in use
  Vec<Index> group_at;       // a vertex: the group of the point there, or none; rejected points left out
  Vec<Vec<Index>> rejected;  // a group: places in Group::points
  std::shared_ptr<const Relief> relief;
  double lengthened = 1;  // of paths, by noise
  double widened = 1;     // of areas, by noise
  Vec<double> width;      // a group: of its stretch of the arch, mm; 0 if unknown
  Vec<Vec3> along;        // a group: unit vector along the arch; zero if unknown
  field::Nodes nodes;
  Vec<std::uint8_t> outlier;  // a node
  Vec<Vec<Index>> seeds;      // a group: vertices held as its constraint, ascending
  std::shared_ptr<const field::Solver> solver;
  Vec<Vec<Index>> added;                        // the vertices of nodes that clicks added after the solver's
  std::shared_ptr<const field::Border> border;  // of these; null without any
  std::shared_ptr<cut::Spaces> spaces = std::make_shared<cut::Spaces>();
  PrepareTimes times;

  // Of all but the solver.
  std::size_t bytes() const {
    return sizeof(double) * (relief->concavity.size() + relief->length.size() + relief->price.size() +
                             relief->cotangent.size() + relief->click_cost.size()) +
           sizeof(Index) * (group_at.size() + nodes.of_vertex.size() + nodes.vertices.item.size());
  }

  // What a cut or a search works in; each task takes one of its own.
  cut::Spaces::Lease space() const {
    return spaces->take([this] { return std::make_unique<cut::Space>(*surface); });
  }
};

// What a vertex is to a tooth.
inline constexpr std::uint8_t kFree = 0, kOwn = 1, kForeign = 2;  // neither / its seed / another tooth's or gingiva
inline std::uint8_t kind_for(const Prepared &p, Index group, Index vertex) {
  const Index n = p.nodes.of_vertex[vertex];
  return n == mesh::none || p.outlier[n] ? kFree : p.nodes.group[n] == group ? kOwn : kForeign;
}

Prepared prepare(const mesh::Surface &surface, const features::Features &features, const Options &options,
                 const Executor &executor, const Progress &progress);

class Stopwatch {
 public:
  // Milliseconds since made or last asked.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double ms = std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
    return ms;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace ts::tooth
