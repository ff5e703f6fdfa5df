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

field::Solver make_solver(const Problem &problem) {
  return field::Solver(*problem.surface, problem.weight, problem.nodes);
}

double our_factorisation_ms(const Problem &problem, unsigned /*threads*/) {
  // The solver tells no parts and knows no threads: all of its making, ordering included, stands for the numeric part.
  return ms_of([&] { make_solver(problem); });
}

double field_bytes(const field::Solver &solver) {
  return static_cast<double>(solver.factor_bytes());
}

double basis_ms(const ts_prepare_times &times) {
  return basis_of(times);
}

}  // namespace ts::bench
