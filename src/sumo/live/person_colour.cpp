#include "sumo/live/person_colour.hpp"

#include "sumo/live/api.hpp"

namespace pedzone {

void PersonColour::show(const std::string& person, Pastime pastime) {
  if (pastime == shown_) return;
  shown_ = pastime;
  if (!own_) own_ = api::Person::getColor(person);
  const auto& [red, green, blue] = info_of(pastime).colour;
  api::Person::setColor(person,
                        pastime == Pastime::kNone ? *own_ : libsumo::TraCIColor(red, green, blue));
}

}  // namespace pedzone
