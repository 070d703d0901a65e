#include "sumo/live/person_colour.hpp"

namespace pedzone {

void PersonColour::show(SumoPersons& sumo, const std::string& person, Activity activity) {
  if (activity == shown_) return;
  shown_ = activity;
  if (!own_) own_ = sumo.colour(person);
  const auto& [red, green, blue] = info_of(activity).colour;
  sumo.set_colour(person, activity == Activity::kNone ? *own_ : TraciColour{red, green, blue});
}

}  // namespace pedzone
