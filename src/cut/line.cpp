#include "cut/line.h"

#include <algorithm>
#include <cmath>

#include "cut/contour.h"
#include "geometry/paths.h"

namespace ts::cut {
namespace {

// Area-weighted mean of -1 (inside) and 1 over the faces of each vertex.
Vec<double> sides(const Surface &s, const Mask &inside) {
  Vec<double> psi(s.vertices(), 1);
  for (Index v = 0; v < s.vertices(); ++v) {
    double area = 0, sum = 0;
    for (const Index f : s.vertex_faces[v]) {
      area += s.face_area[f];
      sum += inside[f] ? -s.face_area[f] : s.face_area[f];
    }
    if (area > 0) psi[v] = sum / area;
  }
  return psi;
}

Vec<Index> near_border(const Surface &s, const Vec<double> &psi, double width) {
  Vec<geometry::PathStart> mixed;
  for (Index v = 0; v < s.vertices(); ++v)
    if (std::abs(psi[v]) < 1) mixed.push_back({v});
  Vec<Index> near;
  geometry::PathFinder(s).search(
      mixed, [&](Index e) { return s.edge_length(e); },
      [&](Index v, double d, Index) {
        if (d > width) return false;
        near.push_back(v);
        return true;
      });
  std::sort(near.begin(), near.end());
  return near;
}

// Conjugate gradients on the vertices `near`; psi is held elsewhere.
void smooth_near(const Surface &s, std::span<const double> cotangent, double radius, const Vec<Index> &near,
                 Vec<double> &psi) {
  const std::size_t n = near.size();
  const double r2 = radius * radius;
  Vec<Index> place(s.vertices(), mesh::none);
  for (Index i = 0; i < n; ++i) place[near[i]] = i;
  Vec<double> diagonal(n), right(n), x(n), residual(n), z(n), p(n), ap(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Index v = near[i];
    diagonal[i] = s.vertex_area[v];
    right[i] = s.vertex_area[v] * psi[v];
    for (const Index e : s.vertex_edges[v]) {
      diagonal[i] += r2 * cotangent[e];
      if (const Index w = s.other_end(e, v); place[w] == mesh::none) right[i] += r2 * cotangent[e] * psi[w];
    }
    x[i] = psi[v];
  }
  const auto product = [&](const Vec<double> &a, Vec<double> &b) {
    for (std::size_t i = 0; i < n; ++i) {
      double sum = 0;
      for (const Index e : s.vertex_edges[near[i]])
        if (const Index j = place[s.other_end(e, near[i])]; j != mesh::none) sum += cotangent[e] * a[j];
      b[i] = diagonal[i] * a[i] - r2 * sum;
    }
  };
  product(x, ap);
  double rho = 0;
  for (std::size_t i = 0; i < n; ++i) {
    residual[i] = right[i] - ap[i];
    p[i] = z[i] = diagonal[i] > 0 ? residual[i] / diagonal[i] : 0;
    rho += residual[i] * z[i];
  }
  const double goal = rho * 1e-14;
  for (int step = 0; step < 300 && rho > goal; ++step) {
    product(p, ap);
    double pap = 0, next = 0;
    for (std::size_t i = 0; i < n; ++i) pap += p[i] * ap[i];
    if (!(pap > 0)) break;
    for (std::size_t i = 0; i < n; ++i) {
      x[i] += rho / pap * p[i];
      residual[i] -= rho / pap * ap[i];
      z[i] = diagonal[i] > 0 ? residual[i] / diagonal[i] : 0;
      next += residual[i] * z[i];
    }
    for (std::size_t i = 0; i < n; ++i) p[i] = z[i] + next / rho * p[i];
    rho = next;
  }
  for (std::size_t i = 0; i < n; ++i) psi[near[i]] = x[i];
}

// Vertices of `side` that `start` reaches over edges of that side.
Vec<std::uint8_t> reached(const Surface &s, const Vec<double> &psi, bool negative, Vec<Index> stack) {
  Vec<std::uint8_t> seen(s.vertices(), 0);
  std::erase_if(stack, [&](Index v) { return (psi[v] < 0) != negative; });
  for (const Index v : stack) seen[v] = 1;
  while (!stack.empty()) {
    const Index v = stack.back();
    stack.pop_back();
    for (const Index e : s.vertex_edges[v]) {
      const Index w = s.other_end(e, v);
      if (seen[w] || (psi[w] < 0) != negative) continue;
      seen[w] = 1;
      stack.push_back(w);
    }
  }
  return seen;
}

}  // namespace

Vec<Polyline> smooth_line(const Surface &surface, std::span<const double> cotangent, const Mask &inside, double radius,
                          std::span<const Index> seeds) {
  constexpr double kFlip = 1e-3;  // turned over, just
  Vec<double> psi = sides(surface, inside);
  Vec<Index> far;  // vertices wholly outside
  for (Index v = 0; v < surface.vertices(); ++v)
    if (psi[v] == 1) far.push_back(v);
  const Vec<Index> near = near_border(surface, psi, std::max(6 * radius, 2 * surface.mean_edge));
  if (radius > 0) smooth_near(surface, cotangent, radius, near, psi);
  const Vec<std::uint8_t> ours = reached(surface, psi, true, Vec<Index>(seeds.begin(), seeds.end()));
  for (Index v = 0; v < surface.vertices(); ++v)
    if (psi[v] < 0 && !ours[v]) psi[v] = kFlip;
  const Vec<std::uint8_t> theirs = reached(surface, psi, false, far);
  for (const Index v : near)
    if (psi[v] >= 0 && !theirs[v]) psi[v] = -kFlip;
  Vec<Polyline> lines = contour(surface, psi, 0);
  std::stable_sort(lines.begin(), lines.end(),
                   [](const Polyline &a, const Polyline &b) { return a.length > b.length; });
  return lines;
}

}  // namespace ts::cut
