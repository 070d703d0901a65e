#include "model/direction_kernel.hpp"

namespace pedzone {

bool has_avx2() { return __builtin_cpu_supports("avx2") != 0; }

const DirectionKernel& fastest_kernel() { return has_avx2() ? avx2_kernel() : baseline_kernel(); }

}  // namespace pedzone
