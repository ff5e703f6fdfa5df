// The teeth separated so far. Any order of the same clicks gives the same teeth and labels, unless one makes a group:
// then it is there for those after it.
#pragma once

#include "tooth/segmenter.h"

namespace ts::tooth {

// What a correction brings (correct.h).
struct Correction {
  Among among;       // the groups as they are afterwards
  Vec<Tooth> teeth;  // cut anew
  Vec<Index> gone;   // groups that have no tooth from then on
};

// Faces that two teeth hold; the one they go to by the rule of Session::labels.
struct Overlap {
  Index winner = mesh::none, loser = mesh::none;
  Index faces = 0;
  double area = 0;  // mm^2
};

class Session {
 public:
  explicit Session(const mesh::Surface &surface) : surface_(&surface) {}

  // Takes a click's teeth; one separated before is replaced, one that is locked is left as it is. Returns the click's
  // number, counted from 0.
  Index add(Click click);
  // A tooth without a click of its own (one divided) has that of `group`.
  void apply(Correction correction, Index group);
  void remove(Index group);
  void lock(Index group, bool locked);

  Index clicks() const { return static_cast<Index>(clicks_.size()); }
  const Click &click(Index number) const;        // its teeth have been taken out
  Vec<Index> teeth() const;                      // groups with a tooth, along the arch
  const Tooth *tooth(Index group) const;         // nullptr if not separated
  bool locked(Index group) const;                // false if not separated
  const Among &among() const { return among_; }  // for the next click; null: the groups of the features
  Index click_of(Index group) const;             // the click that separated it last

  // A label a model face: 0 or group + 1. A face of two teeth belongs to the one that is locked, or, where neither or
  // both are, to the one with the nearest seed.
  Vec<std::uint32_t> labels() const;
  Vec<Overlap> overlaps() const;

  // Groups whose tooth, or whether it is locked, differs in the two.
  static Vec<Index> changed(const Session &before, const Session &after);
  // Of what `after` holds and `before` does not.
  static std::size_t added_bytes(const Session &before, const Session &after);

 private:
  struct Entry {
    Index group, click;
    std::shared_ptr<const Tooth> tooth;  // shared by the sessions before and after a change
    bool locked = false;
  };
  const Entry *find(Index group) const;  // nullptr if not separated
  void put(Tooth tooth, Index click);
  template <class Contested>
  Vec<std::uint32_t> resolve(const Contested &contested) const;

  const mesh::Surface *surface_;
  Vec<std::shared_ptr<const Click>> clicks_;  // shared as well
  Among among_;
  Vec<Entry> entries_;  // by group
};

}  // namespace ts::tooth
