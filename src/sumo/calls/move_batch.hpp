// Many persons moved by one message to SUMO and its answer. libtraci sends one message a call;
// TraCI lets a message hold any number of commands (https://sumo.dlr.de/docs/TraCI/Protocol.html).
#pragma once

#include <string>

namespace pedzone {

/// Collects commands moveToXY for persons, as TraCI has them on the wire.
class MoveBatch {
 public:
  void add(const std::string& person, double x, double y, double angle, int keep_route,
           double match_threshold);
  bool empty() const { return count_ == 0; }

  /// Sends all of them over the wire, waits for the answer, and starts anew. Throws
  /// std::runtime_error where the connection ends, and with SUMO's words where it refuses one.
  void send();

 private:
  std::string commands_;
  std::size_t count_ = 0;
};

}  // namespace pedzone
