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

void put(Vec<Index> &sorted, std::span<const Index> items) {
  const auto middle = sorted.insert(sorted.end(), items.begin(), items.end());
  std::inplace_merge(sorted.begin(), middle, sorted.end());
}

bool has_point(const Prepared &p, Index group) {
  for (Index n = 0; n < p.nodes.size(); ++n)
    if (p.nodes.group[n] == group && !p.outlier[n]) return true;
  return false;
}

// Along the arch as long as it has a point in use.
void settle_in_row(Prepared &p, Index group) {
  const auto there = std::ranges::find(p.live, group);
  const bool is = there != p.live.end(), ought = has_point(p, group);
  if (is && !ought) p.live.erase(there);
  if (is || !ought) return;
  Vec<Vec3> row;
  for (const Index g : p.live) row.push_back(centre_of(p, g));
  p.live.insert(p.live.begin() + static_cast<std::ptrdiff_t>(features::place_in_row(row, centre_of(p, group))), group);
}

// A node in use, or not, for its group.
void take_up(Prepared &p, Index node) {
  const Index group = p.nodes.group[node];
  p.group_at[p.sites.point[p.nodes.point[node]]] = group;
  put(p.seeds[group], p.nodes.vertices[node]);
  settle_in_row(p, group);
}
void put_down(Prepared &p, Index node) {
  const Index group = p.nodes.group[node];
  p.group_at[p.sites.point[p.nodes.point[node]]] = mesh::none;
  std::erase_if(p.seeds[group], [&](Index v) { return p.nodes.of_vertex[v] == node; });
}

}  // namespace

Index add_group(Prepared &p) {
  const Index group = p.groups++;
  p.seeds.emplace_back();
  p.rejected.emplace_back();
  p.width.push_back(0);
  p.along.push_back(Vec3::Zero());
  p.nodes.groups = p.sites.groups = p.groups;
  return group;
}

void add_node(Prepared &p, const mesh::SurfacePoint &at, Index group) {
  const mesh::Surface &s = *p.surface;
  const Index nearest = *std::ranges::min_element(s.triangle[at.face], {},
                                                  [&](Index v) { return (s.position[v] - at.position).squaredNorm(); });
  if (const Index there = p.nodes.of_vertex[nearest]; there != mesh::none) {
    if (p.nodes.group[there] == field::gingiva_group || p.outlier[there])
      throw Error(Fault::click_on_gingiva, "the click lies on gingiva for certain, or on a point that was freed");
    throw Error(Fault::no_cut, "the click lies on a constraint of a tooth that could not be cut around it");
  }
  if (p.solver->factor().place(nearest) == mesh::none)
    throw Error(Fault::click_on_gingiva, "the point is on a piece of the surface without feature points");
  const Vec<Index> disc = disc_at(p, at, nearest);
  const auto node = static_cast<Index>(p.nodes.size());
  for (const Index v : disc) p.nodes.of_vertex[v] = node;
  p.nodes.vertices.item.insert(p.nodes.vertices.item.end(), disc.begin(), disc.end());
  p.nodes.vertices.start.push_back(static_cast<Index>(p.nodes.vertices.item.size()));
  p.nodes.group.push_back(group);
  p.outlier.push_back(0);
  p.added.push_back(disc);
  if (group == field::gingiva_group) {
    p.nodes.point.push_back(mesh::none);
    return;
  }
  p.nodes.point.push_back(static_cast<Index>(p.sites.point.size()));
  p.sites.point.push_back(nearest);
  p.sites.group.push_back(group);
  take_up(p, node);
}

void hold_added(Prepared &p) {
  p.border = std::make_shared<const field::Border>(*p.solver, p.added, *p.executor);
}

void regroup(Prepared &p, Index node, Index group) {
  const Index old = p.nodes.group[node];
  if (!p.outlier[node]) put_down(p, node);
  p.nodes.group[node] = group;
  p.sites.group[p.nodes.point[node]] = group;
  if (!p.outlier[node]) take_up(p, node);
  settle_in_row(p, old);
}

void let_go(Prepared &p, Index node) {
  put_down(p, node);
  p.outlier[node] = 1;
  settle_in_row(p, p.nodes.group[node]);
}

void hold(Prepared &p, Index node) {
  p.outlier[node] = 0;
  take_up(p, node);
}

std::shared_ptr<const Prepared> make_group(const Prepared &p, const mesh::SurfacePoint &at) {
  auto made = std::make_shared<Prepared>(p);
  const Index group = add_group(*made);
  add_node(*made, at, group);
  hold_added(*made);
  return made;
}

std::shared_ptr<const Prepared> extend_group(const Prepared &p, const mesh::SurfacePoint &at, Index group) {
  auto extended = std::make_shared<Prepared>(p);
  add_node(*extended, at, group);
  hold_added(*extended);
  return extended;
}

}  // namespace ts::tooth
