#include "sumo/person_colour.hpp"

#include "sumo/api.hpp"

namespace pedzone {

void PersonColour::show(const std::string& person, Activity activity) {
  if (activity == shown_) return;
  shown_ = activity;
  if (!own_) own_ = api::Person::getColor(person);
  const auto& [red, green, blue] = info_of(activity).colour;
  api::Person::setColor(
      person, activity == Activity::kNone ? *own_ : libsumo::TraCIColor(red, green, blue));
}

}  // namespace pedzone
