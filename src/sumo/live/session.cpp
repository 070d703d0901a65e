#include "sumo/live/session.hpp"

#include <iostream>
#include <string_view>

#include "core/error.hpp"
#include "sumo/files/sumo_home.hpp"
#include "sumo/live/api.hpp"
#include "sumo/live/sumo_messages.hpp"

namespace pedzone {
namespace {

constexpr std::string_view kError = "Error: ";  // so SUMO begins its messages
constexpr std::string_view kBadOptions = "Could not parse commandline options";
constexpr std::string_view kBadNumber = "Invalid Number Format";  // of an option's value

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

Session::Session(const std::string& config, const std::vector<std::string>& words) {
  find_sumo_data();
  std::vector<std::string> command{"sumo", "-c", config};
  command.insert(command.end(), words.begin(), words.end());
  std::ostream before(std::cerr.rdbuf());
  std::string errors;  // and all that follows: an error can take several lines
  const StreamLines lines(std::cerr, [&](const std::string& line) {
    if (errors.empty() && !line.starts_with(kError)) {
      before << line << std::endl;
    } else {
      errors += "\n" + (line.starts_with(kError) ? line.substr(kError.size()) : line);
    }
  });
  try {
    api::Simulation::start(command);
  } catch (const std::exception& error) {
    const std::string_view what = error.what();
    if (what.starts_with(kBadOptions)) {
      throw InputError("SUMO does not understand its options:" + errors, {});
    }
    if (what.starts_with(kBadNumber)) {
      throw InputError("SUMO does not understand its options: " + std::string(what), {});
    }
    throw SumoError("SUMO failed to start " + config + ": " + error.what() + errors);
  } catch (...) {
    throw SumoError("SUMO failed to start " + config + errors);
  }
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
