#include <chrono>
#include <csignal>
#include <iostream>
#include <optional>
#include <thread>

#include "sumo/calls/both.hpp"
#include "sumo/calls/remembered.hpp"
#include "sumo/calls/wire.hpp"
#include "sumo/files/sumo_messages.hpp"

namespace pedzone {
namespace {

constexpr std::chrono::milliseconds kTryAgain{200};  // numerical

std::string name_of(const TraciAddress& address) {
  return address.host + ":" + std::to_string(address.port);
}

/// What a try to reach SUMO has led to.
struct Try {
  std::optional<std::pair<int, std::string>> version;
  bool answered = false;  ///< somebody listens there
};

/// Waits until SUMO has all its clients.
Try try_once(const TraciAddress& address) {
  const StreamLines silence(std::cout, [](const std::string&) {});  // libtraci tells each try
  try {
    return {libtraci::Simulation::init(address.port, 0, address.host), true};
  } catch (const std::exception& error) {
    // Could not connect: 1.15's libtraci writes to its socket all the same, 1.18's says so.
    const std::string_view what = error.what();
    const bool connected = what.find("send") == std::string_view::npos &&
                           what.find("Could not connect") == std::string_view::npos;
    return {std::nullopt, connected};
  }
}

std::pair<int, std::string> reach(const TraciAddress& address,
                                  const std::function<bool()>& may_come) {
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + std::chrono::duration<double>(address.patience);
  while (true) {
    const Try found = try_once(address);
    if (found.version) return *found.version;
    if (found.answered) {
      throw SumoError("What listens at " + name_of(address) +
                      " does not speak TraCI, or it is a SUMO that ended while it was loading.");
    }
    if (!may_come()) throw SumoError("SUMO ended while it was starting. What it said is above.");
    if (Clock::now() >= until) break;
    std::this_thread::sleep_for(kTryAgain);
  }
  throw SumoError("No SUMO listens at " + name_of(address) + " (tried for " +
                  std::to_string(static_cast<int>(address.patience)) +
                  " s). Start it with --remote-port " + std::to_string(address.port) +
                  " --num-clients N, and see that the port is the same.");
}

void take_place(const TraciAddress& address) {
  try {
    libtraci::Simulation::setOrder(address.order);
  } catch (const std::exception& error) {
    throw SumoError("SUMO refused order " + std::to_string(address.order) +
                    " for pedzone: " + error.what() +
                    " Each client has an order of its own: choose another one with --order. (This "
                    "SUMO ends now: it waits for clients that it has refused.)");
  }
}

}  // namespace

std::unique_ptr<Session> join_over_traci(const TraciAddress& address, const DesiredSpeeds& speeds,
                                         const std::function<bool()>& may_come) {
  // libtraci writes to a socket that SUMO has closed; that is an error to be told, no reason to
  // die.
  std::signal(SIGPIPE, SIG_IGN);
  const auto [api, program] = reach(address, may_come);
  if (api != libsumo::TRACI_VERSION) {
    throw SumoError(program + " at " + name_of(address) + " speaks version " + std::to_string(api) +
                    " of TraCI; pedzone is built with version " +
                    std::to_string(libsumo::TRACI_VERSION) + ".");
  }
  take_wire(address.port);
  take_place(address);
  remembered::know(speeds);
  return over_traci::session_calls();
}

}  // namespace pedzone
