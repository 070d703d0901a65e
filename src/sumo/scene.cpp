#include "sumo/scene.hpp"

#include "sumo/api.hpp"
#include "sumo/frames.hpp"

namespace pedzone {

Scene SceneReader::read(double time) {
  persons_.clear();
  vehicles_.clear();
  for (const FleetVehicle& vehicle : fleet_.vehicles()) {
    vehicles_.push_back({vehicle.id, vehicle.centre(), vehicle.heading, vehicle.velocity,
                         vehicle.traits.length, vehicle.traits.width});
  }
  for (const Guest& guest : takeover_.guests()) {
    const PersonView view = crowds_[guest.zone]->view(guest.handle);
    persons_.push_back({guest.id, view.position, view.velocity, view.heading, guest.radius, {}});
  }
  add_bystanders();
  return {time, persons_, vehicles_,
          [this](std::size_t person, std::size_t vehicle) { return aware(person, vehicle); }};
}

void SceneReader::add_bystanders() {
  std::vector<Bystander>& all = takeover_.bystanders().all();
  ridden_.clear();
  ridden_.reserve(all.size());  // samples point into it
  for (Bystander& person : all) {
    if (person.guest || !person.near) continue;
    ridden_.push_back(api::Person::getVehicle(person.id));
    if (person.radius == 0.0) person.radius = body_radius(person.id);
    const double heading = radians_from_sumo(api::Person::getAngle(person.id));
    const Vec2 velocity = unit(heading) * api::Person::getSpeed(person.id);
    persons_.push_back(
        {person.id, person.position, velocity, heading, person.radius, ridden_.back()});
  }
}

std::optional<bool> SceneReader::aware(std::size_t person, std::size_t vehicle) const {
  if (person >= takeover_.guests().size()) return std::nullopt;
  const Guest& guest = takeover_.guests()[person];
  const VehicleSample& sample = vehicles_[vehicle];
  VehicleState state;
  state.centre = sample.centre;
  state.heading = sample.heading;
  state.velocity = sample.velocity;
  state.length = sample.length;
  state.width = sample.width;
  return crowds_[guest.zone]->aware_of(guest.handle, state);
}

}  // namespace pedzone
