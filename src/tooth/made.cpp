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

// A copy in which the disc around the click is a node of `group`, which may be the next.
std::shared_ptr<Prepared> with_node(const Prepared &p, const mesh::SurfacePoint &at, Index group) {
  const mesh::Surface &s = *p.surface;
  const Index nearest = *std::ranges::min_element(s.triangle[at.face], {},
                                                  [&](Index v) { return (s.position[v] - at.position).squaredNorm(); });
  if (const Index there = p.nodes.of_vertex[nearest]; there != mesh::none) {
    if (p.nodes.group[there] == field::gingiva_group || p.outlier[there])
      throw Error(Fault::click_on_gingiva, "the click lies on gingiva for certain, or on a point that was freed");
    throw Error(Fault::no_cut, "the click lies on a constraint of a tooth that could not be cut around it");
  }

  auto made = std::make_shared<Prepared>(p);
  const Vec<Index> disc = disc_at(p, at, nearest);
  const auto node = static_cast<Index>(made->nodes.size());
  for (const Index v : disc) made->nodes.of_vertex[v] = node;
  made->nodes.vertices.item.insert(made->nodes.vertices.item.end(), disc.begin(), disc.end());
  made->nodes.vertices.start.push_back(static_cast<Index>(made->nodes.vertices.item.size()));
  made->nodes.group.push_back(group);
  made->nodes.point.push_back(static_cast<Index>(made->sites.point.size()));
  made->outlier.push_back(0);
  made->added.push_back(disc);
  made->border = std::make_shared<const field::Border>(*made->solver, made->added);
  made->sites.point.push_back(nearest);
  made->sites.group.push_back(group);
  made->group_at[nearest] = group;
  if (group == made->groups) {
    ++made->groups;
    made->seeds.emplace_back();
    made->rejected.emplace_back();
    made->width.push_back(0);
    made->along.push_back(Vec3::Zero());
    made->nodes.groups = made->sites.groups = made->groups;
  }
  Vec<Index> &seeds = made->seeds[group];
  const auto middle = seeds.insert(seeds.end(), disc.begin(), disc.end());
  std::inplace_merge(seeds.begin(), middle, seeds.end());
  return made;
}

}  // namespace

std::shared_ptr<const Prepared> make_group(const Prepared &p, const mesh::SurfacePoint &at) {
  const std::shared_ptr<Prepared> made = with_node(p, at, p.groups);
  Vec<Vec3> row;
  for (const Index g : p.live) row.push_back(centre_of(p, g));
  made->live.insert(made->live.begin() + static_cast<std::ptrdiff_t>(features::place_in_row(row, at.position)), p.groups);
  return made;
}

std::shared_ptr<const Prepared> extend_group(const Prepared &p, const mesh::SurfacePoint &at, Index group) {
  return with_node(p, at, group);
}

}  // namespace ts::tooth
