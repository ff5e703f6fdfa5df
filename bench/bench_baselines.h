// What the library is compared with: the paper's way of work with two solvers, and one factorisation of CHOLMOD.
#pragma once

#include <memory>
#include <string>

#include "bench/bench_figures.h"
#include "bench/bench_problem.h"

namespace ts::bench {

// Milliseconds of one click of a baseline.
struct BaselineTimes {
  double assemble = 0, analyse = 0, factorise = 0, solve = 0;
  double total() const { return assemble + analyse + factorise + solve; }
};

// (a): Eigen::SimplicialLDLT with its own ordering, anew for every click. `u` gets the field at the unknowns.
BaselineTimes click_with_eigen(const Problem &problem, mesh::Index group, std::vector<double> *u = nullptr);

// (b): CHOLMOD's supernodal LL^T. Not there where the benchmark was built without CHOLMOD.
bool has_cholmod();
std::string blas_in_use();

enum class Ordering { standard, metis };

class Cholmod {
 public:
  Cholmod();
  ~Cholmod();
  Cholmod(const Cholmod &) = delete;
  Cholmod &operator=(const Cholmod &) = delete;

  void set_threads(int threads);
  // CHOLMOD's own OpenMP loops beside the BLAS's threads; with one thread they never run.
  void set_own_loops(bool on);
  void set_ordering(Ordering ordering);

  BaselineTimes click(const Problem &problem, mesh::Index group, std::vector<double> *u = nullptr);

  // One analysis, then as many numeric factorisations as are asked for. ms each.
  double analyse(const LowerMatrix &matrix);
  double factorise(const LowerMatrix &matrix);
  // Values of the factor last analysed, zeros within supernodes included.
  double factor_values() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ts::bench
