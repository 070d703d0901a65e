// How fast persons go on a <walk> that says it (speed, duration), from a scenario's own files: SUMO
// does not tell through its API.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/xml_stream.hpp"

namespace pedzone {

class WalkSpeeds {
 public:
  /// Takes in the persons and personFlows of a route or additional file, which may be large. Those
  /// with a personTrip are left out: how many stages SUMO makes of it is not known. Throws
  /// InputError.
  void read(const std::string& file);

  /// [m/s] of a person whose present walk is `length` [m] long and is one of the last `stages_left`
  /// stages of its plan; nothing: the walk does not say.
  std::optional<double> of(const std::string& person, int stages_left, double length) const;

 private:
  /// What a stage says; 0: nothing.
  struct Stage {
    double speed = 0.0;     ///< [m/s]
    double duration = 0.0;  ///< [s]
  };
  struct Plan {
    std::string id;
    bool is_flow = false;
    std::vector<Stage> stages;
    bool has_trip = false;
  };

  static void add_stage(const XmlElement& element, Plan& plan);
  void keep(Plan plan);
  const std::vector<Stage>* stages_of(const std::string& person) const;

  /// By id, where a stage says something.
  std::unordered_map<std::string, std::vector<Stage>> persons_, flows_;
};

}  // namespace pedzone
