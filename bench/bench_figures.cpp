#include "bench/bench_figures.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace ts::bench {

void Figures::set(const std::string &name, double value) {
  for (auto &[n, v] : all_)
    if (n == name) {
      v = value;
      return;
    }
  all_.emplace_back(name, value);
}

double Figures::get(const std::string &name) const {
  for (const auto &[n, v] : all_)
    if (n == name) return v;
  return not_measured;
}

void Figures::add(const Figures &other) {
  for (const auto &[n, v] : other.all_) set(n, v);
}

double Samples::quantile(double q) const {
  if (ms_.empty()) return not_measured;
  std::vector<double> sorted(ms_);
  std::sort(sorted.begin(), sorted.end());
  const double at = q * static_cast<double>(sorted.size() - 1);
  const auto low = static_cast<std::size_t>(at);
  const std::size_t high = std::min(low + 1, sorted.size() - 1);
  return sorted[low] + (at - static_cast<double>(low)) * (sorted[high] - sorted[low]);
}

namespace {

// A line a figure; a line that begins with ! is the reason of a failure.
void send(int pipe, const std::string &line) {
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t n = write(pipe, line.data() + done, line.size() - done);
    if (n <= 0) return;
    done += static_cast<std::size_t>(n);
  }
}

void report(int pipe, const std::function<void(Figures &)> &work) {
  try {
    Figures figures;
    work(figures);
    for (const auto &[name, value] : figures.all()) {
      char number[64];
      std::snprintf(number, sizeof number, " %.17g\n", value);
      send(pipe, name + number);
    }
  } catch (const std::exception &e) {
    send(pipe, std::string("!") + e.what() + "\n");
  }
}

}  // namespace

Figures in_child(const std::function<void(Figures &)> &work) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    close(ends[0]);
    report(ends[1], work);
    std::fflush(nullptr);
    _exit(0);
  }
  close(ends[1]);
  std::string text;
  char buffer[4096];
  for (ssize_t n = 0; (n = read(ends[0], buffer, sizeof buffer)) > 0;) text.append(buffer, static_cast<std::size_t>(n));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status))
    throw std::runtime_error("ended by signal " + std::to_string(WTERMSIG(status)) +
                             (WTERMSIG(status) == 9 ? ": out of memory?" : ""));
  Figures figures;
  for (std::size_t at = 0, end = 0; (end = text.find('\n', at)) != std::string::npos; at = end + 1) {
    const std::string line = text.substr(at, end - at);
    if (line.starts_with('!')) throw std::runtime_error(line.substr(1));
    const std::size_t space = line.find(' ');
    figures.set(line.substr(0, space), std::strtod(line.c_str() + space, nullptr));
  }
  return figures;
}

}  // namespace ts::bench
