// CHOLMOD, where it is there; only the benchmark ever links it.
#include <dlfcn.h>

#include <algorithm>
#include <stdexcept>

#include "bench/bench_baselines.h"

#ifdef TOOTHSEG_BENCH_CHOLMOD
#include <cholmod.h>

namespace ts::bench {
namespace {

template <class Function>
Function symbol(const char *name) {
  return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}

// Of CHOLMOD's own OpenMP loops, some a supernode.
int loop_threads = 1;

}  // namespace

// Takes the place of libgomp's function of that name. CHOLMOD asks for a fixed number of threads, more than there may
// be cores, and libgomp's teams, also those of one thread, cost it a fifth of its time on a scan: with one thread the
// loop is a plain call here, and with more it gets as many as were set.
extern "C" __attribute__((visibility("default"))) void GOMP_parallel(void (*loop)(void *), void *data, unsigned threads,
                                                                     unsigned flags) {
  using Function = void (*)(void (*)(void *), void *, unsigned, unsigned);
  static const auto original = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "GOMP_parallel"));
  if (loop_threads > 1 && original)
    original(loop, data, std::min(threads, static_cast<unsigned>(loop_threads)), flags);
  else
    loop(data);
}

struct Cholmod::Impl {
  cholmod_common common;
  cholmod_factor *factor = nullptr;
  bool own_loops = false;
  int threads = 1;

  Impl() { cholmod_start(&common); }
  ~Impl() {
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }

  void need(bool right, const char *what) const {
    if (!right || common.status < CHOLMOD_OK)
      throw std::runtime_error(std::string("CHOLMOD: ") + what + ", status " + std::to_string(common.status));
  }

  // Shares the arrays, which CHOLMOD does not write to.
  static cholmod_sparse view(const LowerMatrix &m) {
    cholmod_sparse s{};
    s.nrow = s.ncol = static_cast<std::size_t>(m.n);
    s.nzmax = m.row.size();
    s.p = const_cast<int *>(m.start.data());
    s.i = const_cast<int *>(m.row.data());
    s.x = const_cast<double *>(m.value.data());
    s.stype = -1;
    s.itype = CHOLMOD_INT;
    s.xtype = CHOLMOD_REAL;
    s.dtype = CHOLMOD_DOUBLE;
    s.sorted = s.packed = 1;
    return s;
  }

  void apply_threads() const {
    if (const auto set = symbol<void (*)(int)>("openblas_set_num_threads")) set(threads);
    loop_threads = own_loops ? threads : 1;
  }
};

bool has_cholmod() {
  return true;
}

std::string blas_in_use() {
  const auto config = symbol<char *(*)()>("openblas_get_config");
  return config ? config() : "reference BLAS";
}

Cholmod::Cholmod() : impl_(std::make_unique<Impl>()) {
  impl_->common.supernodal = CHOLMOD_SUPERNODAL;
  impl_->common.final_ll = 1;
  impl_->common.print = 0;
  impl_->apply_threads();
}
Cholmod::~Cholmod() = default;

void Cholmod::set_threads(int threads) {
  impl_->threads = threads;
  impl_->apply_threads();
}

void Cholmod::set_own_loops(bool on) {
  impl_->own_loops = on;
  impl_->apply_threads();
}

void Cholmod::set_ordering(Ordering ordering) {
  impl_->common.nmethods = ordering == Ordering::metis ? 1 : 0;
  impl_->common.method[0].ordering = ordering == Ordering::metis ? CHOLMOD_METIS : CHOLMOD_GIVEN;
}

BaselineTimes Cholmod::click(const Problem &problem, mesh::Index group, std::vector<double> *u) {
  BaselineTimes times;
  ClickSystem system;
  times.assemble = ms_of([&] { system = assemble_click(problem, group); });
  times.analyse = analyse(system.matrix);
  times.factorise = factorise(system.matrix);
  cholmod_dense right{};
  right.nrow = right.d = right.nzmax = system.right.size();
  right.ncol = 1;
  right.x = system.right.data();
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  cholmod_dense *x = nullptr;
  times.solve = ms_of([&] { x = cholmod_solve(CHOLMOD_A, impl_->factor, &right, &impl_->common); });
  impl_->need(x, "cholmod_solve");
  if (u) u->assign(static_cast<double *>(x->x), static_cast<double *>(x->x) + system.right.size());
  cholmod_free_dense(&x, &impl_->common);
  cholmod_free_factor(&impl_->factor, &impl_->common);
  return times;
}

double Cholmod::analyse(const LowerMatrix &matrix) {
  cholmod_free_factor(&impl_->factor, &impl_->common);
  cholmod_sparse a = Impl::view(matrix);
  const double ms = ms_of([&] { impl_->factor = cholmod_analyze(&a, &impl_->common); });
  impl_->need(impl_->factor, "cholmod_analyze");
  return ms;
}

double Cholmod::factorise(const LowerMatrix &matrix) {
  cholmod_sparse a = Impl::view(matrix);
  const double ms = ms_of([&] { cholmod_factorize(&a, impl_->factor, &impl_->common); });
  impl_->need(impl_->common.status == CHOLMOD_OK && impl_->factor->is_super, "cholmod_factorize");
  return ms;
}

double Cholmod::factor_values() const {
  return impl_->factor ? static_cast<double>(impl_->factor->xsize) : not_measured;
}

}  // namespace ts::bench

#else

namespace ts::bench {

struct Cholmod::Impl {};

bool has_cholmod() {
  return false;
}
std::string blas_in_use() {
  return "none";
}
Cholmod::Cholmod() {
  throw std::runtime_error("built without CHOLMOD");
}
Cholmod::~Cholmod() = default;
void Cholmod::set_threads(int) {}
void Cholmod::set_own_loops(bool) {}
void Cholmod::set_ordering(Ordering) {}
BaselineTimes Cholmod::click(const Problem &, mesh::Index, std::vector<double> *) {
  return {};
}
double Cholmod::analyse(const LowerMatrix &) {
  return not_measured;
}
double Cholmod::factorise(const LowerMatrix &) {
  return not_measured;
}
double Cholmod::factor_values() const {
  return not_measured;
}

}  // namespace ts::bench

#endif
