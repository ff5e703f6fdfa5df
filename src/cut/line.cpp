#include "cut/line.h"

#include <algorithm>
#include <cmath>

#include "cut/contour.h"
#include "geometry/paths.h"

namespace ts::cut {
namespace {

// psi: -1 inside and 1 outside; at the border the area-weighted mean over the faces of the vertex. Gives the vertices
// where it is between.
Vec<geometry::PathStart> set_sides(const Surface &s, Space &space) {
  Vec<geometry::PathStart> mixed;
  for (const Index f : space.inside.touched()) {
    if (!space.inside[f]) continue;
    for (const Index v : s.triangle[f]) {
      if (space.level[v] != 1) continue;
      double in = 0, out = 0;
      for (const Index g : s.vertex_faces[v]) (space.inside[g] ? in : out) += s.face_area[g];
      space.level.set(v, out > 0 ? (out - in) / (out + in) : -1);
      if (out > 0) mixed.push_back({v});
    }
  }
  return mixed;
}

}  // namespace

void smooth_psi(const Surface &s, std::span<const double> cotangent, double radius, std::span<const Index> near,
                std::span<const Through> through, Space &space) {
  const std::size_t n = near.size();
  const double r2 = radius * radius;
  SparseArray<double> &psi = space.level;
  SparseArray<Index> &place = space.place;
  for (Index i = 0; i < n; ++i) place.set(near[i], i);
  struct Link {
    Index to;
    double weight;
  };
  Vec<std::size_t> start(n + 1, 0);
  Vec<Link> link;
  Vec<double> diagonal(n), right(n), x(n), residual(n), z(n), p(n), ap(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Index v = near[i];
    diagonal[i] = s.vertex_area[v];
    right[i] = s.vertex_area[v] * psi[v];
    for (const Index e : s.vertex_edges[v]) {
      const double w = r2 * cotangent[e];
      const Index other = s.other_end(e, v);
      diagonal[i] += w;
      if (place[other] == mesh::none)
        right[i] += w * psi[other];
      else
        link.push_back({place[other], w});
    }
    start[i + 1] = link.size();
    x[i] = psi[v];
  }
  // psi^2 at the points that the line is to pass through, weighed so that a hundredth of what would be off stays off.
  constexpr double kPull = 100;
  struct Pull {
    Index at[3];
    double weight[3], strength;
  };
  Vec<Pull> pulls;
  for (const Through &t : through) {
    Pull pull{{}, {t.weight[0], t.weight[1], t.weight[2]}, 0};
    bool free = true;
    for (std::size_t k = 0; k < 3; ++k) {
      pull.at[k] = place[s.triangle[t.face][k]];
      free = free && pull.at[k] != mesh::none;
    }
    if (!free) continue;  // beside what is held: that decides
    for (const Index v : pull.at) pull.strength = std::max(pull.strength, kPull * diagonal[v]);
    pulls.push_back(pull);
  }
  place.clear();
  Vec<double> scale = diagonal;
  for (const Pull &pull : pulls)
    for (std::size_t k = 0; k < 3; ++k) scale[pull.at[k]] += pull.strength * pull.weight[k] * pull.weight[k];
  const auto product = [&](const Vec<double> &a, Vec<double> &b) {
    for (std::size_t i = 0; i < n; ++i) {
      double sum = 0;
      for (std::size_t k = start[i]; k < start[i + 1]; ++k) sum += link[k].weight * a[link[k].to];
      b[i] = diagonal[i] * a[i] - sum;
    }
    for (const Pull &pull : pulls) {
      double value = 0;
      for (std::size_t k = 0; k < 3; ++k) value += pull.weight[k] * a[pull.at[k]];
      for (std::size_t k = 0; k < 3; ++k) b[pull.at[k]] += pull.strength * pull.weight[k] * value;
    }
  };
  product(x, ap);
  double rho = 0;
  for (std::size_t i = 0; i < n; ++i) {
    residual[i] = right[i] - ap[i];
    p[i] = z[i] = scale[i] > 0 ? residual[i] / scale[i] : 0;
    rho += residual[i] * z[i];
  }
  const double goal = rho * 1e-10;
  for (int step = 0; step < 300 && rho > goal; ++step) {
    product(p, ap);
    double pap = 0, next = 0;
    for (std::size_t i = 0; i < n; ++i) pap += p[i] * ap[i];
    if (!(pap > 0)) break;
    for (std::size_t i = 0; i < n; ++i) {
      x[i] += rho / pap * p[i];
      residual[i] -= rho / pap * ap[i];
      z[i] = scale[i] > 0 ? residual[i] / scale[i] : 0;
      next += residual[i] * z[i];
    }
    for (std::size_t i = 0; i < n; ++i) p[i] = z[i] + next / rho * p[i];
    rho = next;
  }
  for (std::size_t i = 0; i < n; ++i) psi.set(near[i], x[i]);
}

double drop_unreached(const Surface &s, std::span<const Index> near, bool negative, std::span<const Index> start,
                      Space &space) {
  constexpr double kFlip = 1e-3;
  constexpr std::uint8_t kBeyond = 0, kNear = 1, kSeen = 2;
  SparseArray<double> &psi = space.level;
  SparseArray<std::uint8_t> &state = space.marks;
  for (const Index v : near) state.set(v, kNear);
  const auto on_side = [&](Index v) { return (psi[v] < 0) == negative; };
  Vec<Index> stack;
  const auto enter = [&](Index v) {
    if (state[v] != kNear || !on_side(v)) return;
    state.set(v, kSeen);
    stack.push_back(v);
  };
  for (const Index v : start) enter(v);
  for (const Index v : near)
    for (const Index e : s.vertex_edges[v])
      if (const Index w = s.other_end(e, v); state[w] == kBeyond && on_side(w)) enter(v);
  while (!stack.empty()) {
    const Index v = stack.back();
    stack.pop_back();
    for (const Index e : s.vertex_edges[v]) enter(s.other_end(e, v));
  }
  double area = 0;
  for (const Index v : near)
    if (state[v] == kNear && on_side(v)) {
      psi.set(v, negative ? kFlip : -kFlip);
      area += s.vertex_area[v];
    }
  state.clear();
  return area;
}

Vec<Polyline> smooth_line(const Surface &surface, std::span<const double> length, std::span<const double> cotangent,
                          double radius, std::span<const Index> seeds, Space &space) {
  const Vec<geometry::PathStart> mixed = set_sides(surface, space);
  // Two rings at least, so that the line cannot leave what is looked at.
  const std::span<const Index> reached = space.paths.within(
      mixed, [&](Index e) { return length[e]; }, std::max(4 * radius, 2 * surface.mean_edge));
  Vec<Index> near(reached.begin(), reached.end());
  std::sort(near.begin(), near.end());
  Vec<Index> around, outer;
  for (const Index v : near) {
    for (const Index f : surface.vertex_faces[v])
      if (!space.faces[f]) space.faces.set(f, 1), around.push_back(f);
    if (space.level[v] == 1) outer.push_back(v);
  }
  space.faces.clear();
  std::sort(around.begin(), around.end());
  if (radius > 0) smooth_psi(surface, cotangent, radius, near, {}, space);
  drop_unreached(surface, near, true, seeds, space);
  drop_unreached(surface, near, false, outer, space);
  Vec<Polyline> lines = contour(
      surface, [&](Index v) { return space.level[v]; }, 0, around);
  space.level.clear();
  std::stable_sort(lines.begin(), lines.end(),
                   [](const Polyline &a, const Polyline &b) { return a.length > b.length; });
  return lines;
}

}  // namespace ts::cut
