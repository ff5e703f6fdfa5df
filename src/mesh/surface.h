// The mesh that all later rooms work on: flat arrays, made once, never changed.
//
// What holds (intake sees to it): every index in range; no degenerate or duplicate face; an edge has one or two faces,
// two of them in opposite directions; the faces around a vertex are one fan; winding is consistent within a component,
// counter-clockwise seen from outside.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "base/executor.h"
#include "base/memory.h"

namespace ts::mesh {

using Index = std::uint32_t;
inline constexpr Index none = UINT32_MAX;

using Vec3 = Eigen::Vector3d;
using Triangle = std::array<Index, 3>;
using Edge = std::array<Index, 2>;

// Rows of varying length in one array.
struct Rows {
  Vec<Index> start;  // rows + 1
  Vec<Index> item;

  std::size_t size() const { return start.empty() ? 0 : start.size() - 1; }
  std::span<const Index> operator[](std::size_t i) const {
    return {item.data() + start[i], item.data() + start[i + 1]};
  }
};

// Half-edge h = 3 f + k runs from triangle[f][k] to triangle[f][(k + 1) % 3].
inline Index face_of(Index halfedge) {
  return halfedge / 3;
}
inline Index next_in_face(Index halfedge) {
  return halfedge % 3 == 2 ? halfedge - 2 : halfedge + 1;
}

struct Surface {
  Vec<Vec3> position;  // mm
  Vec<Triangle> triangle;

  Vec<Index> twin;          // a half-edge: the one on the other side, none on a boundary
  Vec<Edge> edge;           // ends of each edge, smaller index first; edges in lexicographic order
  Vec<Index> edge_of;       // a half-edge: its edge
  Rows vertex_faces;        // a vertex: its faces, ascending
  Rows vertex_edges;        // a vertex: its edges, ascending
  Vec<double> face_area;    // mm^2
  Vec<Vec3> face_normal;    // unit, outwards; zero for a face without area
  Vec<double> vertex_area;  // a third of the faces around, mm^2
  Vec<Index> component;     // a face: its connected piece, pieces numbered by falling area
  Vec<Index> vertex_component;
  Index components = 0;
  Rows boundary;                // closed loops of boundary vertices, in the direction of the half-edges, longest first
  Vec<double> boundary_length;  // mm
  Vec<std::uint8_t> on_boundary;  // a vertex: 1 if on a loop
  double area = 0, mean_edge = 0, diagonal = 0;

  std::size_t bytes() const;
  std::size_t vertices() const { return position.size(); }
  std::size_t faces() const { return triangle.size(); }
  Index from(Index halfedge) const { return triangle[halfedge / 3][halfedge % 3]; }
  Index to(Index halfedge) const { return from(next_in_face(halfedge)); }
  Index other_end(Index e, Index v) const { return edge[e][0] == v ? edge[e][1] : edge[e][0]; }
  double edge_length(Index e) const { return (position[edge[e][0]] - position[edge[e][1]]).norm(); }
};

// A vertex: its faces, ascending.
Rows faces_around(std::size_t vertices, std::span<const Triangle> triangle);

// What intake may know of the triangles already; empty where it does not.
struct Links {
  Rows vertex_faces;
  Vec<Index> twin;  // if given, no edge has more than two faces, or two in the same direction
};

// Fills everything from positions and triangles. An edge with more than two faces, or with two in the same direction,
// is left without twins (as if cut open).
Surface make_surface(Vec<Vec3> position, Vec<Triangle> triangle, const Executor &executor = Executor(1),
                     Links links = {});

}  // namespace ts::mesh
