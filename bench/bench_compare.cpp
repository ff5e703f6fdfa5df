#include "bench/bench_compare.h"

#include <algorithm>

#include "bench/bench_solver.h"

namespace ts::bench {

Effort effort_for(std::size_t triangles, bool quick) {
  if (quick) return {2, 3, 1, true, 4e3, 1e3, 1e3};
  if (triangles <= 200000) return {3, 7, 2, true, 10e3, 2e3, 3e3};
  if (triangles <= 600000) return {4, 7, 2, true, 40e3, 6e3, 10e3};
  if (triangles <= 1200000) return {2, 3, 1, true, 40e3, 4e3, 10e3};
  return {1, 2, 1, false, 40e3, 4e3, 5e3};
}

Comparison::Comparison(const mesh::Surface &surface, const features::Features &features, const Effort &effort,
                       Figures &figures)
    : surface_(surface), problem_(make_problem(surface_, features)) {
  group_ = problem_.nodes.group[0];
  solver_ = make_solver(problem_);
  figures.set("unknowns", problem_.unknowns);
  if (!has_cholmod()) return;
  cholmod_.emplace();
  if (effort.choose) choose(figures);
}

// The ordering, and with two threads the loops, with which a click of (b) is quickest; and whether it is right.
void Comparison::choose(Figures &figures) {
  double best = 0;
  Ordering chosen = Ordering::standard;
  std::vector<double> u;
  for (const Ordering ordering : {Ordering::standard, Ordering::metis}) {
    cholmod_->set_ordering(ordering);
    const double ms = cholmod_->click(problem_, group_, &u).total();
    figures.set(ordering == Ordering::metis ? "b_metis_1t" : "b_standard_1t", ms);
    if (ordering == Ordering::standard || ms < best) best = ms, chosen = ordering;
  }
  figures.set("difference_b", difference(problem_, *solver_, group_, u));
  cholmod_->set_ordering(chosen);
  cholmod_->set_threads(2);
  double with_loops[2];
  for (const bool loops : {false, true}) {
    cholmod_->set_own_loops(loops);
    with_loops[loops] = cholmod_->click(problem_, group_).total();
  }
  cholmod_->set_own_loops(with_loops[1] < with_loops[0]);
  figures.set("b_metis", chosen == Ordering::metis);
  figures.set("b_own_loops", with_loops[1] < with_loops[0]);
}

void Comparison::Parts::add(const BaselineTimes &times) {
  total.add(times.total());
  assemble.add(times.assemble);
  analyse.add(times.analyse);
  factorise.add(times.factorise);
  solve.add(times.solve);
}

void Comparison::Parts::set(const std::string &name, Figures &figures) const {
  figures.set(name, total.median());
  figures.set(name + "_assemble", assemble.median());
  figures.set(name + "_analyse", analyse.median());
  figures.set(name + "_factorise", factorise.median());
  figures.set(name + "_solve", solve.median());
}

void Comparison::turn() {
  bandwidth_ = std::max(bandwidth_, triad_bandwidth());
  a_.add(click_with_eigen(problem_, group_));
  if (!cholmod_) return;
  for (const int threads : {1, 2}) {
    cholmod_->set_threads(threads);
    b_[threads - 1].add(cholmod_->click(problem_, group_));
  }
}

void Comparison::finish(const Effort &effort, Figures &figures) {
  a_.set("a", figures);
  b_[0].set("b_1t", figures);
  b_[1].set("b_2t", figures);
  // The clicks may use every core, so (b) may too.
  figures.set("b", std::min(b_[0].total.median(), b_[1].total.median()));

  figures.set("bandwidth", bandwidth_);
  figures.set("bound", figures.get("field_bytes") / bandwidth_ * 1e3);

  solver_.reset();
  Samples ours[2], theirs[2], analyse;
  LowerMatrix shared;
  if (cholmod_) {
    shared = assemble_shared(problem_);
    analyse.add(cholmod_->analyse(shared));
    cholmod_->factorise(shared);  // takes its memory
  }
  const Timer timer;
  while (ours[1].size() < effort.least || (ours[1].size() < effort.most && timer.ms() < effort.factor_ms))
    for (const int threads : {1, 2}) {
      ours[threads - 1].add(our_factorisation_ms(problem_, static_cast<unsigned>(threads)));
      if (!cholmod_) continue;
      cholmod_->set_threads(threads);
      theirs[threads - 1].add(cholmod_->factorise(shared));
    }
  figures.set("factor_1t", ours[0].median());
  figures.set("factor_2t", ours[1].median());
  figures.set("cholmod_analyse", analyse.median());
  figures.set("cholmod_factor_1t", theirs[0].median());
  figures.set("cholmod_factor_2t", theirs[1].median());
  figures.set("cholmod_values", cholmod_ ? cholmod_->factor_values() : not_measured);
}

}  // namespace ts::bench
