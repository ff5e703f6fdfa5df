// The sites of Eq. 1 as nodes: sets of vertices that share one value.
#pragma once

#include "mesh/surface.h"

namespace ts::field {

using mesh::Index;

inline constexpr Index gingiva_group = mesh::none - 1;

struct Nodes {
  Vec<Index> of_vertex;        // a vertex: its node, or none
  mesh::Rows vertices;         // a node: its vertices, ascending
  Vec<Index> group;            // a node: its tooth, or gingiva_group
  Vec<Index> point;            // a node: its place in Sites::point, none for gingiva
  Index groups = 0;            // number of teeth
  Index gingiva = mesh::none;  // node of the gingiva, if there is one

  std::size_t size() const { return group.size(); }
};

struct Sites {
  Vec<Index> point;  // feature points: vertices
  Vec<Index> group;  // of each point
  Index groups = 0;
};

struct NodeOptions {
  double seed_radius = 0.7;      // mm; 0: the vertex alone
  bool gingiva = true;           // make a node of what is gingiva for certain
  double gingiva_distance = 13;  // mm from every feature point
  double lengthened = 1;         // paths along noise are this much longer than what they measure
};

// A node a feature point: the vertices nearer to it along edges than to any other point, and within the radius. A point
// that shares its vertex with an earlier one has none. Pieces of the surface without a point get no gingiva either.
Nodes make_nodes(const mesh::Surface &surface, const Sites &sites, const NodeOptions &options);

}  // namespace ts::field
