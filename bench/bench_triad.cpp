#include <algorithm>
#include <vector>

#include "bench/bench_run.h"

namespace ts::bench {

double triad_bandwidth() {
  // Three arrays of 128 MB: beyond any cache. Each element counts as read twice and written once, 24 bytes; what the
  // write allocates is not counted.
  constexpr std::size_t n = std::size_t{16} << 20;
  std::vector<double> a(n, 0), b(n, 1), c(n, 2);
  double best = 0;
  for (int repetition = 0; repetition < 8; ++repetition) {
    const double s = 1.0 + repetition;
    const double ms = ms_of([&] {
      double *const to = a.data();
      const double *const x = b.data(), *const y = c.data();
      for (std::size_t i = 0; i < n; ++i) to[i] = x[i] + s * y[i];
      // The values are wanted as far as the compiler can tell.
      asm volatile("" : : "r"(to) : "memory");
    });
    best = std::max(best, 24.0 * static_cast<double>(n) / ms * 1e3);
  }
  return best;
}

}  // namespace ts::bench
