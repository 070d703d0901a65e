// Built with -mavx2. Nothing here runs before the processor was asked.
#include "model/direction_kernel_impl.hpp"
#include "model/simd.hpp"

namespace pedzone {

const DirectionKernel* avx2_kernel() {
  using Impl = KernelImpl<simd::Float8>;
  static constexpr DirectionKernel kKernel{Impl::best_main, Impl::best_rest, Impl::times,
                                           Impl::times_of, "avx2"};
  return __builtin_cpu_supports("avx2") ? &kKernel : nullptr;
}

}  // namespace pedzone
