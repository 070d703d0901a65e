#include "sumo/live/person_colour.hpp"

namespace pedzone {

void PersonColour::show(const std::string& person, Pastime pastime) {
  if (pastime == shown_) return;
  shown_ = pastime;
  if (!own_) own_ = sumo_person::colour(person);
  const auto& [red, green, blue] = info_of(pastime).colour;
  sumo_person::set_colour(person, pastime == Pastime::kNone ? *own_ : Colour{red, green, blue});
}

}  // namespace pedzone
