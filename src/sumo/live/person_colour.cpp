#include "sumo/live/person_colour.hpp"

namespace pedzone {

void PersonColour::show(const std::string& person, Activity activity) {
  if (activity == shown_) return;
  shown_ = activity;
  if (!own_) own_ = sumo_person::colour(person);
  const auto& [red, green, blue] = info_of(activity).colour;
  sumo_person::set_colour(person,
                          activity == Activity::kNone ? *own_ : TraciColour{red, green, blue});
}

}  // namespace pedzone
