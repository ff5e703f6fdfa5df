#include "geometry/geodesic.h"

#include <array>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "geometry/gradient.h"

namespace ts::geometry {
namespace {

constexpr Index kFace = mesh::none;  // the way is within a face or on its edge, not at a vertex

// Where the way has come to: a vertex, or a point of a face, which it is about to cross.
struct Stand {
  Index vertex = kFace;
  Index face = mesh::none;
  std::array<double, 3> weight{};
  Index came = mesh::none;  // the face before
};

class Way {
 public:
  Way(const Surface &s, const Marcher &march, const Vec3 &to) : s_(s), march_(march), to_(to) {}

  // The steepest way on from a stand; false where there is none down.
  bool step(Stand &at, Vec<EdgeCrossing> &way) const { return at.vertex == kFace ? cross(at, way) : leave(at, way); }

  // From now on by what is linear in each face alone, which always leads down to the target.
  void distrust() { trust_ = false; }

 private:
  // How fast the weights of the corners change when one goes down; false where the distance is not known or flat.
  bool downhill(Index f, const Vec3 &at, std::array<double, 3> &rate, double &slope) const {
    const auto &t = s_.triangle[f];
    const double d[3] = {march_.distance(t[0]), march_.distance(t[1]), march_.distance(t[2])};
    if (!std::isfinite(d[0] + d[1] + d[2])) return false;
    Vec3 g = face_gradient(s_, f, d[0], d[1], d[2]);
    // Where the distances are straight ones their own gradient: that of a linear one is poor near the target.
    if (straight(t[0]) && straight(t[1]) && straight(t[2])) {
      const Vec3 away = at - to_, &normal = s_.face_normal[f];
      g = (away - away.dot(normal) * normal) / std::max(away.norm(), 1e-12);
    }
    slope = g.norm();
    if (!(slope > 0)) return false;
    rate[0] = -face_gradient(s_, f, 1, 0, 0).dot(g);
    rate[1] = -face_gradient(s_, f, 0, 1, 0).dot(g);
    rate[2] = -rate[0] - rate[1];
    return true;
  }

  bool straight(Index v) const {
    const double d = (s_.position[v] - to_).norm();
    return trust_ && std::abs(march_.distance(v) - d) <= 1e-9 * d;
  }
  Vec3 position(const Stand &at) const {
    const auto &t = s_.triangle[at.face];
    return at.weight[0] * s_.position[t[0]] + at.weight[1] * s_.position[t[1]] + at.weight[2] * s_.position[t[2]];
  }

  bool to_vertex(Stand &at, Index v, Vec<EdgeCrossing> &way) const {
    const Index e = s_.vertex_edges[v].front();
    way.push_back({s_.edge[e][0], s_.edge[e][1], s_.edge[e][0] == v ? 0.0 : 1.0});
    at.vertex = v;
    at.came = mesh::none;
    return true;
  }

  bool cross(Stand &at, Vec<EdgeCrossing> &way) const {
    const auto &t = s_.triangle[at.face];
    std::array<double, 3> rate;
    double slope = 0;
    if (!downhill(at.face, position(at), rate, slope)) return lowest_corner(at, way);
    std::size_t out = 3;
    double first = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k)
      if (rate[k] < 0 && at.weight[k] / -rate[k] < first) first = at.weight[k] / -rate[k], out = k;
    if (out == 3) return lowest_corner(at, way);
    if (!(first > 0)) {  // on an edge, and down is beyond it: back where it came from means along the edge
      const Index beyond = s_.twin[3 * at.face + static_cast<Index>((out + 1) % 3)];
      if (beyond == mesh::none || mesh::face_of(beyond) == at.came) return lowest_corner(at, way);
      return enter(at, mesh::face_of(beyond));
    }
    const std::size_t a = (out + 1) % 3, b = (out + 2) % 3;
    const double wa = std::max(0.0, at.weight[a] + first * rate[a]), wb = std::max(0.0, at.weight[b] + first * rate[b]);
    const double share = wb / (wa + wb);
    constexpr double kCorner = 1e-9;
    if (share < kCorner) return to_vertex(at, t[a], way);
    if (share > 1 - kCorner) return to_vertex(at, t[b], way);
    way.push_back({t[a], t[b], share});
    const Index over = s_.twin[3 * at.face + static_cast<Index>(a)];
    if (over == mesh::none) return to_vertex(at, march_.distance(t[a]) < march_.distance(t[b]) ? t[a] : t[b], way);
    at.weight[out] = 0, at.weight[a] = 1 - share, at.weight[b] = share;
    return enter(at, mesh::face_of(over));
  }

