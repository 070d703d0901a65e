#include "sumo/live/session.hpp"

#include "core/error.hpp"
#include "sumo/files/sumo_home.hpp"
#include "sumo/live/api.hpp"

namespace pedzone {
namespace {

/// Runs a call of SUMO's and turns whatever it throws into a SumoError.
template <typename Call>
auto translated(const std::string& doing, Call call) {
  try {
    return call();
  } catch (const std::exception& error) {
    throw SumoError("SUMO failed " + doing + ": " + error.what());
  } catch (...) {
    throw SumoError("SUMO failed " + doing);
  }
}

}  // namespace

Session::Session(const Scenario& scenario, const std::vector<std::string>& more_options) {
  find_sumo_data();
  std::vector<std::string> command{"sumo", "-c", scenario.config, "--no-step-log", "true"};
  command.insert(command.end(), scenario.sumo_options.begin(), scenario.sumo_options.end());
  command.insert(command.end(), more_options.begin(), more_options.end());
  translated("to start " + scenario.config, [&] { api::Simulation::start(command); });
  open_ = true;
}

Session::~Session() {
  try {
    close();
  } catch (...) {  // a destructor must not throw; an explicit close() reports
  }
}

void Session::step() {
  translated("in the step after " + std::to_string(time()) + " s", [] { api::Simulation::step(); });
}

void Session::close() {
  if (!open_) return;
  open_ = false;
  translated("to close", [] { api::Simulation::close(); });
}

double Session::time() const { return api::Simulation::getTime(); }
double Session::step_length() const { return api::Simulation::getDeltaT(); }
double Session::end_time() const { return api::Simulation::getEndTime(); }
bool Session::nobody_left() const { return api::Simulation::getMinExpectedNumber() <= 0; }
long Session::departed_persons() const { return api::Simulation::getDepartedPersonNumber(); }
long Session::arrived_persons() const { return api::Simulation::getArrivedPersonNumber(); }

SumoEvents Session::events() const {
  SumoEvents events;
  events.teleports = api::Simulation::getStartingTeleportNumber();
  events.emergency_stops = api::Simulation::getEmergencyStoppingVehiclesNumber();
  for (const auto& collision : api::Simulation::getCollisions()) {
    events.collisions.push_back({collision.collider, collision.victim});
  }
  return events;
}

std::string Session::option(const std::string& name) const {
  return translated("to tell option " + name, [&] { return api::Simulation::getOption(name); });
}

}  // namespace pedzone
