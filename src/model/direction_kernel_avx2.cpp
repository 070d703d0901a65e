// Built with -mavx2. Nothing here runs before has_avx2() was asked.
#include "model/direction_kernel_impl.hpp"
#include "model/discomfort_impl.hpp"
#include "model/priced_choice_impl.hpp"
#include "model/sight_impl.hpp"
#include "model/simd.hpp"

namespace pedzone {

const DirectionKernel& avx2_kernel() {
  using Vector = simd::Float8;
  using Impl = KernelImpl<Vector>;
  static constexpr DirectionKernel kKernel{"avx2",         SightImpl<Vector>::see,
                                           Impl::choose,   PricedChoiceImpl<Vector>::choose,
                                           Impl::times_of, DiscomfortImpl<Vector>::discomfort};
  return kKernel;
}

}  // namespace pedzone
