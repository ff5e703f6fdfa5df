#include "tooth/session.h"

#include <algorithm>
#include <limits>
#include <map>

#include "tooth/prepared.h"

namespace ts::tooth {

const Session::Entry *Session::find(Index group) const {
  const auto at = std::ranges::lower_bound(entries_, group, {}, &Entry::group);
  return at != entries_.end() && at->group == group ? &*at : nullptr;
}

void Session::put(Tooth tooth, Index click) {
  const Index group = tooth.group;
  const auto at = std::ranges::lower_bound(entries_, group, {}, &Entry::group);
  const bool there = at != entries_.end() && at->group == group;
  if (there && at->locked) return;
  Entry entry{group, click, std::make_shared<const Tooth>(std::move(tooth))};
  if (there)
    *at = std::move(entry);
  else
    entries_.insert(at, std::move(entry));
}

Index Session::add(Click click) {
  const Index number = clicks();
  for (Tooth &tooth : click.teeth) put(std::move(tooth), number);
  if (click.among) among_ = click.among;
  click.teeth.clear();
  clicks_.push_back(std::make_shared<const Click>(std::move(click)));
  return number;
}

void Session::apply(Correction correction, Index group) {
  const Index number = click_of(group);
  for (Tooth &tooth : correction.teeth) {
    const Entry *before = find(tooth.group);
    put(std::move(tooth), before ? before->click : number);
  }
  for (const Index g : correction.gone) std::erase_if(entries_, [&](const Entry &e) { return e.group == g; });
  among_ = std::move(correction.among);
}

void Session::remove(Index group) {
  if (locked(group)) throw Error(Fault::locked, "the tooth is locked");
  if (std::erase_if(entries_, [&](const Entry &e) { return e.group == group; }) == 0)
    throw Error(Fault::not_found, "no such tooth has been separated");
}

void Session::lock(Index group, bool locked) {
  const auto at = std::ranges::find(entries_, group, &Entry::group);
  if (at == entries_.end()) throw Error(Fault::not_found, "no such tooth has been separated");
  if (at->locked == locked)
    throw Error(Fault::no_change, locked ? "the tooth is locked already" : "the tooth is not locked");
  at->locked = locked;
}

const Click &Session::click(Index number) const {
  if (number >= clicks_.size()) throw Error(Fault::not_found, "no click " + std::to_string(number));
  return *clicks_[number];
}

Vec<Index> Session::teeth() const {
  Vec<Index> groups;
  for (const Entry &e : entries_) groups.push_back(e.group);
  // Those of the features are along the arch in their own order.
  if (among_)
    std::ranges::sort(groups, {}, [&](Index g) { return std::ranges::find(among_->live, g) - among_->live.begin(); });
  return groups;
}

const Tooth *Session::tooth(Index group) const {
  const Entry *entry = find(group);
  return entry ? entry->tooth.get() : nullptr;
}

bool Session::locked(Index group) const {
  const Entry *entry = find(group);
  return entry && entry->locked;
}

Index Session::click_of(Index group) const {
  const Entry *entry = find(group);
  return entry ? entry->click : mesh::none;
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
  const Entry *entry = find(group);
  if (!entry) return nullptr;
  return entry->automatic ? entry->automatic.get() : entry->tooth.get();
}

const Vec<EditRecord> &Session::edits(Index group) const {
  return find(group)->edits;
}

// Labels; contested(winner, loser, face) for each face that two teeth hold, for as many pairs as hold it.
template <class Contested>
Vec<std::uint32_t> Session::resolve(const Contested &contested) const {
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
      if (l != 0) {
        const Entry &other = *find(l - 1);
        const bool wins = e.locked != other.locked ? e.locked : distance(e, f) < distance(other, f);
        contested(wins ? e.group : other.group, wins ? other.group : e.group, f);
        if (!wins) continue;
      }
      l = e.group + 1;
    }
  return label;
}

Vec<std::uint32_t> Session::labels() const {
  return resolve([](Index, Index, Index) {});
}

Vec<Overlap> Session::overlaps() const {
  std::map<std::pair<Index, Index>, Overlap> found;
  resolve([&](Index winner, Index loser, Index f) {
    Overlap &o = found[{winner, loser}];
    o.winner = winner, o.loser = loser;
    ++o.faces;
    o.area += surface_->face_area[f];
  });
  Vec<Overlap> all;
  for (const auto &[pair, overlap] : found) all.push_back(overlap);
  return all;
}

Vec<Index> Session::changed(const Session &before, const Session &after) {
  Vec<Index> groups;
  const auto note = [&](const Session &one, const Session &other) {
    for (const Entry &e : one.entries_) {
      const Entry *o = other.find(e.group);
      if (!o || o->tooth != e.tooth || o->locked != e.locked) groups.push_back(e.group);
    }
  };
  note(before, after);
  note(after, before);
  std::ranges::sort(groups);
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
  return groups;
}

std::size_t Session::added_bytes(const Session &before, const Session &after) {
  std::size_t bytes = sizeof(Session) + sizeof(Entry) * after.entries_.size() +
                      sizeof(after.clicks_[0]) * after.clicks_.size() + sizeof(Click);
  if (after.among_ && after.among_ != before.among_) bytes += after.among_->bytes();
  for (const Entry &e : after.entries_) {
    const Entry *o = before.find(e.group);
    if (o && o->tooth == e.tooth) continue;
    const Tooth &t = *e.tooth;
    bytes += sizeof(Tooth) + sizeof(Index) * (t.faces.size() + t.vertices.size() + t.seeds.size());
    for (const Cut &c : t.loops) bytes += sizeof(Cut) + sizeof(cut::EdgePoint) * c.line.points.size();
  }
  return bytes;
}

}  // namespace ts::tooth
