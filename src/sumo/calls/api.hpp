// The one place that names SUMO's API. libsumo (in this process) and libtraci (client of a running
// SUMO) declare the same calls under two names, and no source can include both: this folder's
// sources are compiled twice, in a namespace each. Only calls that both have are used.
#pragma once

#ifdef PEDZONE_OVER_TRACI
#include "sumo/calls/remembered.hpp"
#define PEDZONE_CALLS over_traci
namespace pedzone::api {
using namespace remembered;
using libtraci::Edge;
constexpr bool kRemote = true;  ///< SUMO can go away
}  // namespace pedzone::api
#else
#include <libsumo/libsumo.h>
#define PEDZONE_CALLS in_process
namespace pedzone::api {
using namespace libsumo;
constexpr bool kRemote = false;
}  // namespace pedzone::api
#endif
