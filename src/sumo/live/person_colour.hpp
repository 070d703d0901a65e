// What a person does is its colour in sumo-gui.
#pragma once

#include <optional>
#include <string>

#include "sumo/calls/persons.hpp"
#include "world/activities.hpp"

namespace pedzone {

class PersonColour {
 public:
  /// Colours the person by its activity, and as it was before once it has none.
  void show(SumoPersons& sumo, const std::string& person, Activity activity);

 private:
  Activity shown_ = Activity::kNone;
  std::optional<TraciColour> own_;
};

}  // namespace pedzone
