// Counts how often this program has asked for memory.
#pragma once

namespace pedzone::test {

long allocations();

}  // namespace pedzone::test
