// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "trimesh.h"

namespace tsa {

// Directed edges on flat arrays: half-edge 3 f + i runs from corner i of face f to the next. Vertices on a border are
// never moved or removed.
class Remesher {
 public:
  explicit Remesher(TriMesh mesh);

  // Collapses edges, the shortest first, until no more than `target` of the faces flagged in `counted` are left. Takes
  // the grid's slivers away and leaves triangles as irregular as those of a decimated scan.
  void collapseTo(size_t target, const std::vector<uint8_t> &counted, double edge);
  // Flips edges that are not Delaunay, except across creases.
  void flip();
  // Moves the nearer end of each edge between two labels onto the line between them, and keeps it on that line: label
  // lines then run along edges, in the valley, as on scans that were decimated by the change of shape.
  void snap(const std::function<uint32_t(Vec3)> &label);
  // Moves vertices towards the centre of their neighbours, in their tangent planes.
  void relax(double amount);
  void project(const std::function<double(Vec3)> &field, double longestStep);
  TriMesh take();

 private:
  static constexpr uint32_t kNone = UINT32_MAX;
  static uint32_t next(uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static uint32_t prev(uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  uint32_t &corner(uint32_t h) { return mesh_.faces[h / 3][h % 3]; }
  uint32_t from(uint32_t h) const { return mesh_.faces[h / 3][h % 3]; }
  uint32_t to(uint32_t h) const { return from(next(h)); }
  bool dead(uint32_t f) const { return mesh_.faces[f][0] == kNone; }
  Vec3 normal(uint32_t f) const;
  void link();
  void countValences();
  // Outgoing half-edges of the vertex that h leaves; false if there are more than fit.
  bool ring(uint32_t h);
  bool mayCollapse(uint32_t h, Vec3 position, double longest);
  bool survives(const std::vector<uint32_t> &outgoing, uint32_t without, uint32_t vertex, Vec3 position,
                double longest) const;
  void collapse(uint32_t h, Vec3 position);
  void collapsePass(size_t target, const std::vector<uint8_t> &counted, double edge, double shortest, size_t &left);
  bool shouldFlip(uint32_t h);

  TriMesh mesh_;
  std::vector<uint32_t> twin_;
  std::vector<uint8_t> border_;
  std::vector<uint8_t> onLine_;  // see snap
  std::vector<uint8_t> valence_;
  // When something last changed around a vertex, and when an edge was last refused: no edge is tried twice in vain.
  std::vector<uint32_t> changed_, refused_;
  uint32_t clock_ = 1;
  std::vector<uint32_t> ring_, ringA_;
};

}  // namespace tsa
