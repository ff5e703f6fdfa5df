// The teeth separated so far. Any order of the same clicks gives the same teeth and labels, unless one makes a group:
// then it is there for those after it.
#pragma once

#include "tooth/edit_cut.h"
#include "tooth/segmenter.h"

namespace ts::tooth {

class Session {
 public:
  explicit Session(const mesh::Surface &surface) : surface_(&surface) {}

  // Takes a click's teeth; one separated before is replaced. Returns the click's number, counted from 0.
  Index add(Click click);

  Index clicks() const { return static_cast<Index>(clicks_.size()); }
  const Click &click(Index number) const;        // its teeth have been taken out
  Vec<Index> teeth() const;                      // groups with a tooth, along the arch
  const Tooth *tooth(Index group) const;         // nullptr if not separated
  const Among &among() const { return among_; }  // for the next click
  Index click_of(Index group) const;             // the click that separated it last

  // Puts an edited tooth in the place of one that is there, with all edits that led to it; none: the automatic one
  // again.
  void replace(Index group, Tooth tooth, Vec<EditRecord> edits);
  const Tooth *automatic(Index group) const;        // as the click cut it; nullptr if not separated
  const Vec<EditRecord> &edits(Index group) const;  // since that; of one that is there

  // A label a model face: 0 or group + 1. A face of two teeth belongs to the one with the nearest seed.
  Vec<std::uint32_t> labels() const;

 private:
  struct Entry {
    Index group, click;
    std::shared_ptr<const Tooth> tooth;           // shared by the sessions before and after a click
    std::shared_ptr<const Tooth> automatic = {};  // where it has been edited
    Vec<EditRecord> edits = {};
  };
  const Entry &entry_of(Index group) const;  // of one that is there

  const mesh::Surface *surface_;
  Vec<Click> clicks_;
  Among among_;
  Vec<Entry> entries_;  // by group
};

}  // namespace ts::tooth
