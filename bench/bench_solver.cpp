#include "bench/bench_solver.h"

#include "bench/bench_figures.h"

namespace ts::bench {
namespace {

template <class Times>
double basis_of(const Times &times) {
  if constexpr (requires { times.basis; })
    return times.basis;
  else
    return not_measured;
}

}  // namespace

std::unique_ptr<const field::Solver> make_solver(const Problem &problem) {
  return std::make_unique<const field::Solver>(*problem.surface, problem.weight, problem.nodes, Executor(1));
}

double our_factorisation_ms(const Problem &problem, unsigned threads) {
  const Executor executor(threads);
  return field::Solver(*problem.surface, problem.weight, problem.nodes, executor).elimination_ms();
}

double basis_ms(const ts_prepare_times &times) {
  return basis_of(times);
}

}  // namespace ts::bench
