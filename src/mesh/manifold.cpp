#include "mesh/manifold.h"

#include <algorithm>
#include <iterator>

#include "base/stop.h"
#include "mesh/edges.h"

namespace ts::mesh {
namespace {

struct Shared {  // an edge of more than two faces, or of two that are not joined
  Edge ends;
  Vec<Index> side;
};

struct Side {  // of an edge after splitting
  Edge ends;
  Index halfedge;
  bool operator<(const Side &o) const { return ends != o.ends ? ends < o.ends : halfedge < o.halfedge; }
};

class Repair {
 public:
  Repair(std::span<const Vec3> position, Vec<Triangle> triangle, Rows vertex_faces, const Executor &executor)
      : position_(position),
        triangle_(std::move(triangle)),
        around_(std::move(vertex_faces)),
        twin_(3 * triangle_.size(), none),
        executor_(executor) {}

  Manifold run() {
    link();
    if (shared_.empty() && !clash_) {  // most scans
      if (one_fan_each()) {
        out_.triangle = std::move(triangle_);
        out_.links.vertex_faces = std::move(around_);
      } else {
        split();
      }
      out_.links.twin = std::move(twin_);
      return std::move(out_);
    }
    Vec<std::uint8_t> flip = orient();
    if (!shared_.empty()) {
      for (const Shared &s : shared_) pair_smoothest(s, flip);
      flip = orient();
    }
    cut_misfits(flip);
    apply(std::move(flip));
    split();
    for (bool again = true; come_apart(again); again = false) split();
    return std::move(out_);
  }

 private:
  Index from(Index h) const { return triangle_[h / 3][h % 3]; }
  Index to(Index h) const { return from(next_in_face(h)); }
  bool same_way(Index h, Index g) const { return from(h) == from(g); }
  // The next corner of the fan, to either side.
  Index left(Index h) const { return twin_[next_in_face(next_in_face(h))]; }
  Index right(Index h) const { return twin_[h] == none ? none : next_in_face(twin_[h]); }
  void join(Index h, Index g) { twin_[h] = g, twin_[g] = h; }
  void part(Index h) {
    if (twin_[h] != none) twin_[twin_[h]] = none;
    twin_[h] = none;
  }

  void link();
  bool one_fan_each() const;
  Vec<std::uint8_t> orient() const;
  double bend(const Edge &ends, Index h, Index g) const;
  void pair_smoothest(const Shared &s, std::span<const std::uint8_t> flip);
  void cut_misfits(std::span<const std::uint8_t> flip);
  void apply(Vec<std::uint8_t> flip);
  void split();
  bool come_apart(bool first_time);
  bool pair_otherwise(std::span<const Side> sides);
  Edge corner_vertices(Index h) const;

  static constexpr std::size_t kGrain = 1 << 13;

  std::span<const Vec3> position_;
  Vec<Triangle> triangle_;  // of the given vertices
  Rows around_;             // a given vertex: its faces
  Vec<Index> twin_;         // joined half-edges, also such as do not fit each other yet
  bool clash_ = false;      // there are such
  Vec<Shared> shared_;
  const Executor &executor_;
  Manifold out_;
};

void Repair::link() {
  struct Found {
    Vec<Shared> shared;
    bool clash = false;
  };
  Vec<Found> found((position_.size() + kGrain - 1) / kGrain);
  executor_.ranges(position_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    Found &here = found[begin / kGrain];
    EdgesUp up;
    for (Index v = static_cast<Index>(begin); v < end; ++v)
      up(triangle_, v, around_[v], [&](Index high, std::span<const EdgesUp::Side> sides) {
        if (sides.size() == 2) join(sides[0][1], sides[1][1]), here.clash |= same_way(sides[0][1], sides[1][1]);
        if (sides.size() <= 2) return;
        Shared s{{v, high}, {}};
        for (const auto &[end_, h] : sides) s.side.push_back(h);
        here.shared.push_back(std::move(s));
      });
  });
  for (Found &f : found) {
    clash_ |= f.clash;
    std::move(f.shared.begin(), f.shared.end(), std::back_inserter(shared_));
  }
  out_.non_manifold_edges = static_cast<Index>(shared_.size());
}

// Of faces that agree on which way round they are: whether those around each vertex are one fan.
bool Repair::one_fan_each() const {
  Vec<std::uint8_t> one((position_.size() + kGrain - 1) / kGrain, 1);
  executor_.ranges(position_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (Index v = static_cast<Index>(begin); v < end; ++v) {
      const std::span<const Index> faces = around_[v];
      if (faces.empty()) continue;
      const Triangle &t = triangle_[faces[0]];
      const Index first = 3 * faces[0] + (t[0] == v ? 0 : t[1] == v ? 1 : 2);
      std::size_t seen = 1;
      Index h = left(first);
      for (; h != none && h != first; h = left(h)) ++seen;
      if (h == none)
        for (h = right(first); h != none; h = right(h)) ++seen;
      if (seen == faces.size()) continue;
      one[begin / kGrain] = 0;
      return;
    }
  });
  return std::find(one.begin(), one.end(), 0) == one.end();
}

