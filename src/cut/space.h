// What a cut works in: arrays over the whole surface that are clean between uses.
#pragma once

#include "base/function_ref.h"
#include "base/pool.h"
#include "base/sparse_array.h"
#include "cut/max_flow.h"
#include "cut/polyline.h"
#include "geometry/marcher.h"
#include "geometry/paths.h"

namespace ts::cut {

// A face: 1 inside, 0 outside.
using Mask = SparseArray<std::uint8_t>;
// A value or a kind a vertex.
using Values = FunctionRef<double(Index)>;
using Kinds = FunctionRef<std::uint8_t(Index)>;

struct Space {
  Mask inside, faces;               // faces: what a function needs of its own
  SparseArray<std::uint8_t> marks;  // vertices
  SparseArray<Index> place;         // of a face or a vertex in a list
  SparseArray<double> level;        // a vertex
  geometry::PathFinder paths;
  geometry::Marcher march;  // takes its memory when a cut is first edited
  MaxFlow flow;

  explicit Space(const Surface &s)
      : inside(s.faces(), 0),
        faces(s.faces(), 0),
        marks(s.vertices(), 0),
        place(std::max(s.faces(), s.vertices()), mesh::none),
        level(s.vertices(), 1),
        paths(s),
        march(s) {}

  static std::size_t bytes(const Surface &s) {
    return s.faces() * 2 + s.vertices() * (1 + sizeof(double) + sizeof(double) + 2 * sizeof(Index)) +
           std::max(s.faces(), s.vertices()) * sizeof(Index);
  }

  void clear() noexcept {
    inside.clear();
    faces.clear();
    marks.clear();
    place.clear();
    level.clear();
  }
};

using Spaces = Pool<Space>;

}  // namespace ts::cut
