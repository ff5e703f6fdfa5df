// What ts-bench measures of one scan: named numbers, in the order in which they were found.
#pragma once

#include <chrono>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace ts::bench {

inline constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

class Figures {
 public:
  void set(const std::string &name, double value);
  double get(const std::string &name) const;  // not_measured if it was never set
  void add(const Figures &other);
  const std::vector<std::pair<std::string, double>> &all() const { return all_; }

 private:
  std::vector<std::pair<std::string, double>> all_;
};

// Repetitions of one measurement, ms.
class Samples {
 public:
  void add(double ms) { ms_.push_back(ms); }
  std::size_t size() const { return ms_.size(); }
  double quantile(double q) const;  // not_measured without samples
  double median() const { return quantile(0.5); }

 private:
  std::vector<double> ms_;
};

class Timer {
 public:
  // Milliseconds since made.
  double ms() const { return std::chrono::duration<double, std::milli>(Clock::now() - begin_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_ = Clock::now();
};

template <class Work>
double ms_of(Work &&work) {
  const Timer timer;
  work();
  return timer.ms();
}

// Runs `work` in a forked process, so that its memory is its own, and hands back what it set. Throws
// std::runtime_error with the reason where the child failed. The calling process must have no threads.
Figures in_child(const std::function<void(Figures &)> &work);

}  // namespace ts::bench
