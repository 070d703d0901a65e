// Counts what operator new gives out, to test that what is called in every step allocates nothing.
#pragma once

namespace pedzone::shapes {

long allocations();

}  // namespace pedzone::shapes