  // The same point as one of the face across the edge that it is on.
  bool enter(Stand &at, Index face) const {
    const auto &t = s_.triangle[at.face], &next = s_.triangle[face];
    std::array<double, 3> weight{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t j = 0; j < 3; ++j)
        if (next[k] == t[j]) weight[k] = at.weight[j];
    at.weight = weight;
    at.came = at.face;
    at.face = face;
    return true;
  }

  // To the lower end of the edge that the stand is on, or the lowest corner of its face.
  bool lowest_corner(Stand &at, Vec<EdgeCrossing> &way) const {
    const auto &t = s_.triangle[at.face];
    std::size_t low = 3;
    for (std::size_t k = 0; k < 3; ++k)
      if (at.weight[k] > 0 && (low == 3 || march_.distance(t[k]) < march_.distance(t[low]))) low = k;
    return std::isfinite(march_.distance(t[low])) && to_vertex(at, t[low], way);
  }

  bool leave(Stand &at, Vec<EdgeCrossing> &way) const {
    const Index v = at.vertex;
    double steepest = 0;
    Index face = mesh::none, next = mesh::none;
    for (const Index f : s_.vertex_faces[v]) {
      std::array<double, 3> rate;
      double slope = 0;
      if (!downhill(f, s_.position[v], rate, slope) || !(slope > steepest)) continue;
      const auto &t = s_.triangle[f];
      const std::size_t k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
      if (rate[(k + 1) % 3] > 0 && rate[(k + 2) % 3] > 0) steepest = slope, face = f;
    }
    for (const Index e : s_.vertex_edges[v]) {
      const Index w = s_.other_end(e, v);
      if (const double slope = (march_.distance(v) - march_.distance(w)) / s_.edge_length(e); slope > steepest)
        steepest = slope, next = w;
    }
    if (next != mesh::none) return to_vertex(at, next, way);
    if (face == mesh::none) return false;
    at.vertex = kFace;
    at.face = face;
    for (std::size_t k = 0; k < 3; ++k) at.weight[k] = s_.triangle[face][k] == v;
    return cross(at, way);
  }

  const Surface &s_;
  const Marcher &march_;
  const Vec3 to_;
  bool trust_ = true;
};

}  // namespace

Vec<EdgeCrossing> geodesic(const Surface &s, const mesh::SurfacePoint &from, const mesh::SurfacePoint &to, double limit,
                           Marcher &march) {
  Vec<EdgeCrossing> way;
  if (from.face == to.face) return way;
  // Straight distances two rings around the target.
  march.begin(Marcher::Front::round);
  for (const Index v : s.triangle[to.face])
    for (const Index f : s.vertex_faces[v])
      for (const Index w : s.triangle[f]) march.start(w, (s.position[w] - to.position).norm());
  const auto &source = s.triangle[from.face];
  int wanted = 3;
  march.run([&](Index v, double d) {
    if (v == source[0] || v == source[1] || v == source[2]) --wanted;
    return wanted > 0 && d <= limit;
  });
  const auto arrived = [&](const Stand &at) {
    if (at.vertex == kFace) return at.face == to.face;
    const auto &t = s.triangle[to.face];
    return t[0] == at.vertex || t[1] == at.vertex || t[2] == at.vertex;
  };
  Stand at{kFace, from.face, {from.barycentric[0], from.barycentric[1], from.barycentric[2]}, mesh::none};
  Way down(s, march, to.position);
  constexpr std::size_t kMost = 5000;  // as many triangles has no way that is straight
  while (!arrived(at)) {
    if (way.size() > kMost) down.distrust();
    if (wanted > 0 || !down.step(at, way)) throw Error(Fault::not_found, "no way along the surface leads there");
  }
  return way;
}

}  // namespace ts::geometry
