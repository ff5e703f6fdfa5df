#include "cut/region.h"

#include <algorithm>

namespace ts::cut {
namespace {

// Calls visit(g) for the faces across the edges of f.
void neighbours(const Surface &s, Index f, const auto &visit) {
  for (Index k = 0; k < 3; ++k)
    if (const Index t = s.twin[3 * f + k]; t != mesh::none) visit(mesh::face_of(t));
}

// Faces that fulfil `wanted`, reached over edges from those of them at a seed vertex.
Mask flood(const Surface &s, std::span<const Index> seeds, const auto &wanted) {
  Mask mask(s.faces(), 0);
  Vec<Index> stack;
  const auto enter = [&](Index f) {
    if (mask[f] || !wanted(f)) return;
    mask[f] = 1;
    stack.push_back(f);
  };
  for (const Index v : seeds)
    for (const Index f : s.vertex_faces[v]) enter(f);
  while (!stack.empty()) {
    const Index f = stack.back();
    stack.pop_back();
    neighbours(s, f, enter);
  }
  return mask;
}

bool on_rim(const Surface &s, Index f) {
  return s.twin[3 * f] == mesh::none || s.twin[3 * f + 1] == mesh::none || s.twin[3 * f + 2] == mesh::none;
}

}  // namespace

Mask grow(const Surface &surface, std::span<const double> phi, std::span<const Index> seeds) {
  return flood(surface, seeds, [&](Index f) {
    const auto &t = surface.triangle[f];
    return phi[t[0]] + phi[t[1]] + phi[t[2]] < 0;
  });
}

void keep_seeded(const Surface &surface, std::span<const Index> seeds, Mask &inside) {
  Mask kept = flood(surface, seeds, [&](Index f) { return inside[f] != 0; });
  inside.swap(kept);
}

void fill_holes(const Surface &surface, double area, std::span<const std::uint8_t> foreign, Mask &inside) {
  if (!(area > 0)) return;
  constexpr std::uint8_t kOpen = 2, kFlood = 3;  // known to be no hole; part of the set looked at
  Vec<Index> open, set;
  const auto enclosed_set = [&](Index start) {
    set.assign(1, start);
    inside[start] = kFlood;
    double sum = 0;
    bool enclosed = true;
    for (std::size_t i = 0; i < set.size() && enclosed; ++i) {
      const Index f = set[i];
      sum += surface.face_area[f];
      enclosed = sum <= area && !on_rim(surface, f);
      for (const Index v : surface.triangle[f]) enclosed = enclosed && !foreign[v];
      neighbours(surface, f, [&](Index next) {
        if (inside[next] == kOpen) enclosed = false;
        if (inside[next] != 0) return;
        inside[next] = kFlood;
        set.push_back(next);
      });
    }
    return enclosed;
  };
  for (Index f = 0; f < surface.faces(); ++f) {
    if (inside[f] != 1) continue;
    neighbours(surface, f, [&](Index start) {
      if (inside[start] != 0) return;
      const bool enclosed = enclosed_set(start);
      for (const Index g : set) inside[g] = enclosed ? 1 : kOpen;
      if (!enclosed) open.insert(open.end(), set.begin(), set.end());
    });
  }
  for (const Index f : open) inside[f] = 0;
}

Vec<Index> faces_of(const Mask &inside) {
  Vec<Index> faces;
  for (Index f = 0; f < inside.size(); ++f)
    if (inside[f]) faces.push_back(f);
  return faces;
}

Vec<Index> vertices_of(const Surface &surface, std::span<const Index> faces) {
  Vec<std::uint8_t> seen(surface.vertices(), 0);
  Vec<Index> vertices;
  for (const Index f : faces)
    for (const Index v : surface.triangle[f])
      if (!seen[v]) seen[v] = 1, vertices.push_back(v);
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

double area_of(const Surface &surface, std::span<const Index> faces) {
  double area = 0;
  for (const Index f : faces) area += surface.face_area[f];
  return area;
}

bool touches_border(const Surface &surface, std::span<const Index> faces) {
  return std::any_of(faces.begin(), faces.end(), [&](Index f) { return on_rim(surface, f); });
}

}  // namespace ts::cut
