// Progress and cancellation, handed down by value: a Progress is a share [from, to] of a whole, with a stage's name.
#pragma once

#include "base/error.h"

namespace ts {

class Monitor {
 public:
  virtual ~Monitor() = default;
  // False = stop. May be called from any thread.
  virtual bool proceed(double fraction, const char *stage) noexcept = 0;
  // Whether it has been told to stop, and the stage that was reported last (base/stop.h). Any thread, many at a time.
  virtual bool stopped() const noexcept { return false; }
  virtual const char *stage() const noexcept { return "work"; }
};

class Progress {
 public:
  Progress() = default;  // reports to nobody and is never cancelled
  explicit Progress(Monitor *monitor) : monitor_(monitor) {}

  // The part [from, to] of this one (both in [0, 1]); `stage` is a literal.
  Progress part(double from, double to, const char *stage) const {
    Progress p = *this;
    p.from_ = at(from);
    p.to_ = at(to);
    p.stage_ = stage;
    return p;
  }

  const Monitor *monitor() const noexcept { return monitor_; }

  // Reports that `fraction` of this part is done; throws Error{cancelled} if the work is to stop.
  void operator()(double fraction) const {
    if (monitor_ && !monitor_->proceed(at(fraction), stage_))
      throw Error(Fault::cancelled, std::string("cancelled during ") + stage_);
  }

 private:
  double at(double fraction) const { return from_ + (to_ - from_) * fraction; }

  Monitor *monitor_ = nullptr;
  double from_ = 0, to_ = 1;
  const char *stage_ = "work";
};

}  // namespace ts
