// For every x86-64 processor.
#include "model/direction_kernel_impl.hpp"
#include "model/discomfort_impl.hpp"
#include "model/priced_choice_impl.hpp"
#include "model/sight_impl.hpp"
#include "model/simd.hpp"

namespace pedzone {

const DirectionKernel& baseline_kernel() {
  using Vector = simd::Float4;
  using Impl = KernelImpl<Vector>;
  static constexpr DirectionKernel kKernel{"baseline",     SightImpl<Vector>::see,
                                           Impl::choose,   PricedChoiceImpl<Vector>::choose,
                                           Impl::times_of, DiscomfortImpl<Vector>::discomfort};
  return kKernel;
}

}  // namespace pedzone
