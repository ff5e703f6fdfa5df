// Cuts polygons into triangles.
#pragma once

#include <span>

#include "mesh/surface.h"

namespace ts::mesh {

// Most corners of a concave polygon: ear clipping takes the square of them.
inline constexpr std::size_t most_concave_corners = 4096;

class Triangulator {
 public:
  // Appends the triangles of a polygon of at least 4 corners, wound as it is, to `out`: a fan if it is convex, ears
  // otherwise. A polygon without area gives none. False: it is concave and has too many corners.
  bool operator()(std::span<const Vec3> position, std::span<const Index> polygon, Vec<Triangle> &out);

 private:
  using Vec2 = Eigen::Vector2d;
  bool flatten(std::span<const Vec3> position);
  bool is_convex() const;
  double turn(Index i) const;  // twice the area of the triangle at corner i and its neighbours
  bool is_ear(Index i) const;
  void clip(Vec<Triangle> &out);

  Vec<Index> vertex_;
  Vec<Vec2> point_;  // in the plane of the polygon
  Vec<Index> before_, after_;
  double flat_ = 0;  // turns up to this are straight
};

}  // namespace ts::mesh
