// One running SUMO: start, step, close, with its exceptions translated.
#pragma once

#include <string>
#include <vector>

namespace pedzone {

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
  /// Starts SUMO in this process. Finds SUMO's data itself where SUMO_HOME is not set.
  /// `words`: its options beside the configuration. Throws InputError where it does not know them,
  /// else SumoError, with what SUMO said.
  Session(const std::string& config, const std::vector<std::string>& words);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  void step();                 ///< throws SumoError
  void close();                ///< flushes SUMO's outputs; throws SumoError
  double time() const;         ///< [s]
  double step_length() const;  ///< [s]
  double end_time() const;     ///< [s]; negative: until nobody is left
  bool nobody_left() const;
  long departed_persons() const;  ///< in the last step
  long arrived_persons() const;   ///< in the last step
  SumoEvents events() const;
  /// An option's value as SUMO has it.
  std::string option(const std::string& name) const;

 private:
  bool open_ = false;
};

}  // namespace pedzone
