// Features that can be edited by hand: points and groups with ids that stay, groups kept in the order of the arch.
#pragma once

#include <span>

#include "features/features.h"

namespace ts::features {

// Where in a row of centres a further one belongs: where it lengthens the way through them least.
std::size_t place_in_row(std::span<const Vec3> row, const Vec3 &at);

class FeatureSet {
 public:
  struct Point {
    Index id, group;
    Index vertex;
    Vec3 position;
    double convexity;
    bool by_hand;
  };
  struct Group {
    Index id;
    double from, to, confidence;
    Vec3 centre;  // mean of its points
    Index points;
  };

  // All that a set is, to be kept in a file.
  struct State {
    Vec3 occlusal = Vec3::Zero();
    Vec<Vec3> arch;
    bool inside_out = false;
    Looks looks;
    Vec<Point> points;
    Vec<Group> groups;
    Index next_point = 0, next_group = 0;  // ids of the next ones
  };

  FeatureSet() = default;
  explicit FeatureSet(State state)
      : occlusal_(state.occlusal),
        arch_(std::move(state.arch)),
        inside_out_(state.inside_out),
        looks_(state.looks),
        points_(std::move(state.points)),
        groups_(std::move(state.groups)),
        next_point_(state.next_point),
        next_group_(state.next_group) {}
  State state() const { return {occlusal_, arch_, inside_out_, looks_, points_, groups_, next_point_, next_group_}; }
  explicit FeatureSet(const Features &found);

  const Vec3 &occlusal() const { return occlusal_; }
  void set_occlusal(const Vec3 &unit) { occlusal_ = unit; }
  const Vec<Vec3> &arch() const { return arch_; }
  bool inside_out() const { return inside_out_; }
  const Looks &looks() const { return looks_; }
  const Vec<Point> &points() const { return points_; }  // in the order of their groups
  const Vec<Group> &groups() const { return groups_; }  // along the arch

  // `group` none: a new group, put along the arch by place_in_row.
  // All of these throw Error{not_found} for an id that is not there, and then change nothing.
  const Point &add_point(Index vertex, const Vec3 &position, Index group);
  void move_point(Index point, Index vertex, const Vec3 &position);
  Index set_group(Index point, Index group);  // returns the group's id
  void remove_point(Index point);
  void remove_group(Index group);

  // For the field: groups along the arch, all of them with points.
  Features features() const;

 private:
  Point &find_point(Index id);
  void require_group(Index id) const;
  Index insert_group(const Vec3 &at);
  void settle();

  Vec3 occlusal_ = Vec3::Zero();
  Vec<Vec3> arch_;
  bool inside_out_ = false;
  Looks looks_;
  Vec<Point> points_;
  Vec<Group> groups_;
  Index next_point_ = 0, next_group_ = 0;
};

}  // namespace ts::features
