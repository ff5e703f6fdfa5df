#include "cut/region.h"

#include <algorithm>

namespace ts::cut {
namespace {

// Calls visit(g) for the faces across the edges of f.
void neighbours(const Surface &s, Index f, const auto &visit) {
  for (Index k = 0; k < 3; ++k)
    if (const Index t = s.twin[3 * f + k]; t != mesh::none) visit(mesh::face_of(t));
}

bool on_rim(const Surface &s, Index f) {
  return s.twin[3 * f] == mesh::none || s.twin[3 * f + 1] == mesh::none || s.twin[3 * f + 2] == mesh::none;
}

}  // namespace

Growth::Growth(const Surface &surface, Values phi, std::span<const Index> seeds, Mask &inside)
    : surface_(surface), phi_(phi), inside_(inside) {
  for (const Index v : seeds)
    for (const Index f : surface.vertex_faces[v]) beside_.push_back(f);
}

void Growth::rise(double level) {
  const auto enter = [&](Index f) {
    if (inside_[f]) return;
    const auto &t = surface_.triangle[f];
    const double a = phi_(t[0]) - level, b = phi_(t[1]) - level, c = phi_(t[2]) - level;
    if (!(a + b + c < 0)) {
      beside_.push_back(f);
      return;
    }
    inside_.set(f, 1);
    area_ += surface_.face_area[f];
    stack_.push_back(f);
    if (!(a < 0 && b < 0 && c < 0)) mixed_.push_back(f);
  };
  Vec<Index> waiting;
  waiting.swap(beside_);
  std::erase_if(mixed_, [&](Index f) {
    const auto &t = surface_.triangle[f];
    return phi_(t[0]) - level < 0 && phi_(t[1]) - level < 0 && phi_(t[2]) - level < 0;
  });
  for (const Index f : waiting) {
    enter(f);
    while (!stack_.empty()) {
      const Index g = stack_.back();
      stack_.pop_back();
      neighbours(surface_, g, enter);
    }
  }
  std::erase_if(beside_, [&](Index f) { return inside_[f] != 0; });
}

void keep_seeded(const Surface &surface, std::span<const Index> seeds, Mask &inside) {
  constexpr std::uint8_t kSeen = 2;
  Vec<Index> stack;
  const auto enter = [&](Index f) {
    if (inside[f] != 1) return;
    inside.set(f, kSeen);
    stack.push_back(f);
  };
  for (const Index v : seeds)
    for (const Index f : surface.vertex_faces[v]) enter(f);
  while (!stack.empty()) {
    const Index f = stack.back();
    stack.pop_back();
    neighbours(surface, f, enter);
  }
  for (const Index f : inside.touched())
    if (inside[f] == 1) inside.set(f, 0);
  for (const Index f : inside.touched())
    if (inside[f] == kSeen) inside.set(f, 1);
}

Vec<Index> fill_holes(const Surface &surface, double area, Kinds foreign, std::span<const Index> beside, Mask &inside) {
  Vec<Index> filled;
  if (!(area > 0)) return filled;
  constexpr std::uint8_t kOpen = 2, kFlood = 3;  // known to be no hole; part of the set looked at
  Vec<Index> open, set;
  const auto enclosed_set = [&](Index start) {
    set.assign(1, start);
    inside.set(start, kFlood);
    double sum = 0;
    bool enclosed = true;
    for (std::size_t i = 0; i < set.size() && enclosed; ++i) {
      const Index f = set[i];
      sum += surface.face_area[f];
      enclosed = sum <= area && !on_rim(surface, f);
      for (const Index v : surface.triangle[f]) enclosed = enclosed && !foreign(v);
      neighbours(surface, f, [&](Index next) {
        if (inside[next] == kOpen) enclosed = false;
        if (inside[next] != 0) return;
        inside.set(next, kFlood);
        set.push_back(next);
      });
    }
    return enclosed;
  };
  // What lies outside along a loop of the border hangs together over edges, around the vertices of the loop: none of it
  // has to be looked at again.
  const auto open_along = [&](Index face) {
    for (Index k = 0; k < 3; ++k) {
      const auto is_border = [&](Index h) {
        return surface.twin[h] != mesh::none && inside[mesh::face_of(surface.twin[h])] == 1;
      };
      const Index first = 3 * face + k;
      if (!is_border(first)) continue;
      Index h = first;
      do {
        if (const Index f = mesh::face_of(h); inside[f] == 0) inside.set(f, kOpen), open.push_back(f);
        for (h = mesh::next_in_face(h); h != mesh::none && !is_border(h);)
          h = surface.twin[h] == mesh::none ? mesh::none : mesh::next_in_face(surface.twin[h]);
      } while (h != mesh::none && h != first);  // none: a border of the scan
    }
  };
  for (const Index start : beside) {
    if (inside[start] != 0) continue;
    const bool enclosed = enclosed_set(start);
    for (const Index g : set) inside.set(g, enclosed ? 1 : kOpen);
    Vec<Index> &to = enclosed ? filled : open;
    to.insert(to.end(), set.begin(), set.end());
    if (!enclosed) open_along(start);
  }
  for (const Index f : open) inside.set(f, 0);
  return filled;
}

Vec<Index> faces_of(const Mask &inside) {
  return inside.ascending();
}

Vec<Index> beside(const Surface &surface, const Mask &inside) {
  Vec<Index> faces;
  for (const Index f : inside.touched())
    if (inside[f])
      neighbours(surface, f, [&](Index g) {
        if (!inside[g]) faces.push_back(g);
      });
  return faces;
}

Vec<Index> vertices_of(const Surface &surface, std::span<const Index> faces, Space &space) {
  for (const Index f : faces)
    for (const Index v : surface.triangle[f])
      if (!space.marks[v]) space.marks.set(v, 1);
  Vec<Index> vertices = space.marks.ascending();
  space.marks.clear();
  return vertices;
}

double area_of(const Surface &surface, std::span<const Index> faces) {
  double area = 0;
  for (const Index f : faces) area += surface.face_area[f];
  return area;
}

}  // namespace ts::cut
