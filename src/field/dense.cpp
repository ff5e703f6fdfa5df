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

const DenseKernels &dense_kernels() {
#ifdef TS_X86_KERNELS
  static const DenseKernels &best = __builtin_cpu_supports("avx512f") ? avx512::kernels
                                    : __builtin_cpu_supports("avx2")  ? avx2::kernels
                                                                      : plain::kernels;
  return best;
#else
  return plain::kernels;
#endif
}

}  // namespace ts::field
