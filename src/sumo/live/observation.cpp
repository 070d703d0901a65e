#include "sumo/live/observation.hpp"

#include <algorithm>

#include "core/random.hpp"

namespace pedzone {

Observation ObservationReader::read(double time) {
  persons_.clear();
  vehicles_.clear();
  for (const FleetVehicle& vehicle : fleet_.vehicles()) {
    add(vehicle);
  }
  for (const Guest& guest : takeover_.guests()) {
    const PersonView view = crowds_[guest.zone]->view(guest.handle);
    persons_.push_back(
        {guest.id, view.position, view.velocity, view.heading, guest.radius, {}, {}, true});
  }
  add_bystanders();
  return {time, persons_, vehicles_,
          [this](std::size_t person, std::size_t vehicle) { return aware(person, vehicle); }};
}

void ObservationReader::add(const FleetVehicle& vehicle) {
  const VehicleTraits& traits = vehicle.traits;
  if (!traits.parts.bends()) {
    vehicles_.push_back({vehicle.id, vehicle.centre(), vehicle.heading, vehicle.velocity,
                         traits.length, traits.width});
    return;
  }
  const VehicleBody body = body_of(vehicle);
  add_parts(vehicle.id, body.parts(), vehicle.velocity.dot(unit(vehicle.heading)), vehicles_);
}

/// Reading people from SUMO is dear: what is known of them has to do, and only who is exactly at a
/// vehicle's front, as SUMO places those who ride, is asked for.
void ObservationReader::add_bystanders() {
  fronts_.clear();
  for (const FleetVehicle& vehicle : fleet_.vehicles()) {
    fronts_.emplace_back(vehicle.front.x(), vehicle.front.y());
  }
  std::sort(fronts_.begin(), fronts_.end());
  std::vector<Bystander>& all = takeover_.bystanders().all();
  ridden_.clear();
  ridden_.reserve(all.size());  // samples point into it
  for (Bystander& person : all) {
    if (person.guest || !person.near) continue;
    const std::pair place(person.position.x(), person.position.y());
    const bool at_front = std::binary_search(fronts_.begin(), fronts_.end(), place);
    if (at_front) ridden_.push_back(sumo_.vehicle(person.id));
    if (person.radius == 0.0) measure(person, sumo_.size(person.id));
    persons_.push_back({person.id,
                        person.position,
                        person.velocity,
                        person.heading,
                        person.radius,
                        at_front ? std::string_view(ridden_.back()) : "",
                        {},
                        false});
  }
}

std::optional<bool> ObservationReader::aware(std::size_t person, std::size_t vehicle) const {
  if (person >= takeover_.guests().size()) return std::nullopt;
  const Guest& guest = takeover_.guests()[person];
  const VehicleSample& sample = vehicles_[vehicle];
  VehicleState state;
  state.centre = sample.centre;
  state.heading = sample.heading;
  state.velocity = sample.velocity;
  state.length = sample.length;
  state.width = sample.width;
  state.key = person_key(sample.id);
  return crowds_[guest.zone]->aware_of(guest.handle, state);
}

}  // namespace pedzone
