// A SUMO that this process starts as another process, with room for other clients.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sumo/calls/session.hpp"

namespace pedzone {

struct OwnSumo {
  bool gui = false;     ///< sumo-gui instead of sumo
  double delay = 50.0;  ///< [ms] between steps in sumo-gui
  int port = 0;         ///< that it listens at; 0: one that is free
  int clients = 0;      ///< of others, with the orders 1, 2, ...; pedzone comes after them
  /// A shell's command that starts one more of them, the port as {port} in it; empty: none. It runs
  /// with pedzone's working directory and has no input.
  std::string client;

  int all_clients() const { return clients + (client.empty() ? 0 : 1); }
};

/// Starts SUMO with the configuration and the words for it, and the client, and joins SUMO. Both
/// are waited for, and killed where need be, with the session. A client that ends with an error
/// ends SUMO. Throws SumoError where either ends before SUMO can be joined.
std::unique_ptr<Session> start_own(const OwnSumo& own, const std::string& config,
                                   const std::vector<std::string>& words,
                                   const DesiredSpeeds& speeds);

}  // namespace pedzone
