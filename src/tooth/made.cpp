#include "tooth/made.h"

#include <algorithm>

#include "base/error.h"
#include "features/feature_set.h"
#include "tooth/pick.h"

namespace ts::tooth {
namespace {

// The vertices around a click that no node has, and `nearest`; ascending.
Vec<Index> disc_at(const Prepared &p, const mesh::SurfacePoint &at, Index nearest) {
  const mesh::Surface &s = *p.surface;
  geometry::PathStart starts[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const Index v = s.triangle[at.face][k];
    starts[k] = {v, (s.position[v] - at.position).norm(), 0};
  }
  Vec<Index> disc = {nearest};
  const auto space = p.space();
  for (const Index v : space->paths.within(
           starts, [&](Index e) { return p.relief->length[e]; }, p.options.seed_radius * p.lengthened))
    if (v != nearest && p.nodes.of_vertex[v] == mesh::none) disc.push_back(v);
  std::sort(disc.begin(), disc.end());
  return disc;
}

}  // namespace

std::shared_ptr<const Prepared> make_group(const Prepared &p, const mesh::SurfacePoint &at) {
  const mesh::Surface &s = *p.surface;
  const Index nearest = *std::ranges::min_element(s.triangle[at.face], {},
                                                  [&](Index v) { return (s.position[v] - at.position).squaredNorm(); });
  if (const Index there = p.nodes.of_vertex[nearest]; there != mesh::none) {
    if (p.nodes.group[there] == field::gingiva_group || p.outlier[there])
      throw Error(Fault::click_on_gingiva, "the click lies on gingiva for certain, or on a point that was freed");
    throw Error(Fault::no_cut, "the click lies on a constraint of a tooth that could not be cut around it");
  }

  auto made = std::make_shared<Prepared>(p);
  const Index group = made->groups++;
  Vec<Index> seeds = disc_at(p, at, nearest);
  const auto node = static_cast<Index>(made->nodes.size());
  for (const Index v : seeds) made->nodes.of_vertex[v] = node;
  made->nodes.vertices.item.insert(made->nodes.vertices.item.end(), seeds.begin(), seeds.end());
  made->nodes.vertices.start.push_back(static_cast<Index>(made->nodes.vertices.item.size()));
  made->nodes.group.push_back(group);
  made->nodes.point.push_back(static_cast<Index>(made->sites.point.size()));
  made->outlier.push_back(0);
  made->added.push_back(seeds);
  made->border = std::make_shared<const field::Border>(*made->solver, made->added);
  made->nodes.groups = made->groups;
  made->sites.point.push_back(nearest);
  made->sites.group.push_back(group);
  made->sites.groups = made->groups;
  made->group_at[nearest] = group;
  made->seeds.push_back(std::move(seeds));
  made->rejected.emplace_back();
  made->width.push_back(0);
  made->along.push_back(Vec3::Zero());

  Vec<Vec3> row;
  for (const Index g : p.live) row.push_back(centre_of(p, g));
  made->live.insert(made->live.begin() + static_cast<std::ptrdiff_t>(features::place_in_row(row, at.position)), group);
  return made;
}

}  // namespace ts::tooth
