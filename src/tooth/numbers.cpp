#include "tooth/numbers.h"

#include <algorithm>

#include "base/error.h"

namespace ts::tooth {
namespace {

const char *name_of(Jaw jaw) {
  return jaw == Jaw::upper ? "upper" : "lower";
}

}  // namespace

const Numbers::Number *Numbers::number(Index group) const {
  const auto it = std::ranges::find(numbers_, group, &Number::group);
  return it == numbers_.end() ? nullptr : &*it;
}

void Numbers::work_out(const ArchRow &row, std::span<const Index> groups, const NumberOptions &options,
                       Vec<ByHand> by_hand) {
  std::erase_if(by_hand, [&](const ByHand &h) { return std::ranges::find(groups, h.group) == groups.end(); });
  Given given{options.jaw, options.mirrored, Vec<int>(groups.size(), -1)};
  for (const ByHand &h : by_hand) {
    const Jaw jaw = jaw_of(h.fdi);
    if (given.jaw && *given.jaw != jaw)
      throw Error(Fault::number_jaw, "number " + std::to_string(h.fdi) + " is of the " + name_of(jaw) +
                                         " jaw, this one is the " + name_of(*given.jaw));
    given.jaw = jaw;
    given.place[static_cast<std::size_t>(std::ranges::find(groups, h.group) - groups.begin())] = place_of(h.fdi);
  }
  const Numbering n = number_teeth(row, given);
  Vec<Number> numbers;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const bool set = given.place[i] >= 0;
    numbers.push_back({groups[i], fdi_of(n.jaw, n.place[i]), set ? 1 : n.confidence[i], set});
  }
  options_ = options;
  by_hand_ = std::move(by_hand);
  numbers_ = std::move(numbers);
  jaw_ = {n.jaw, given.jaw ? 1 : n.jaw_confidence, given.jaw.has_value()};
}

void Numbers::assign(const ArchRow &row, std::span<const Index> groups, const NumberOptions &options) {
  work_out(row, groups, options, by_hand_);
}

void Numbers::set(const ArchRow &row, std::span<const Index> groups, Index group, std::uint32_t fdi) {
  jaw_of(fdi);  // throws for what is none
  Vec<ByHand> by_hand = by_hand_;
  std::erase_if(by_hand, [&](const ByHand &h) { return h.group == group; });
  for (const ByHand &h : by_hand)
    if (h.fdi == fdi && std::ranges::find(groups, h.group) != groups.end())
      throw Error(Fault::number_taken, "number " + std::to_string(fdi) + " has been set for another tooth");
  by_hand.push_back({group, fdi});
  work_out(row, groups, options_, std::move(by_hand));
}

void Numbers::forget(const ArchRow &row, std::span<const Index> groups, Index group) {
  Vec<ByHand> by_hand = by_hand_;
  if (std::erase_if(by_hand, [&](const ByHand &h) { return h.group == group; }) == 0)
    throw Error(Fault::not_found, "no number has been set for this tooth");
  work_out(row, groups, options_, std::move(by_hand));
}

}  // namespace ts::tooth
