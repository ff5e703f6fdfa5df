// The states of a segmentation and what led to each, for undo, redo and the session file.
#pragma once

#include <deque>

#include "tooth/session.h"

namespace ts::api {

// A change as the caller asked for it. Groups are places, not ids: they stay what they are while the features do.
struct Command {
  enum class Act : std::uint32_t {
    click,
    clicks,
    all,
    take_in,
    leave_out,
    divide,
    unite,
    remove,
    lock,
    unlock,
    assign_numbers,
    set_number,
    edit,
    reset,
    move
  };

  Act act = Act::click;
  mesh::Index tooth = mesh::none, other = mesh::none;
  Vec<mesh::Vec3> at{};  // mm; of a batch of clicks those that came to something
  tooth::NumberOptions numbering{};
  std::uint32_t number = 0;  // FDI; 0: to be forgotten
  tooth::CutEdit edit{};
};

class History {
 public:
  struct Step {
    tooth::Session state;  // before the command, if it is done; after it, if it is undone
    Command command;
    std::size_t bytes = 0;
  };

  // The command led from `before` to what is now. What was undone is forgotten, and from the oldest on what the limit
  // does not hold.
  void record(tooth::Session before, Command command, std::size_t bytes);
  // The state to go back, or forward, to. Throws Fault::no_history.
  const tooth::Session &before() const;
  const tooth::Session &after() const;
  // Puts it in the place of `now`.
  void undo(tooth::Session &now);
  void redo(tooth::Session &now);

  void set_limit(std::size_t bytes);
  std::size_t limit() const { return limit_; }
  std::size_t bytes() const { return bytes_; }
  const std::deque<Step> &done() const { return done_; }
  const std::deque<Step> &undone() const { return undone_; }
  const Vec<Command> &forgotten() const { return forgotten_; }  // that can no longer be undone

 private:
  void trim();

  std::deque<Step> done_, undone_;  // the latest last
  std::size_t bytes_ = 0, limit_ = std::size_t{256} << 20;
  Vec<Command> forgotten_;
};

}  // namespace ts::api
