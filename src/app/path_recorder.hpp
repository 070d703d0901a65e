// People's and vehicles' paths through the zones, thinned, for the picture of a run.
#pragma once

#include <string>
#include <unordered_map>

#include "sumo/simulation.hpp"
#include "view/zone_svg.hpp"

namespace pedzone {

class PathRecorder {
 public:
  /// Call after each step.
  void observe(const Simulation& simulation);
  /// The zones with everybody's path over them, as SVG.
  std::string picture(const Simulation& simulation) const;

 private:
  struct Track {
    double last_seen = 0.0;  ///< [s]
    Polyline line;           ///< [m]
  };
  std::unordered_map<std::string, Track> tracks_;  ///< of the stretch each person walks now
  std::vector<Polyline> finished_;
};

}  // namespace pedzone
