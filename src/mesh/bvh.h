// A tree of boxes over the faces, for picking: nearest point and ray.
#pragma once

#include <optional>

#include "base/executor.h"
#include "mesh/surface_point.h"

namespace ts::mesh {

// Made once; queries are const and may run at the same time. They want the surface the tree was made of.
class Bvh {
 public:
  Bvh() = default;
  explicit Bvh(const Surface &surface, const Executor &executor = Executor(1));

  std::size_t bytes() const { return sizeof(Node) * node_.size() + sizeof(Index) * face_.size(); }

  // The nearest point of the surface; of equally near faces the lowest. Face none if there is no face or p is not
  // finite.
  SurfacePoint nearest(const Surface &surface, const Vec3 &p) const;

  // The first hit, from either side. The ray cannot slip through between two faces that share an edge: what it makes of
  // the edge is the same number in both (Woop, Benthin, Wald: Watertight Ray/Triangle Intersection, JCGT 2013).
  std::optional<SurfacePoint> raycast(const Surface &surface, const Vec3 &origin, const Vec3 &direction) const;

 private:
  using Vec3f = Eigen::Vector3f;
  struct Box {
    Vec3f low, high;  // rounded outwards
  };
  struct Item {
    Box box;
    Index face;
  };
  struct Node {
    Box box;
    Index first;  // an inner node: its right child (the left one is the next node); a leaf: its first place in face_
    Index count;  // faces of a leaf, 0 = inner
  };
  struct Ray;

  struct Part;

  static void enclose(std::span<const Item> items, Box &box, Vec3f &low, Vec3f &high);
  static std::size_t divide(std::span<Item> items, Box &box);
  static void build(std::span<Item> items, std::size_t first, Vec<Node> &node);
  void join(std::span<const Part> parts, std::size_t part, std::size_t first);

  Vec<Node> node_;
  Vec<Index> face_;
};

}  // namespace ts::mesh