// Which faces to turn round, so that joined faces agree and each piece keeps the winding of most of its area.
Vec<std::uint8_t> Repair::orient() const {
  Vec<std::uint8_t> flip(triangle_.size(), 2);  // 2: not reached
  Vec<Index> piece;
  StopNowAndThen stop(1 << 14);
  for (Index seed = 0; seed < triangle_.size(); ++seed) {
    if (flip[seed] != 2) continue;
    flip[seed] = 0;
    piece.assign(1, seed);
    double as_is = 0, turned = 0;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      stop();
      const Index f = piece[i];
      const auto [a, b, c] = triangle_[f];
      const double area = (position_[b] - position_[a]).cross(position_[c] - position_[a]).norm();
      (flip[f] ? turned : as_is) += area;
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index g = twin_[h] == none ? f : face_of(twin_[h]);
        if (flip[g] != 2) continue;
        flip[g] = flip[f] ^ static_cast<std::uint8_t>(same_way(h, twin_[h]));
        piece.push_back(g);
      }
    }
    if (turned > as_is)
      for (const Index f : piece) flip[f] ^= 1;
  }
  return flip;
}

// 0 if the faces at h and g are flat, 2 if one is folded onto the other. Of equal bends the convex one is less: bodies
// that touch along an edge come apart.
double Repair::bend(const Edge &ends, Index h, Index g) const {
  const Vec3 origin = position_[ends[0]], axis = (position_[ends[1]] - origin).normalized();
  const auto away = [&](Index side) -> Vec3 {
    const Vec3 d = position_[from(next_in_face(next_in_face(side)))] - origin;
    return (d - d.dot(axis) * axis).normalized();
  };
  const Vec3 a = away(h), b = away(g);
  return 1 + a.dot(b) + (axis.cross(a).dot(b) > 0 ? 1e-6 : 0);
}

void Repair::pair_smoothest(const Shared &s, std::span<const std::uint8_t> flip) {
  struct Pair {
    double bend;
    Index up, down;
    bool operator<(const Pair &o) const {
      return bend != o.bend ? bend < o.bend : up != o.up ? up < o.up : down < o.down;
    }
  };
  // More than this is no surface: all come apart (and all pairs of them would be too many to look at).
  if (s.side.size() > 32) return;
  const auto goes_up = [&](Index h) { return (from(h) == s.ends[0]) != (flip[face_of(h)] != 0); };
  Vec<Pair> pairs;
  for (const Index h : s.side)
    for (const Index g : s.side)
      if (goes_up(h) && !goes_up(g)) pairs.push_back({bend(s.ends, h, g), h, g});
  std::sort(pairs.begin(), pairs.end());
  for (const auto &[bend, up, down] : pairs)
    if (twin_[up] == none && twin_[down] == none) join(up, down);
}

void Repair::cut_misfits(std::span<const std::uint8_t> flip) {
  for (Index h = 0; h < twin_.size(); ++h) {
    const Index g = twin_[h];
    if (g == none || g < h) continue;
    const bool differ = flip[face_of(h)] != flip[face_of(g)];
    if (same_way(h, g) == differ) continue;
    part(h);
    shared_.push_back({{from(h), to(h)}, {h, g}});
    ++out_.unorientable_edges;
  }
}

