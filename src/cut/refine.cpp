#include "cut/refine.h"

#include <algorithm>
#include <cmath>

#include "geometry/paths.h"

namespace ts::cut {
namespace {

// Least and steepness of the seam's price, 1/mm, and weight of staying: experiments on labelled scans, flat around
// (half and twice of each change the mean IoU by less than .002).
constexpr double kSeamLeast = 0.02, kSeamScale = 0.5, kStay = 0.07;
constexpr double kNever = 1e6;

// Faces all of whose vertices are within `width` of the border of the region. Their phi and 1 + kind are left in
// space.level and space.marks.
Vec<Index> band_of(const Surface &s, Values phi, Kinds fixed, std::span<const double> length, double width,
                   Space &space) {
  const Mask &inside = space.inside;
  Vec<geometry::PathStart> border;
  for (const Index f : inside.touched()) {
    if (!inside[f]) continue;
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      if (s.twin[h] == mesh::none || inside[mesh::face_of(s.twin[h])]) continue;
      border.push_back({s.from(h)});
      border.push_back({s.to(h)});
    }
  }
  Vec<Index> faces;
  for (const Index v : space.paths.within(
           border, [&](Index e) { return length[e]; }, width)) {
    space.marks.set(v, static_cast<std::uint8_t>(1 + fixed(v)));
    space.level.set(v, phi(v));
    for (const Index f : s.vertex_faces[v]) {  // complete with its last corner
      const auto &t = s.triangle[f];
      if (space.marks[t[0]] && space.marks[t[1]] && space.marks[t[2]]) faces.push_back(f);
    }
  }
  return faces;
}

}  // namespace

Vec<double> seams(const Surface &surface, std::span<const double> at_vertex, std::span<const double> at_edge) {
  Vec<double> seam(at_edge.begin(), at_edge.end());
  for (Index e = 0; e < seam.size(); ++e)
    seam[e] += (at_vertex[surface.edge[e][0]] + at_vertex[surface.edge[e][1]]) / 4;
  return seam;
}

Vec<double> prices(std::span<const double> length, std::span<const double> seam) {
  Vec<double> price(length.size());
  for (std::size_t e = 0; e < price.size(); ++e) {
    const double c = seam[e] / kSeamScale;
    price[e] = length[e] * (kSeamLeast + (1 - kSeamLeast) / (1 + c * c));
  }
  return price;
}

void refine(const Surface &surface, Values phi, std::span<const double> length, std::span<const double> price,
            Kinds fixed, const RefineOptions &options, Space &space) {
  Mask &inside = space.inside;
  const Vec<Index> band = band_of(surface, phi, fixed, length, options.band, space);
  for (Index i = 0; i < band.size(); ++i) space.place.set(band[i], i);
  MaxFlow &flow = space.flow;
  flow.reset(band.size());
  for (Index i = 0; i < band.size(); ++i) {
    const Index f = band[i];
    const auto &t = surface.triangle[f];
    const double sum = space.level[t[0]] + space.level[t[1]] + space.level[t[2]];
    const double stay = kStay * std::abs(sum) / 3 * surface.face_area[f];
    double in = inside[f] ? stay : 0, out = inside[f] ? 0 : stay;
    if (!std::isfinite(stay)) in = 0, out = kNever;
    for (const Index v : t) {
      const int kind = space.marks[v] - 1;
      if (kind == 1) in += kNever;
      if (kind == 2) out += kNever;
    }
    for (Index k = 0; k < 3; ++k) {
      const Index h = 3 * f + k;
      if (surface.twin[h] == mesh::none) continue;
      const Index g = mesh::face_of(surface.twin[h]), j = space.place[g];
      if (j != mesh::none && i >= j) continue;
      const double cost = price[surface.edge_of[h]];
      if (j == mesh::none)
        (inside[g] ? in : out) += cost;  // what is beyond the band stays as it is
      else
        flow.add_edge(i, j, cost, cost);
    }
    flow.add_terminals(i, in, out);
  }
  space.place.clear();
  space.marks.clear();
  space.level.clear();
  flow.solve();
  for (Index i = 0; i < band.size(); ++i)
    if (const bool in = flow.with_source(i); in != (inside[band[i]] != 0)) inside.set(band[i], in);
}

}  // namespace ts::cut
