#include "tooth/correct.h"

#include <algorithm>

#include "base/error.h"
#include "tooth/made.h"
#include "tooth/separate.h"

namespace ts::tooth {
namespace {

Index nearest_vertex(const Prepared &p, const mesh::SurfacePoint &at) {
  return *std::ranges::min_element(p.surface->triangle[at.face], {},
                                   [&](Index v) { return (p.surface->position[v] - at.position).squaredNorm(); });
}

mesh::SurfacePoint at_vertex(const Prepared &p, Index vertex) {
  mesh::SurfacePoint at;
  at.face = p.surface->vertex_faces[vertex].front();
  at.position = p.surface->position[vertex];
  for (std::size_t k = 0; k < 3; ++k)
    at.barycentric[static_cast<Eigen::Index>(k)] = p.surface->triangle[at.face][k] == vertex;
  return at;
}

std::string name_of(Index group) {
  return "tooth of label " + std::to_string(group + 1);
}

Index nodes_in_use(const Prepared &p, Index group) {
  Index count = 0;
  for (Index n = 0; n < p.nodes.size(); ++n) count += p.nodes.group[n] == group && !p.outlier[n];
  return count;
}

void need_unlocked(const Session &session, Index group) {
  if (session.locked(group)) throw Error(Fault::locked, "the " + name_of(group) + " is locked, and would change");
}

// The group beside one along the arch; none if there is no other.
Index beside(const Prepared &p, Index group) {
  const auto here = std::ranges::find(p.live, group);
  if (here + 1 < p.live.end()) return *(here + 1);
  return here != p.live.begin() && here != p.live.end() ? *(here - 1) : mesh::none;
}

// The teeth of these groups, two at a time as a click has them.
Correction cut_anew(std::shared_ptr<const Prepared> changed, const Vec<Index> &groups, const Progress &progress) {
  const Prepared &p = *changed;
  Correction c;
  for (std::size_t i = 0; i < groups.size(); i += 2) {
    const bool two = i + 1 < groups.size();
    Pick pick;
    pick.target = groups[i];
    pick.neighbour = two ? groups[i + 1] : beside(p, groups[i]);
    const Progress part = progress.part(static_cast<double>(i) / static_cast<double>(groups.size()), 1, "cut");
    if (!two) {
      c.teeth.push_back(cut_out_target(p, pick, part));
      continue;
    }
    Click click = cut_out(p, at_vertex(p, p.seeds[groups[i]].front()), pick, 0, part);
    if (click.teeth.size() < 2) throw Error(Fault::no_cut, "no cut is left for the " + name_of(groups[i + 1]));
    std::ranges::move(click.teeth, std::back_inserter(c.teeth));
  }
  c.among = std::move(changed);
  return c;
}

// `groups` anew after the last disc that was added, and those separated teeth on which it lies: what is held there now
// is not what it was.
Correction with_disc(std::shared_ptr<const Prepared> changed, const Session &session, Vec<Index> groups,
                     const Progress &progress) {
  const Vec<Index> &disc = changed->added.back();
  for (const Index g : session.teeth()) {
    const auto on_tooth = [&](Index v) { return std::ranges::binary_search(session.tooth(g)->vertices, v); };
    if (std::ranges::find(groups, g) == groups.end() && std::ranges::any_of(disc, on_tooth)) groups.push_back(g);
  }
  for (const Index g : groups) need_unlocked(session, g);
  return cut_anew(std::move(changed), groups, progress);
}

// `node` for another group, and the teeth on either side anew.
Correction with_other_group(const Prepared &p, const Session &session, Index node, Index group,
                            const Progress &progress) {
  const Index old = p.nodes.group[node];
  auto changed = std::make_shared<Prepared>(p);
  regroup(*changed, node, group);
  Vec<Index> groups = {group};
  if (session.tooth(old)) groups.push_back(old), need_unlocked(session, old);
  return cut_anew(std::move(changed), groups, progress);
}

}  // namespace

Correction take_in(const Prepared &p, const Session &session, Index group, const mesh::SurfacePoint &at,
                   const Progress &progress) {
  need_unlocked(session, group);
  const Index node = p.nodes.of_vertex[nearest_vertex(p, at)];
  if (node == mesh::none) return with_disc(extend_group(p, at, group), session, {group}, progress);
  const Index held = p.nodes.group[node];
  if (held == field::gingiva_group) throw Error(Fault::click_on_gingiva, "the point lies on gingiva for certain");
  if (held != group) {
    if (!p.outlier[node] && nodes_in_use(p, held) < 2)
      throw Error(Fault::no_cut, "the point is the last one of the " + name_of(held) + ": unite the two, or remove it");
    return with_other_group(p, session, node, group, progress);
  }
  if (!p.outlier[node]) throw Error(Fault::no_change, "the point is held for the tooth already");
  auto changed = std::make_shared<Prepared>(p);
  hold(*changed, node);
  return cut_anew(std::move(changed), {group}, progress);
}

Correction leave_out(const Prepared &p, const Session &session, Index group, const mesh::SurfacePoint &at,
                     const Progress &progress) {
  need_unlocked(session, group);
  const Index node = p.nodes.of_vertex[nearest_vertex(p, at)];
  if (node == mesh::none) {
    const Index other = strongest_beside(p, at, group);
    Vec<Index> groups = {group};
    if (session.tooth(other)) groups.push_back(other);
    return with_disc(extend_group(p, at, other), session, groups, progress);
  }
  if (p.nodes.group[node] != group || p.outlier[node])
    throw Error(Fault::no_change, "the point is not held for the tooth");
  if (nodes_in_use(p, group) < 2)
    throw Error(Fault::no_cut, "the point is the last one of the tooth: remove the tooth instead");
  auto changed = std::make_shared<Prepared>(p);
  let_go(*changed, node);
  return cut_anew(std::move(changed), {group}, progress);
}

Correction divide(const Prepared &p, const Session &session, Index group, const mesh::SurfacePoint &kept,
                  const mesh::SurfacePoint &part, const Progress &progress) {
  need_unlocked(session, group);
  const Index at[2] = {nearest_vertex(p, kept), nearest_vertex(p, part)};
  const Index on[2] = {p.nodes.of_vertex[at[0]], p.nodes.of_vertex[at[1]]};
  if (at[0] == at[1] || (on[0] != mesh::none && on[0] == on[1]))
    throw Error(Fault::no_change, "both points are the same point of the tooth");
  for (const Index n : on)
    if (n != mesh::none && p.nodes.group[n] != group)
      throw Error(Fault::no_cut, "a point lies on what is held for another tooth or the gingiva");

  auto changed = std::make_shared<Prepared>(p);
  const Index made = add_group(*changed);
  for (Index n = 0; n < p.nodes.size(); ++n) {
    if (p.nodes.group[n] != group) continue;
    const Vec3 &middle = p.surface->position[p.sites.point[p.nodes.point[n]]];
    if ((middle - part.position).norm() < (middle - kept.position).norm()) regroup(*changed, n, made);
  }
  for (int k = 0; k < 2; ++k) {
    if (on[k] != mesh::none) {
      if (changed->nodes.group[on[k]] != (k ? made : group)) regroup(*changed, on[k], k ? made : group);
      if (changed->outlier[on[k]]) hold(*changed, on[k]);
    } else {
      add_node(*changed, k ? part : kept, k ? made : group);
    }
  }
  if (changed->added.size() > p.added.size()) hold_added(*changed);
  return cut_anew(std::move(changed), {group, made}, progress);
}

Correction move_point(const Prepared &p, const Session &session, Index group, const mesh::SurfacePoint &from,
                      const mesh::SurfacePoint &to, const Progress &progress) {
  need_unlocked(session, group);
  const Index node = p.nodes.of_vertex[nearest_vertex(p, from)], there = p.nodes.of_vertex[nearest_vertex(p, to)];
  if (node == mesh::none || p.nodes.group[node] != group || p.outlier[node])
    throw Error(Fault::no_change, "no point is held for the tooth there");
  if (there != mesh::none && p.nodes.group[there] == group && (there == node || !p.outlier[there]))
    throw Error(Fault::no_change, "where the point is to go one is held for the tooth already");
  auto changed = std::make_shared<Prepared>(p);
  add_node(*changed, to, group);
  let_go(*changed, node);
  hold_added(*changed);
  return with_disc(std::move(changed), session, {group}, progress);
}

Correction unite(const Prepared &p, const Session &session, Index group, Index other, const Progress &progress) {
  need_unlocked(session, group);
  need_unlocked(session, other);
  if (group == other) throw Error(Fault::no_change, "a tooth is one with itself");
  auto changed = std::make_shared<Prepared>(p);
  for (Index n = 0; n < p.nodes.size(); ++n)
    if (p.nodes.group[n] == other) regroup(*changed, n, group);
  Correction c = cut_anew(std::move(changed), {group}, progress);
  c.gone.push_back(other);
  return c;
}

}  // namespace ts::tooth
