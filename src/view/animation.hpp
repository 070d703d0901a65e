// A run, or several side by side, as one HTML page that plays it and needs nothing else: no
// network, no other file. Its sources are in view/animation.
#pragma once

#include <string>
#include <vector>

#include "results/place.hpp"
#include "results/recording.hpp"
#include "zone/shapes.hpp"

namespace pedzone {

struct AnimatedRun {
  std::string name;
  const Recording* recording;
};

struct AnimationOptions {
  std::string title;
  double rate = 5.0;  ///< [1/s] > 0 at most so many steps are kept
  Box area = {};      ///< [m] shown to begin with; empty: the zones, else where everybody goes
  std::string selected =
      {};  ///< a person whose way and numbers are shown to begin with; empty: nobody
};

/// The page. `place`: null where it is not known. In between the steps that are kept, the page
/// moves everybody evenly. Places are kept to 1 cm, headings to half a degree, speeds to 1 cm/s.
/// Throws InputError where something lies more than 20,000 km from the origin of the network.
std::string animation_page(const std::vector<AnimatedRun>& runs, const Place* place,
                           const AnimationOptions& options);

}  // namespace pedzone
