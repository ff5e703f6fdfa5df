// The only place where ts-bench looks into field::Solver: change it here when the solver changes.
#pragma once

#include "bench/bench_problem.h"
#include "toothseg.h"

namespace ts::bench {

// Milliseconds of one numeric factorisation of the library with `threads` threads.
double our_factorisation_ms(const Problem &problem, unsigned threads);

std::unique_ptr<const field::Solver> make_solver(const Problem &problem);

// Of ts_prepare_times: the basis of the clicks; not_measured while the library tells of none.
double basis_ms(const ts_prepare_times &times);

}  // namespace ts::bench