void Repair::apply(Vec<std::uint8_t> flip) {
  if (std::ranges::find(flip, 1) == flip.end()) return;
  // a b c becomes a c b: side k of it becomes side 2 - k.
  const auto moved = [&](Index h) { return flip[face_of(h)] ? h + 2 - 2 * (h % 3) : h; };
  Vec<Index> twin(twin_.size(), none);
  for (Index h = 0; h < twin_.size(); ++h)
    if (twin_[h] != none) twin[moved(h)] = moved(twin_[h]);
  twin_ = std::move(twin);
  for (Shared &s : shared_)
    for (Index &h : s.side) h = moved(h);
  for (std::size_t f = 0; f < flip.size(); ++f)
    if (flip[f]) std::swap(triangle_[f][1], triangle_[f][2]);
  out_.flipped = std::move(flip);
}

// Gives each fan of faces a vertex of its own; the first keeps the number.
void Repair::split() {
  out_.triangle = triangle_;
  out_.copy_of.clear();
  out_.non_manifold_vertices = 0;
  Vec<std::uint8_t> fans(position_.size(), 0);
  Vec<std::uint8_t> done(twin_.size(), 0);
  const auto around = [&](Index corner, const auto &step, Index vertex) {
    for (Index h = corner; h != none && !done[h]; h = step(h)) done[h] = 1, out_.triangle[h / 3][h % 3] = vertex;
  };
  StopNowAndThen stop(1 << 16);
  for (Index h = 0; h < twin_.size(); ++h) {
    stop();
    if (done[h]) continue;
    Index v = from(h);
    if (fans[v]) {
      out_.non_manifold_vertices += fans[v] == 1;
      fans[v] = 2;
      out_.copy_of.push_back(v);
      v = static_cast<Index>(position_.size() + out_.copy_of.size() - 1);
    } else {
      fans[v] = 1;
    }
    around(
        h, [&](Index g) { return left(g); }, v);
    if (right(h) != none)
      around(
          right(h), [&](Index g) { return right(g); }, v);
  }
}

// Faces may still meet at an edge though they were not joined there, where both its ends hold them together by another
// way round (a pinched handle). Joined otherwise the first time, they mostly come apart; else they are torn off.
bool Repair::come_apart(bool first_time) {
  Vec<Side> group;
  Vec<std::span<const Side>> stuck;
  for (const Shared &s : shared_)
    for (const Index h : s.side) group.push_back({corner_vertices(h), h});
  std::sort(group.begin(), group.end());
  // One that cut_misfits cut is listed twice where more than two met there before.
  group.erase(
      std::unique(group.begin(), group.end(), [](const Side &a, const Side &b) { return a.halfedge == b.halfedge; }),
      group.end());
  for (std::size_t i = 0, j = 0; i < group.size(); i = j) {
    while (j < group.size() && group[j].ends == group[i].ends) ++j;
    if (j - i > 2 || (j - i == 2 && twin_[group[i].halfedge] != group[i + 1].halfedge))
      stuck.push_back({group.data() + i, j - i});
  }
  for (const std::span<const Side> sides : stuck) {
    if (first_time && pair_otherwise(sides)) continue;
    for (const Side &side : sides)
      for (Index k = 3 * face_of(side.halfedge), end = k + 3; k < end; ++k) part(k);
  }
  return !stuck.empty();
}

// The ends of a half-edge after splitting, smaller first.
Edge Repair::corner_vertices(Index h) const {
  const Index a = out_.triangle[h / 3][h % 3], b = out_.triangle[h / 3][next_in_face(h) % 3];
  return {std::min(a, b), std::max(a, b)};
}

bool Repair::pair_otherwise(std::span<const Side> sides) {
  Vec<Index> up, down;  // those that are joined first, in the same order
  for (const bool joined : {true, false})
    for (const auto &[ends, h] : sides) {
      if ((twin_[h] != none) != joined || from(h) != from(sides[0].halfedge)) continue;
      up.push_back(h);
      if (joined) down.push_back(twin_[h]);
    }
  for (const auto &[ends, h] : sides)
    if (twin_[h] == none && from(h) != from(sides[0].halfedge)) down.push_back(h);
  if (up.size() < down.size()) std::swap(up, down);
  if (down.empty() || up.size() < 2) return false;
  for (const Index h : up) part(h);
  for (const Index h : down) part(h);
  for (std::size_t i = 0; i < down.size(); ++i) join(down[i], up[(i + 1) % up.size()]);
  return true;
}

}  // namespace

Manifold make_manifold(std::span<const Vec3> position, Vec<Triangle> triangle, Rows vertex_faces,
                       const Executor &executor) {
  return Repair(position, std::move(triangle), std::move(vertex_faces), executor).run();
}

}  // namespace ts::mesh
