#include "features/feature_set.h"

#include <algorithm>
#include <string>

#include "base/error.h"

namespace ts::features {

FeatureSet::FeatureSet(const Features &found)
    : occlusal_(found.occlusal), arch_(found.arch), inside_out_(found.inside_out), looks_(found.looks) {
  for (const features::Group &g : found.groups) {
    const Index id = next_group_++;
    groups_.push_back({id, g.from, g.to, g.confidence, Vec3::Zero(), 0});
    for (const features::Point &p : g.points)
      points_.push_back({next_point_++, id, p.vertex, p.position, p.convexity, false});
  }
  settle();
}

FeatureSet::Point &FeatureSet::find_point(Index id) {
  const auto it = std::ranges::find(points_, id, &Point::id);
  if (it == points_.end()) throw Error(Fault::not_found, "no feature point " + std::to_string(id));
  return *it;
}

void FeatureSet::require_group(Index id) const {
  if (std::ranges::find(groups_, id, &Group::id) == groups_.end())
    throw Error(Fault::not_found, "no feature group " + std::to_string(id));
}

std::size_t place_in_row(std::span<const Vec3> row, const Vec3 &at) {
  const auto distance = [&](std::size_t i) { return (row[i] - at).norm(); };
  std::size_t best = 0;
  double least = row.empty() ? 0 : distance(0);
  for (std::size_t i = 1; i <= row.size(); ++i) {
    const double added =
        i == row.size() ? distance(i - 1) : distance(i - 1) + distance(i) - (row[i - 1] - row[i]).norm();
    if (added < least) {
      least = added;
      best = i;
    }
  }
  return best;
}

Index FeatureSet::insert_group(const Vec3 &at) {
  Vec<Vec3> row;
  for (const Group &g : groups_) row.push_back(g.centre);
  const std::size_t best = place_in_row(row, at);
  groups_.insert(groups_.begin() + static_cast<std::ptrdiff_t>(best), {next_group_, 0, 0, 1, at, 0});
  return next_group_++;
}

// Brings points into the order of their groups, renews the centres, drops empty groups.
void FeatureSet::settle() {
  for (Group &g : groups_) {
    g.points = 0;
    Vec3 sum = Vec3::Zero();
    for (const Point &p : points_)
      if (p.group == g.id) sum += p.position, ++g.points;
    if (g.points) g.centre = sum / g.points;
  }
  std::erase_if(groups_, [](const Group &g) { return g.points == 0; });
  Vec<Point> sorted;
  sorted.reserve(points_.size());
  for (const Group &g : groups_)
    for (const Point &p : points_)
      if (p.group == g.id) sorted.push_back(p);
  points_ = std::move(sorted);
}

const FeatureSet::Point &FeatureSet::add_point(Index vertex, const Vec3 &position, Index group) {
  if (group != mesh::none) require_group(group);
  const Index id = next_point_;
  points_.push_back({id, group != mesh::none ? group : insert_group(position), vertex, position, 0, true});
  ++next_point_;
  settle();
  return find_point(id);
}

void FeatureSet::move_point(Index point, Index vertex, const Vec3 &position) {
  Point &p = find_point(point);
  p.vertex = vertex;
  p.position = position;
  p.convexity = 0;
  p.by_hand = true;
  settle();
}

Index FeatureSet::set_group(Index point, Index group) {
  Point &p = find_point(point);
  if (group != mesh::none) require_group(group);
  const Index to = group != mesh::none ? group : insert_group(p.position);
  p.group = to;
  p.by_hand = true;
  settle();
  return to;
}

void FeatureSet::remove_point(Index point) {
  find_point(point);
  std::erase_if(points_, [&](const Point &p) { return p.id == point; });
  settle();
}

void FeatureSet::remove_group(Index group) {
  require_group(group);
  std::erase_if(points_, [&](const Point &p) { return p.group == group; });
  settle();
}

Features FeatureSet::features() const {
  Features f;
  f.occlusal = occlusal_;
  f.arch = arch_;
  f.inside_out = inside_out_;
  f.looks = looks_;
  for (const Group &g : groups_) {
    f.groups.push_back({{}, g.from, g.to, g.confidence});
    for (const Point &p : points_)
      if (p.group == g.id) f.groups.back().points.push_back({p.vertex, p.position, p.convexity});
  }
  return f;
}

}  // namespace ts::features
