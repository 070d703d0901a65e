// What this folder's sources, which are compiled once for each of SUMO's libraries, have of each
// other.
#pragma once

#include <exception>
#include <memory>
#include <string>

#include "core/error.hpp"
#include "sumo/calls/session.hpp"

namespace pedzone {

/// Runs a call of SUMO's and turns whatever it throws into a SumoError.
template <typename Call>
auto translated(const std::string& doing, Call call) {
  try {
    return call();
  } catch (const SumoError&) {
    throw;
  } catch (const std::exception& error) {
    throw SumoError("SUMO failed " + doing + ": " + error.what());
  } catch (...) {
    throw SumoError("SUMO failed " + doing);
  }
}

namespace in_process {
std::unique_ptr<SumoPersons> person_calls();
std::unique_ptr<SumoVehicles> vehicle_calls();
/// A SUMO that has been started.
std::unique_ptr<Session> session_calls();
}  // namespace in_process

namespace over_traci {
std::unique_ptr<SumoPersons> person_calls();
std::unique_ptr<SumoVehicles> vehicle_calls();
/// A SUMO that this process is connected to.
std::unique_ptr<Session> session_calls();
}  // namespace over_traci

}  // namespace pedzone
