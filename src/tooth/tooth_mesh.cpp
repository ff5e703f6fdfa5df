#include "tooth/tooth_mesh.h"

#include <algorithm>

#include "geometry/normals.h"

namespace ts::tooth {
namespace {

// Gives each fan of triangles around a vertex but the first a vertex of its own.
void part_fans(PartMesh &part, const mesh::Surface &s) {
  Vec<std::uint8_t> met(part.position.size(), 0), done(3 * part.triangle.size(), 0);
  for (Index h = 0; h < done.size(); ++h) {
    if (done[h]) continue;
    const Index v = s.from(h);
    Index id = v;
    if (met[v]) {
      id = static_cast<Index>(part.position.size());
      const Vec3 position = part.position[v];
      const std::uint8_t flag = part.flag[v];
      part.position.push_back(position);
      part.flag.push_back(flag);
    }
    met[v] = 1;
    // Back to where the fan begins, if it does, then round.
    Index start = h;
    const auto before = [&](Index g) { return g % 3 == 0 ? g + 2 : g - 1; };
    for (Index g = s.twin[h]; g != mesh::none; g = s.twin[start]) {
      g = mesh::next_in_face(g);
      start = g;
      if (start == h) break;
    }
    for (Index g = start;;) {
      done[g] = 1;
      part.triangle[g / 3][g % 3] = id;
      const Index t = s.twin[before(g)];
      if (t == mesh::none || t == start) break;
      g = t;
    }
  }
}

}  // namespace

PartMesh part_of(const Partition &p, Index owner, bool inside_out, const Executor &executor) {
  // Each vertex: whether it is of this part, and of another.
  Vec<std::uint8_t> own(p.position.size(), 0), shared(p.position.size(), 0);
  for (std::size_t i = 0; i < p.triangle.size(); ++i)
    for (const Index v : p.triangle[i]) (p.owner[i] == owner ? own : shared)[v] = 1;
  PartMesh part;
  Vec<Index> place(p.position.size(), mesh::none);
  for (Index v = 0; v < own.size(); ++v) {
    if (!own[v]) continue;
    place[v] = static_cast<Index>(part.position.size());
    part.position.push_back(p.position[v]);
    part.flag.push_back(shared[v] ? VertexFlag::on_cut : 0);
  }
  for (std::size_t i = 0; i < p.triangle.size(); ++i) {
    if (p.owner[i] != owner) continue;
    Triangle t = {place[p.triangle[i][0]], place[p.triangle[i][1]], place[p.triangle[i][2]]};
    if (inside_out) std::swap(t[1], t[2]);
    part.triangle.push_back(t);
    part.source.push_back(p.face[i]);
  }
  if (part.triangle.empty()) throw Error(Fault::no_cut, "nothing of the scan is left for it beside the other teeth");
  const mesh::Surface s = mesh::make_surface(part.position, part.triangle, executor);
  for (Index v = 0; v < part.position.size(); ++v)
    if (s.on_boundary[v] && !part.flag[v]) part.flag[v] = VertexFlag::on_rim;
  part_fans(part, s);
  measure(part, executor);
  return part;
}

void take_off(PartMesh &part, std::span<const Index> triangles, const Executor &executor) {
  Vec<std::uint8_t> off(part.triangle.size(), 0);
  for (const Index f : triangles) off[f] = 1;
  const auto kept = [&](const Vec<Triangle> &all) {
    Vec<Triangle> left;
    for (std::size_t f = 0; f < all.size(); ++f)
      if (!off[f]) left.push_back(all[f]);
    return left;
  };
  const mesh::Surface left = mesh::make_surface(part.position, kept(part.triangle), executor);
  Vec<double> area(left.components, 0);
  for (Index f = 0; f < left.faces(); ++f) area[left.component[f]] += left.face_area[f];
  for (Index f = 0, k = 0; f < part.triangle.size(); ++f)
    if (!off[f] && area[left.component[k++]] < 0.01 * left.area) off[f] = 1;
  PartMesh next;
  next.trimmed = part.trimmed;
  Vec<Index> place(part.position.size(), mesh::none);
  for (std::size_t f = 0; f < part.triangle.size(); ++f) {
    if (off[f]) {
      ++next.trimmed;
      continue;
    }
    Triangle t = part.triangle[f];
    for (Index &v : t) {
      if (place[v] == mesh::none) {
        place[v] = static_cast<Index>(next.position.size());
        next.position.push_back(part.position[v]);
        next.flag.push_back(part.flag[v]);
      }
      v = place[v];
    }
    next.triangle.push_back(t);
    next.source.push_back(part.source[f]);
  }
  part_fans(next, mesh::make_surface(next.position, next.triangle, executor));
  measure(next, executor);
  part = std::move(next);
}

void measure(PartMesh &part, const Executor &executor) {
  const mesh::Surface s = mesh::make_surface(part.position, part.triangle, executor);
  part.normal = geometry::vertex_normals(s, geometry::NormalWeight::angle, executor);
  part.loops = static_cast<Index>(s.boundary.size());
  part.components = s.components;
  part.area = s.area;
  part.fill_area = part.volume = 0;
  for (Index f = 0; f < s.faces(); ++f)
    if (part.source[f] == mesh::none) part.fill_area += s.face_area[f];
  if (part.loops || part.triangle.empty()) return;
  const Vec3 origin = part.position[0];  // near it nothing cancels out
  for (const auto &[a, b, c] : part.triangle)
    part.volume += (part.position[a] - origin).dot((part.position[b] - origin).cross(part.position[c] - origin)) / 6;
}

}  // namespace ts::tooth
