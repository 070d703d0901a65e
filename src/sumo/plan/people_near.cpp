#include "sumo/plan/people_near.hpp"

namespace pedzone {

PeopleNear::PeopleNear(std::span<const PersonAhead> people) : people_(people) {
  std::vector<Vec2> places;
  places.reserve(people.size());
  for (const PersonAhead& person : people) places.push_back(person.position);
  places_.build(places);
}

std::vector<PersonAhead> PeopleNear::at(const Vec2& place, double reach) const {
  std::vector<PersonAhead> near;
  for (const std::uint32_t k : places_.within(place, reach)) near.push_back(people_[k]);
  return near;
}

}  // namespace pedzone
