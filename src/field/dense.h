// Dense kernels of the factorisation, chosen once for the processor at hand.
#pragma once

#include <cstddef>

namespace ts::field {

// Fronts are column-major, `ld` a multiple of 8 and columns aligned to 64 bytes; of the symmetric matrix the lower
// triangle is read and written, and what is above it is of no meaning before and after.
struct DenseKernels {
  // Eliminates the first k of m unknowns: columns 0..k-1 become those of the Cholesky factor, the rest what the
  // elimination leaves of the matrix. False if a pivot is not positive.
  bool (*eliminate)(double *front, std::size_t ld, std::size_t m, std::size_t k);
  // panel L^-1 in place: `rows` x k, rows a multiple of 8; L lower triangular, its diagonal as `inverse`.
  void (*divide)(double *panel, std::size_t rows, std::size_t k, const double *l, std::size_t ld,
                 const double *inverse);
  // t[j] = - sum over i < rows of panel[i + j rows] x[i], for k columns; rows is a multiple of 8, panel and x aligned.
  void (*minus_dots)(const double *panel, std::size_t rows, std::size_t k, const double *x, double *t);
};

// All of them do the same multiplications and additions in the same order, eight at a time and never fused, so every
// processor gives the same bytes.
const DenseKernels &dense_kernels();

}  // namespace ts::field
