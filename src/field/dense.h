// Dense kernels of the factorisation, chosen once for the processor at hand.
#pragma once

#include <cstddef>
#include <span>

namespace ts::field {

// Fronts are column-major, `ld` a multiple of 8 and columns aligned to 64 bytes; of the symmetric matrix the lower
// triangle is read and written, and what is above it is of no meaning before and after.
struct DenseKernels {
  // Eliminates the first k of m unknowns: columns 0..k-1 become those of the Cholesky factor, the rest what the
  // elimination leaves of the matrix. False if a pivot is not positive and finite.
  bool (*eliminate)(double *front, std::size_t ld, std::size_t m, std::size_t k);
  // panel L^-1 in place: `rows` x k, rows a multiple of 8; L lower triangular, its diagonal as `inverse`.
  void (*divide)(double *panel, std::size_t rows, std::size_t k, const double *l, std::size_t ld,
                 const double *inverse);
  // out[i k + j] = columns[i + j stride] for `rows` x k.
  void (*transpose)(const double *columns, std::size_t stride, std::size_t rows, std::size_t k, double *out);
  // out[j] = - sum over i < rows of panel[i k + j] x[place[i]], for k columns. Up to seven values behind the panel are
  // read, and nothing is made of them.
  void (*minus_product)(const double *panel, std::size_t rows, std::size_t k, const unsigned *place, const double *x,
                        double *out);
};

// Those that this processor runs, the simplest first. All of them do the same multiplications and additions in the same
// order and never fused, so every processor gives the same bytes.
std::span<const DenseKernels *const> runnable_dense_kernels();

const DenseKernels &dense_kernels();  // the last of them

}  // namespace ts::field
