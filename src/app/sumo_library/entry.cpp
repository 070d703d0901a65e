#include "app/sumo_library/entry.hpp"

extern "C" pedzone::StartInProcess* const pedzone_start_in_process = &pedzone::start_in_process;
