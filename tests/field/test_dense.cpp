#include <doctest/doctest.h>

#include <cstring>
#include <random>

#include "base/memory.h"
#include "field/dense.h"

using namespace ts;
using namespace ts::field;

namespace {

struct alignas(64) Line {
  double x[8];
};

// Columns of `ld` values that begin at multiples of 64 bytes.
struct Columns {
  Columns(std::size_t ld, std::size_t columns) : stride(ld), lines(ld * columns / 8 + 1) {}
  double *data() { return lines.front().x; }
  double &operator()(std::size_t i, std::size_t j) { return data()[i + j * stride]; }
  std::size_t stride;
  std::vector<Line> lines;
};

Columns positive_definite(std::size_t m, std::size_t ld, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  Columns a(ld, m);
  for (std::size_t j = 0; j < m; ++j)
    for (std::size_t i = 0; i < ld; ++i) a(i, j) = i >= m ? 0 : i == j ? 2.0 * static_cast<double>(m) : value(random);
  return a;
}

}  // namespace

TEST_CASE("every kind of kernel eliminates, and leaves the same bytes") {
  for (const std::size_t m : {1, 7, 8, 33, 70}) {
    const std::size_t ld = (m + 7) / 8 * 8, k = (2 * m + 2) / 3;
    const Columns matrix = positive_definite(m, ld, static_cast<unsigned>(m));
    Columns first(0, 0);
    for (const DenseKernels *kernels : runnable_dense_kernels()) {
      Columns front = matrix;
      REQUIRE(kernels->eliminate(front.data(), ld, m, k));
      if (kernels == runnable_dense_kernels().front()) {
        first = front;
        // L L^T is the matrix again, and the rest what is left of it.
        Columns again = matrix;
        for (std::size_t j = 0; j < m; ++j)
          for (std::size_t i = j; i < m; ++i) {
            double sum = j >= k ? front(i, j) : 0;
            for (std::size_t p = 0; p < std::min(k, j + 1); ++p) sum += front(i, p) * front(j, p);
            CHECK(sum == doctest::Approx(again(i, j)).epsilon(1e-12));
          }
      } else {
        for (std::size_t j = 0; j < m; ++j)
          CHECK(std::memcmp(&front(j, j), &first(j, j), (m - j) * sizeof(double)) == 0);
      }
      front(0, 0) = -1;
      CHECK(!kernels->eliminate(front.data(), ld, m, 1));
    }
  }
}

TEST_CASE("every kind of kernel divides and multiplies to the same bytes") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> value(-1, 1);
  for (const std::size_t k :
       {1, 2, 3, 4, 7, 8, 9, 16, 17, 24, 25, 31, 32, 33, 41, 57, 64, 70}) {  // all widths of a tile
    const std::size_t ld = (k + 7) / 8 * 8, rows = 24;
    Columns l = positive_definite(k, ld, 3);
    REQUIRE(dense_kernels().eliminate(l.data(), ld, k, k));
    std::vector<double> inverse(k), x(100);
    for (std::size_t j = 0; j < k; ++j) inverse[j] = 1 / l(j, j);
    for (double &y : x) y = value(random);
    std::vector<unsigned> place(rows);
    for (unsigned &p : place) p = static_cast<unsigned>(random() % x.size());
    Columns panel(rows, k);
    for (std::size_t i = 0; i < rows * k; ++i) panel.data()[i] = value(random);
    std::vector<double> divided, transposed, product;
    for (const DenseKernels *kernels : runnable_dense_kernels()) {
      Columns p = panel;
      kernels->divide(p.data(), rows, k, l.data(), ld, inverse.data());
      const std::vector<double> d(p.data(), p.data() + rows * k);
      std::vector<double> t(rows * k + 8), y(k);
      kernels->transpose(p.data(), rows, rows - 1, k, t.data());
      kernels->minus_product(t.data(), rows - 1, k, place.data(), x.data(), y.data());
      if (kernels == runnable_dense_kernels().front()) {
        divided = d, transposed = t, product = y;
        for (std::size_t j = 0; j < k; ++j) {
          double back = 0, sum = 0;  // of row 2, and of column j
          for (std::size_t q = j; q < k; ++q) back += p(2, q) * l(q, j);
          for (std::size_t i = 0; i + 1 < rows; ++i) sum -= p(i, j) * x[place[i]];
          CHECK(back == doctest::Approx(panel(2, j)).epsilon(1e-10));
          CHECK(y[j] == doctest::Approx(sum).epsilon(1e-10));
        }
      }
      CHECK(d == divided);
      CHECK(t == transposed);
      CHECK(y == product);
    }
  }
}
