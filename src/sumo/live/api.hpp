// The one place that names SUMO's API. libsumo (in process) and libtraci (client of a running
// SUMO) declare the same calls; only calls that both have are used in this folder.
#pragma once

#ifdef PEDZONE_LIBTRACI
#include <libsumo/libtraci.h>
namespace pedzone::api {
using namespace libtraci;
}
#else
#include <libsumo/libsumo.h>
namespace pedzone::api {
using namespace libsumo;
}
#endif
