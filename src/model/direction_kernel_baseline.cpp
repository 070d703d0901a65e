#include "model/direction_kernel_impl.hpp"
#include "model/simd.hpp"

namespace pedzone {

const DirectionKernel& baseline_kernel() {
  using Impl = KernelImpl<simd::Float4>;
  static constexpr DirectionKernel kKernel{Impl::best_main, Impl::best_rest, Impl::times,
                                           Impl::times_of, "baseline"};
  return kKernel;
}

const DirectionKernel& fastest_kernel() {
  const DirectionKernel* avx2 = avx2_kernel();
  return avx2 != nullptr ? *avx2 : baseline_kernel();
}

}  // namespace pedzone
