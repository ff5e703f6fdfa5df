#include "field/dense.h"

namespace ts::field {

namespace plain {
extern const DenseKernels kernels;
}
#ifdef TS_X86_KERNELS
namespace avx2 {
extern const DenseKernels kernels;
}
namespace avx512 {
extern const DenseKernels kernels;
}
#endif

std::span<const DenseKernels *const> runnable_dense_kernels() {
#ifdef TS_X86_KERNELS
  static const DenseKernels *const all[] = {&plain::kernels, &avx2::kernels, &avx512::kernels};
  static const std::size_t count = __builtin_cpu_supports("avx512f") ? 3 : __builtin_cpu_supports("avx2") ? 2 : 1;
  return {all, count};
#else
  static const DenseKernels *const all[] = {&plain::kernels};
  return all;
#endif
}

const DenseKernels &dense_kernels() {
  static const DenseKernels &best = *runnable_dense_kernels().back();
  return best;
}

}  // namespace ts::field
