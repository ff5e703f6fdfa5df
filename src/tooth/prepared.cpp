#include "tooth/prepared.h"

#include <algorithm>
#include <limits>

#include "cut/refine.h"
#include "geometry/concavity.h"
#include "tooth/warnings.h"

namespace ts::tooth {
namespace {

// Makes curvature the dimensionless concavity of click_concavity. From 0.05 to 0.4 the right tooth is found in the same
// 99.0 % of 1256 clicks on labelled crowns, with plain distances in 98.1 %. mm.
constexpr double kClickLength = 0.1;

constexpr std::size_t kGrain = 1 << 13;

// At most `most` points, spread out: the most convex one, then each time the one farthest from those taken.
Vec<Index> spread(const features::Group &group, std::size_t most) {
  Vec<Index> all;
  for (Index i = 0; i < group.points.size(); ++i) all.push_back(i);
  if (most == 0 || all.size() <= most) return all;
  Vec<Index> taken;
  Vec<double> clearance(all.size(), std::numeric_limits<double>::infinity());
  Index next = 0;
  for (const Index i : all)
    if (group.points[i].convexity > group.points[next].convexity) next = i;
  while (taken.size() < most) {
    taken.push_back(next);
    for (const Index i : all)
      clearance[i] = std::min(clearance[i], (group.points[i].position - group.points[next].position).norm());
    for (const Index i : all)
      if (clearance[i] > clearance[next]) next = i;
  }
  std::sort(taken.begin(), taken.end());
  return taken;
}

// Of the option's bytes.
std::size_t left_to_the_factor(const Prepared &p) {
  const std::size_t limit = p.options.memory_limit, taken = p.bytes();
  if (limit == 0) return SIZE_MAX;
  if (limit < taken)
    throw Error(Fault::out_of_memory, "memory_limit: " + std::to_string(limit) + " bytes are less than the " +
                                          std::to_string(taken) + " that a click needs beside the factor");
  return limit - taken;
}

}  // namespace

Prepared prepare(const mesh::Surface &surface, const features::Features &features, const Options &options,
                 const Executor &executor, const Progress &progress) {
  check(options);
  Prepared p;
  p.surface = &surface;
  p.executor = &executor;
  p.options = options;
  p.inside_out = features.inside_out;
  p.groups = p.found = static_cast<Index>(features.groups.size());
  p.rejected.resize(p.groups);

  Stopwatch watch;
  Vec<Index> place;       // of each site in its Group::points
  Vec<double> convexity;  // of each site
  p.sites.groups = p.groups;
  for (Index g = 0; g < p.groups; ++g)
    for (const Index i : spread(features.groups[g], options.points_per_group)) {
      p.sites.point.push_back(features.groups[g].points[i].vertex);
      p.sites.group.push_back(g);
      place.push_back(i);
      convexity.push_back(features.groups[g].points[i].convexity);
    }
  if (p.sites.point.empty()) throw Error(Fault::no_constraint, "no feature group has a point: nothing to separate");

  progress.part(0, 0.01, "weights")(0);
  geometry::Concavity valleys = geometry::concavity(surface, options.normal_radius, features.inside_out, executor);
  const auto relief = std::make_shared<Relief>();
  p.relief = relief;
  relief->length.resize(surface.edge.size());
  executor.ranges(relief->length.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) relief->length[e] = surface.edge_length(static_cast<Index>(e));
  });
  relief->price = cut::prices(relief->length, cut::seams(surface, valleys.vertex, valleys.edge));
  relief->concavity = std::move(valleys.vertex);
  relief->cotangent = std::move(valleys.cotangent);
  p.lengthened = valleys.lengthened;
  p.widened = valleys.widened;
  for (const features::Group &g : features.groups) p.width.push_back(std::max(0.0, g.to - g.from));
  p.along = along_the_arch(features);
  p.occlusal = features.occlusal;
  progress.part(0.2, 0.3, "weights")(0);
  Vec<double> weight = field::edge_weights(
      surface, relief->concavity,
      {options.weights, options.beta, options.gamma, options.theta, options.c0, features.inside_out}, executor);
  valleys = {};
  relief->click_cost.resize(surface.edge.size());
  executor.ranges(surface.edge.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (Index e = static_cast<Index>(begin); e < end; ++e) {
      const double c = (relief->concavity[surface.edge[e][0]] + relief->concavity[surface.edge[e][1]]) / 2;
      relief->click_cost[e] = relief->length[e] * (1 + options.click_concavity * kClickLength * c);
    }
  });
  p.times.weights = watch.lap();

  const bool several =
      std::any_of(p.sites.group.begin(), p.sites.group.end(), [&](Index g) { return g != p.sites.group.front(); });
  p.nodes = field::make_nodes(surface, p.sites,
                              {options.seed_radius, options.background != Background::neighbour || !several,
                               options.gingiva_distance, p.lengthened});
  p.group_at.assign(surface.vertices(), mesh::none);
  p.solver = std::make_shared<const field::Solver>(surface, std::move(weight), p.nodes, executor,
                                                   progress.part(0.3, 1, "factorisation"), left_to_the_factor(p));
  p.outlier = options.reject_outliers ? field::find_outliers(*p.solver, p.nodes, convexity)
                                      : Vec<std::uint8_t>(p.nodes.size(), 0);

  for (Index i = 0; i < p.sites.point.size(); ++i) {
    const Index node = p.nodes.of_vertex[p.sites.point[i]];
    if (p.outlier[node])
      p.rejected[p.sites.group[i]].push_back(place[i]);
    else
      p.group_at[p.sites.point[i]] = p.nodes.group[node];
  }
  for (Index n = 0; n < p.nodes.size(); ++n)
    if (!p.outlier[n] && p.nodes.group[n] != field::gingiva_group &&
        (p.live.empty() || p.live.back() != p.nodes.group[n]))
      p.live.push_back(p.nodes.group[n]);
  p.seeds.resize(p.groups);
  for (Index v = 0; v < surface.vertices(); ++v)
    if (const Index n = p.nodes.of_vertex[v];
        n != mesh::none && !p.outlier[n] && p.nodes.group[n] != field::gingiva_group)
      p.seeds[p.nodes.group[n]].push_back(v);
  p.times.factorise = watch.lap();
  return p;
}

}  // namespace ts::tooth
