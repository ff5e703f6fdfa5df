// What ts-bench says in the end: tables, growth, targets, JSON.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bench/bench_figures.h"

namespace ts::bench {

struct Result {
  std::string name;
  unsigned size = 0;  // triangles as asked for; 0 = a real scan
  Figures figures;
  std::string failure;  // empty if all went well
};

struct Machine {
  std::string cpu, blas, openblas_coretype, openblas_l2;
  unsigned cores = 0;
};
Machine this_machine();

struct Target {
  std::string name;
  double value = not_measured;
  double goal = not_measured;  // at most; not_measured if it is only told
};

// Slope of log(figure) over log(triangles) from `from` triangles up, by least squares; not_measured below two sizes.
double growth(const std::vector<Result> &results, const std::string &figure, unsigned from);

// Figures that are times of the library, and its memory.
const std::vector<std::string> &grown_stages();

std::vector<Target> targets_of(const std::vector<Result> &results);

void print_result(const Result &result);
void print_growth(const std::vector<Result> &results);
void print_targets(const std::vector<Target> &targets);

// Throws std::runtime_error.
void write_json(const std::string &path, const Machine &machine, const std::vector<Result> &results,
                const std::vector<Target> &targets);

}  // namespace ts::bench
