#include "bench/bench_baselines.h"

#include <Eigen/SparseCholesky>
#include <stdexcept>

namespace ts::bench {

BaselineTimes click_with_eigen(const Problem &problem, mesh::Index group, std::vector<double> *u) {
  using Sparse = Eigen::SparseMatrix<double>;
  BaselineTimes times;
  ClickSystem system;
  times.assemble = ms_of([&] { system = assemble_click(problem, group); });
  const LowerMatrix &m = system.matrix;
  const Eigen::Map<const Sparse> view(m.n, m.n, static_cast<int>(m.row.size()), m.start.data(), m.row.data(),
                                      m.value.data());
  const Sparse matrix = view;  // the solver takes no map; not timed
  Eigen::SimplicialLDLT<Sparse, Eigen::Lower> solver;
  times.analyse = ms_of([&] { solver.analyzePattern(matrix); });
  times.factorise = ms_of([&] { solver.factorize(matrix); });
  if (solver.info() != Eigen::Success) throw std::runtime_error("baseline (a) could not factorise");
  const Eigen::Map<const Eigen::VectorXd> right(system.right.data(), m.n);
  Eigen::VectorXd x;
  times.solve = ms_of([&] { x = solver.solve(right); });
  if (u) u->assign(x.data(), x.data() + x.size());
  return times;
}

}  // namespace ts::bench
