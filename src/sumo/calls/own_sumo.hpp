// A SUMO that this process starts as another process, with room for other clients.
#pragma once

#include <sys/types.h>

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
};

/// Starts SUMO with the configuration and the words for it, and joins it. It is closed, and killed
/// where need be, with the session. Throws SumoError where it ends before it can be joined.
std::unique_ptr<Session> start_own(const OwnSumo& own, const std::string& config,
                                   const std::vector<std::string>& words,
                                   const DesiredSpeeds& speeds);

}  // namespace pedzone
