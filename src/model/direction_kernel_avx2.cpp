// Built with -mavx2. Nothing here runs before has_avx2() was asked.
#include "model/direction_kernel_impl.hpp"
#include "model/discomfort_impl.hpp"
#include "model/sight_impl.hpp"
#include "model/simd.hpp"

namespace pedzone {

const DirectionKernel& avx2_kernel() {
  using Impl = KernelImpl<simd::Float8>;
  static constexpr DirectionKernel kKernel{"avx2", SightImpl<simd::Float8>::see, Impl::choose,
                                           Impl::times_of,
                                           DiscomfortImpl<simd::Float8>::discomfort};
  return kKernel;
}

}  // namespace pedzone
