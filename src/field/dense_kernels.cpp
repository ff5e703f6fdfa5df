// Compiled once for each kind of processor, under the name TS_KERNELS. Includes nothing that defines functions: the
// linker may keep any translation unit's copy of an inline function, and one with instructions of a newer processor
// would be the end on an older one. Vectors are as wide as a register: of wider ones GCC makes no two registers, but
// goes by way of memory. How wide they are changes no bit: no sum crosses a vector.
#include "field/dense.h"

namespace ts::field::TS_KERNELS {
namespace {

using std::size_t;
constexpr size_t kLanes = TS_LANES;  // doubles in a register: 2, 4 or 8
typedef double Lanes __attribute__((vector_size(8 * kLanes), may_alias));

// NOLINTNEXTLINE(readability-non-const-parameter): written to by way of what is returned
inline __attribute__((always_inline)) Lanes &at(double *p) {
  return *reinterpret_cast<Lanes *>(p);
}
inline __attribute__((always_inline)) const Lanes &at(const double *p) {
  return *reinterpret_cast<const Lanes *>(p);
}

// The same where they do not begin at a multiple of their size. Not by a type of less alignment: clang forgets that
// where a reference is returned.
inline __attribute__((always_inline)) Lanes loose(const double *p) {
  Lanes v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}
inline __attribute__((always_inline)) void put_loose(double *p, Lanes v) {
  __builtin_memcpy(p, &v, sizeof v);
}

constexpr size_t kBlock = 64;  // pivots taken at a time: 64 columns of a front stay in the second cache

// C -= A B for rows [row, ld) of W columns of the front from `column` on: A the columns [from, to), B their rows
// column... W.
template <size_t W>
inline __attribute__((always_inline)) void subtract(double *f, size_t ld, size_t row, size_t column, size_t from,
                                                    size_t to) {
  size_t i = row;
  for (; i + 2 * kLanes <= ld; i += 2 * kLanes) {
    double *const here = f + i + column * ld, *const next = here + kLanes;
    Lanes c[W][2];
    for (size_t q = 0; q < W; ++q) c[q][0] = at(here + q * ld), c[q][1] = at(next + q * ld);
    for (size_t p = from; p < to; ++p) {
      const double *a = f + p * ld;
      const Lanes x = at(a + i), y = at(a + i + kLanes);
      for (size_t q = 0; q < W; ++q) {
        const double b = a[column + q];
        c[q][0] -= x * b;
        c[q][1] -= y * b;
      }
    }
    for (size_t q = 0; q < W; ++q) at(here + q * ld) = c[q][0], at(next + q * ld) = c[q][1];
  }
  for (; i < ld; i += kLanes) {
    Lanes c[W];
    for (size_t q = 0; q < W; ++q) c[q] = at(f + i + (column + q) * ld);
    for (size_t p = from; p < to; ++p) {
      const double *a = f + p * ld;
      const Lanes x = at(a + i);
      for (size_t q = 0; q < W; ++q) c[q] -= x * a[column + q];
    }
    for (size_t q = 0; q < W; ++q) at(f + i + (column + q) * ld) = c[q];
  }
}

void subtract(double *f, size_t ld, size_t column, size_t width, size_t from, size_t to) {
  const size_t row = column & ~size_t{7};
  switch (width) {
    case 1: return subtract<1>(f, ld, row, column, from, to);
    case 2: return subtract<2>(f, ld, row, column, from, to);
    case 3: return subtract<3>(f, ld, row, column, from, to);
    default: return subtract<4>(f, ld, row, column, from, to);
  }
}

// The columns [column, column + width), updated by all before them, become columns of the factor.
bool finish(double *f, size_t ld, size_t column, size_t width) {
  for (size_t j = column; j < column + width; ++j) {
    double *c = f + j * ld;
    if (!(c[j] > 0 && c[j] <= __DBL_MAX__)) return false;
    const double root = __builtin_sqrt(c[j]), inverse = 1 / root;
    for (size_t i = j & ~size_t{7}; i < ld; i += kLanes) at(c + i) *= inverse;
    c[j] = root;
    for (size_t q = j + 1; q < column + width; ++q) {
      double *d = f + q * ld;
      const double b = c[q];
      for (size_t i = j & ~size_t{7}; i < ld; i += kLanes) at(d + i) -= at(c + i) * b;
    }
  }
  return true;
}

bool eliminate(double *f, size_t ld, size_t m, size_t k) {
  for (size_t block = 0; block < k; block += kBlock) {
    const size_t end = block + kBlock < k ? block + kBlock : k;
    for (size_t j = block; j < end; j += 4) {
      const size_t width = j + 4 < end ? 4 : end - j;
      subtract(f, ld, j, width, block, j);
      if (!finish(f, ld, j, width)) return false;
    }
    for (size_t j = end; j < m; j += 4) subtract(f, ld, j, j + 4 < m ? 4 : m - j, block, end);
  }
  return true;
}

// Columns [column, column + W) less what the later ones take of them, then through their own triangle.
template <size_t W>
inline __attribute__((always_inline)) void divide(double *panel, size_t rows, size_t column, size_t k, const double *l,
                                                  size_t ld, const double *inverse) {
  constexpr size_t V = kLanes < 8 ? 2 : 1;  // registers beside each other, of the eight rows that there are at least
  for (size_t i = 0; i < rows; i += V * kLanes) {
    Lanes c[W][V];
    for (size_t q = 0; q < W; ++q)
      for (size_t v = 0; v < V; ++v) c[q][v] = at(panel + i + v * kLanes + (column + q) * rows);
    for (size_t p = column + W; p < k; ++p) {
      const double *const x = panel + i + p * rows;
      for (size_t q = 0; q < W; ++q)
        for (size_t v = 0; v < V; ++v) c[q][v] -= at(x + v * kLanes) * l[p + (column + q) * ld];
    }
    for (size_t q = W; q-- > 0;)
      for (size_t v = 0; v < V; ++v) {
        for (size_t p = q + 1; p < W; ++p) c[q][v] -= c[p][v] * l[column + p + (column + q) * ld];
        c[q][v] *= inverse[column + q];
      }
    for (size_t q = 0; q < W; ++q)
      for (size_t v = 0; v < V; ++v) at(panel + i + v * kLanes + (column + q) * rows) = c[q][v];
  }
}

void divide(double *panel, size_t rows, size_t k, const double *l, size_t ld, const double *inverse) {
  size_t column = k;
  for (; column >= 4; column -= 4) divide<4>(panel, rows, column - 4, k, l, ld, inverse);
  while (column-- > 0) divide<1>(panel, rows, column, k, l, ld, inverse);
}

// out[j] = - sum over i < rows of panel[i k + j] x[place[i]] for `width` of C columns; those beyond are read, and left
// where they are. `chains` sums a column, so that additions overlap.
template <size_t C, size_t chains>
inline __attribute__((always_inline)) void minus_product(const double *panel, size_t rows, size_t k,
                                                         const unsigned *place, const double *x, size_t width,
                                                         double *out) {
  constexpr size_t V = C / kLanes;
  Lanes s[chains][V] = {};
  size_t i = 0;
  for (; i + chains <= rows; i += chains)
    for (size_t c = 0; c < chains; ++c) {
      const double y = x[place[i + c]];
      for (size_t v = 0; v < V; ++v) s[c][v] -= loose(panel + (i + c) * k + kLanes * v) * y;
    }
  for (size_t c = 0; i < rows; ++i, ++c) {
    const double y = x[place[i]];
    for (size_t v = 0; v < V; ++v) s[c][v] -= loose(panel + i * k + kLanes * v) * y;
  }
  for (size_t c = 1; c < chains; ++c)
    for (size_t v = 0; v < V; ++v) s[0][v] += s[c][v];
  for (size_t v = 0; v < V; ++v)
    if (kLanes * (v + 1) <= width)
      put_loose(out + kLanes * v, s[0][v]);
    else
      for (size_t j = kLanes * v; j < width; ++j) out[j] = s[0][v][j - kLanes * v];
}

// The same for `width` of E times eight columns, as many at a time as there are registers for their sums.
template <size_t E, size_t chains>
inline __attribute__((always_inline)) void minus_product_of(const double *panel, size_t rows, size_t k,
                                                            const unsigned *place, const double *x, size_t width,
                                                            double *out) {
  constexpr size_t C = kLanes > 2 ? 8 * E : 16 / chains;
  for (size_t j = 0; j < width; j += C) minus_product<C, chains>(panel + j, rows, k, place, x, width - j, out + j);
}

void minus_product(const double *panel, size_t rows, size_t k, const unsigned *place, const double *x, double *out) {
  size_t j = 0;
  for (; j + 32 <= k; j += 32) minus_product_of<4, 1>(panel + j, rows, k, place, x, 32, out + j);
  const size_t width = k - j;
  if (width > 24)
    minus_product_of<4, 1>(panel + j, rows, k, place, x, width, out + j);
  else if (width > 16)
    minus_product_of<3, 2>(panel + j, rows, k, place, x, width, out + j);
  else if (width > 8)
    minus_product_of<2, 2>(panel + j, rows, k, place, x, width, out + j);
  else if (width > 0)
    minus_product_of<1, 4>(panel + j, rows, k, place, x, width, out + j);
}

// Eight rows at a time, which is a line of each column.
void transpose(const double *columns, size_t stride, size_t rows, size_t k, double *out) {
  for (size_t i = 0; i < rows; i += 8) {
    const size_t end = i + 8 < rows ? i + 8 : rows;
    for (size_t j = 0; j < k; ++j)
      for (size_t r = i; r < end; ++r) out[r * k + j] = columns[r + j * stride];
  }
}

}  // namespace

extern const DenseKernels kernels;
const DenseKernels kernels = {eliminate, divide, transpose, minus_product};

}  // namespace ts::field::TS_KERNELS
