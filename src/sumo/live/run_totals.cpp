#include "sumo/live/run_totals.hpp"

#include <algorithm>
#include <ranges>

#include "geometry/near_points.hpp"

namespace pedzone {
namespace {

constexpr double kContact = 0.01;  // [m] bodies overlap by more than this: contact
constexpr double kDrives = 0.5;    // [m/s] a slower vehicle does not hit anybody: as in studies
constexpr double kRange = 20.0;    // [m] numerical: pairs farther apart are not measured

}  // namespace

void RunTotals::count_persons(long departed, long arrived) {
  departed_ += departed;
  arrived_ += arrived;
}

/// SUMO tells of a collision in every step that it lasts.
void RunTotals::count_events(const SumoEvents& events) {
  teleports_ += events.teleports;
  emergency_stops_ += events.emergency_stops;
  for (const SumoEvents::Collision& collision : events.collisions) {
    if (std::ranges::find(colliding_, collision) == colliding_.end()) ++collisions_;
  }
  colliding_ = events.collisions;
}

void RunTotals::observe(const Fleet& fleet, const Takeover& takeover) {
  const std::vector<Guest>& guests = takeover.guests();
  person_steps_ += static_cast<long>(guests.size());
  std::vector<Vec2> places;
  for (const Guest& guest : guests) places.push_back(guest.position);
  const NearPoints near(places);
  for (const FleetVehicle& vehicle : fleet.vehicles()) {
    if (known_vehicles_.insert(vehicle.id).second) ++vehicles_;
    delay_ += vehicle.new_loss;
    const Contact first = vehicle.seen_for > 0.0 ? Contact::kStanding : Contact::kInsertion;
    const VehicleBody body = body_of(vehicle);
    for (const Rectangle& part : body.parts()) {
      for (const std::uint32_t k : near.within(part.centre, kRange)) {
        const Guest& guest = guests[k];
        if ((guest.position - part.centre).norm() > kRange) continue;
        const double clearance = part.signed_distance(guest.position) - guest.radius;
        min_clearance_ = std::min(min_clearance_, clearance);
        if (clearance >= -kContact) continue;
        Contact& contact = contacts_.try_emplace({guest.id, vehicle.id}, first).first->second;
        const bool drives = vehicle.speed > kDrives;
        if (drives && contact == Contact::kStanding) contact = Contact::kDriving;
      }
    }
  }
}

RunSummary RunTotals::summary(const Takeover& takeover, const PushRecords& pushes,
                              const Yielding& yielding, std::size_t walking) const {
  RunSummary summary;
  const WalkTotals& walks = takeover.totals();
  const double persons = static_cast<double>(std::max(1L, walks.controlled));
  summary.persons.seen = departed_;
  summary.persons.controlled = walks.controlled;
  summary.persons.given_back = walks.given_back;
  summary.persons.takeovers = walks.takeovers;
  summary.persons.returns = walks.returns;
  summary.persons.arrived = arrived_ + walks.ended;
  summary.persons.walking = static_cast<long>(walking);
  summary.persons.lost = departed_ - summary.persons.arrived - summary.persons.walking;
  summary.jams = takeover.jams();
  for (const auto& [key, person] : pushes.log().persons()) {
    ++summary.pushes.persons;
    summary.pushes.longest_m = std::max(summary.pushes.longest_m, person.way);
    summary.pushes.fastest_mps = std::max(summary.pushes.fastest_mps, person.speed);
  }
  summary.run_into = pushes.run_into();
  if (walks.time > 0.0) summary.persons.mean_speed = walks.distance / walks.time;
  summary.persons.mean_delay_s = (walks.time - walks.free_time) / persons;
  summary.persons.mean_waiting_s = walks.waiting / persons;
  summary.vehicles.seen = vehicles_;
  summary.vehicles.yielding = static_cast<long>(yielding.yielded().size());
  summary.late_brakings = yielding.late_brakings();
  const auto of_kind = [&](Contact kind) {
    return static_cast<long>(std::ranges::count(std::views::values(contacts_), kind));
  };
  summary.vehicles.insertion_contacts = of_kind(Contact::kInsertion);
  summary.vehicles.standing_contacts = of_kind(Contact::kStanding);
  summary.vehicles.contacts = static_cast<long>(contacts_.size());
  summary.vehicles.min_clearance_m = min_clearance_;
  if (vehicles_ > 0) summary.vehicles.mean_delay_s = delay_ / static_cast<double>(vehicles_);
  summary.sumo.teleports = teleports_;
  summary.sumo.collisions = collisions_;
  summary.sumo.emergency_stops = emergency_stops_;
  summary.time.person_steps = person_steps_;
  return summary;
}

}  // namespace pedzone
