// What a person does is its colour in sumo-gui.
#pragma once

#include <libsumo/TraCIDefs.h>

#include <optional>
#include <string>

#include "world/activities.hpp"

namespace pedzone {

class PersonColour {
 public:
  /// Colours the person by its pastime, and as it was before once it has none.
  void show(const std::string& person, Pastime pastime);

 private:
  Pastime shown_ = Pastime::kNone;
  std::optional<libsumo::TraCIColor> own_;
};

}  // namespace pedzone
