// The brute-force twin of the direction kernels: plain scalar code that tries everything on every
// direction, with the same single-precision arithmetic a contact.
#pragma once

#include "model/direction_kernel.hpp"

namespace pedzone::test {

const DirectionKernel& twin_kernel();

}  // namespace pedzone::test
