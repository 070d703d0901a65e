// For every x86-64 processor.
#include "model/direction_kernel_impl.hpp"
#include "model/discomfort_impl.hpp"
#include "model/sight_impl.hpp"
#include "model/simd.hpp"

namespace pedzone {

const DirectionKernel& baseline_kernel() {
  using Impl = KernelImpl<simd::Float4>;
  static constexpr DirectionKernel kKernel{"baseline", SightImpl<simd::Float4>::see, Impl::choose,
                                           Impl::times_of,
                                           DiscomfortImpl<simd::Float4>::discomfort};
  return kKernel;
}

}  // namespace pedzone
