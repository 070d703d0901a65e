// One running SUMO, in this process or at the other end of a TraCI connection: what it is asked
// and told. The exceptions of either are translated.
#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "sumo/calls/persons.hpp"
#include "sumo/calls/vehicles.hpp"
#include "sumo/files/desired_speeds.hpp"

namespace pedzone {

/// A running SUMO that this process had joined is no longer there: closed, or dead.
class ConnectionLost : public SumoError {
 public:
  using SumoError::SumoError;
};

/// What SUMO counted in its last step.
struct SumoEvents {
  /// Who hit whom.
  struct Collision {
    std::string by, victim;
    bool operator==(const Collision&) const = default;
  };
  long teleports = 0, emergency_stops = 0;
  std::vector<Collision> collisions;  ///< those that go on included
};

class Session {
 public:
  virtual ~Session() = default;

  virtual SumoPersons& persons() = 0;
  virtual SumoVehicles& vehicles() = 0;

  virtual void step() = 0;                 ///< throws SumoError, ConnectionLost
  virtual void close() = 0;                ///< flushes SUMO's outputs; throws SumoError
  virtual double time() const = 0;         ///< [s]
  virtual double step_length() const = 0;  ///< [s]
  virtual double end_time() const = 0;     ///< [s]; negative: until nobody is left
  virtual bool nobody_left() const = 0;
  virtual long departed_persons() const = 0;  ///< in the last step
  virtual long arrived_persons() const = 0;   ///< in the last step
  virtual SumoEvents events() const = 0;
  /// Whether what a call has thrown tells that SUMO is there no more.
  virtual bool is_lost(const std::exception& error) const = 0;
  /// An option's value as SUMO has it.
  virtual std::string option(const std::string& name) const = 0;
  /// Throws where SUMO has no such edge.
  virtual std::string edge_parameter(const std::string& edge, const std::string& key) const = 0;
  virtual void set_edge_parameter(const std::string& edge, const std::string& key,
                                  const std::string& value) = 0;
};

/// Starts SUMO in this process, one at a time: its state is global. Finds SUMO's data itself where
/// SUMO_HOME is not set. `words`: its options beside the configuration. Throws InputError where it
/// does not know them, else SumoError, with what SUMO said.
std::unique_ptr<Session> start_in_process(const std::string& config,
                                          const std::vector<std::string>& words);

/// Where a running SUMO listens (its option --remote-port).
struct TraciAddress {
  std::string host = "localhost";
  int port = 8813;
  int order = 1;         ///< of this client among those of SUMO; SUMO serves the lowest first
  double patience = 30;  ///< [s] for SUMO to be there
};

/// Becomes a client of a running SUMO. `speeds`: of its scenario; `may_come`:
/// whether it is worth while to wait on. Throws SumoError where it is not
/// there in time, speaks another version of TraCI, or has such a client already.
std::unique_ptr<Session> join_over_traci(
    const TraciAddress& address, const DesiredSpeeds& speeds,
    const std::function<bool()>& may_come = [] { return true; });

/// Ends the connection from another thread: a call that waits for SUMO then throws.
void hang_up();

}  // namespace pedzone
