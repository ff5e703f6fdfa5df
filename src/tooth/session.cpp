#include "tooth/session.h"

#include <algorithm>
#include <limits>

#include "tooth/prepared.h"

namespace ts::tooth {

Index Session::add(Click click) {
  const Index number = clicks();
  for (Tooth &tooth : click.teeth) {
    const auto at = std::lower_bound(entries_.begin(), entries_.end(), tooth.group,
                                     [](const Entry &e, Index g) { return e.group < g; });
    const Index group = tooth.group;
    auto own = std::make_shared<const Tooth>(std::move(tooth));
    if (at != entries_.end() && at->group == group)
      *at = {group, number, std::move(own)};
    else
      entries_.insert(at, {group, number, std::move(own)});
  }
  if (click.among) among_ = click.among;
  click.teeth.clear();
  clicks_.push_back(std::move(click));
  return number;
}

const Click &Session::click(Index number) const {
  if (number >= clicks_.size()) throw Error(Fault::not_found, "no click " + std::to_string(number));
  return clicks_[number];
}

Vec<Index> Session::teeth() const {
  Vec<Index> groups;
  for (const Entry &e : entries_) groups.push_back(e.group);
  // Those of the features are along the arch in their own order.
  if (among_)
    std::ranges::sort(groups, {}, [&](Index g) { return std::ranges::find(among_->live, g) - among_->live.begin(); });
  return groups;
}

const Session::Entry &Session::entry_of(Index group) const {
  return *std::ranges::lower_bound(entries_, group, {}, &Entry::group);
}

const Tooth *Session::tooth(Index group) const {
  for (const Entry &e : entries_)
    if (e.group == group) return e.tooth.get();
  return nullptr;
}

Index Session::click_of(Index group) const {
  for (const Entry &e : entries_)
    if (e.group == group) return e.click;
  return mesh::none;
}

void Session::replace(Index group, Tooth tooth, Vec<EditRecord> edits) {
  Entry &entry = *std::ranges::lower_bound(entries_, group, {}, &Entry::group);
  Entry next = entry;
  if (!next.automatic) next.automatic = next.tooth;
  next.tooth = edits.empty() ? next.automatic : std::make_shared<const Tooth>(std::move(tooth));
  if (edits.empty()) next.automatic.reset();
  next.edits = std::move(edits);
  entry = std::move(next);
}

const Tooth *Session::automatic(Index group) const {
  for (const Entry &e : entries_)
    if (e.group == group) return e.automatic ? e.automatic.get() : e.tooth.get();
  return nullptr;
}

const Vec<EditRecord> &Session::edits(Index group) const {
  return entry_of(group).edits;
}

Vec<std::uint32_t> Session::labels() const {
  const mesh::Surface &s = *surface_;
  Vec<std::uint32_t> label(s.faces(), 0);
  const auto distance = [&](const Entry &e, Index f) {
    const auto &t = s.triangle[f];
    const Vec3 centre = (s.position[t[0]] + s.position[t[1]] + s.position[t[2]]) / 3;
    double least = std::numeric_limits<double>::infinity();
    for (const Index v : e.tooth->seeds) least = std::min(least, (s.position[v] - centre).squaredNorm());
    return least;
  };
  for (const Entry &e : entries_)
    for (const Index f : e.tooth->faces) {
      std::uint32_t &l = label[f];
      if (l != 0 && !(distance(e, f) < distance(entry_of(l - 1), f))) continue;
      l = e.group + 1;
    }
  return label;
}

}  // namespace ts::tooth
