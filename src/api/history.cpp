#include "api/history.h"

#include "base/error.h"

namespace ts::api {

void History::record(tooth::Session before, Command command, std::size_t bytes) {
  done_.push_back({std::move(before), std::move(command), bytes});
  for (const Step &s : undone_) bytes_ -= s.bytes;
  undone_.clear();
  bytes_ += bytes;
  trim();
}

const tooth::Session &History::before() const {
  if (done_.empty())
    throw Error(Fault::no_history,
                forgotten_.empty() ? "nothing was done yet" : "what was done before is no longer kept");
  return done_.back().state;
}

const tooth::Session &History::after() const {
  if (undone_.empty()) throw Error(Fault::no_history, "nothing was undone");
  return undone_.back().state;
}

void History::undo(tooth::Session &now) {
  undone_.push_back(std::move(done_.back()));
  done_.pop_back();
  std::swap(now, undone_.back().state);
}

void History::redo(tooth::Session &now) {
  done_.push_back(std::move(undone_.back()));
  undone_.pop_back();
  std::swap(now, done_.back().state);
}

void History::set_limit(std::size_t bytes) {
  limit_ = bytes;
  trim();
}

void History::trim() {
  while (bytes_ > limit_ && !done_.empty()) {
    forgotten_.push_back(std::move(done_.front().command));
    bytes_ -= done_.front().bytes;
    done_.pop_front();
  }
}

}  // namespace ts::api
