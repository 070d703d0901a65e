#include "conflict/tracker.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pedzone {
namespace {

// A step that is longer than both speeds explain is a jump: twice as long, and a margin for what
// positions in a file are rounded to and for being put beside a vehicle. Assumed.
constexpr double kJumpShare = 2.0;
constexpr double kJumpMargin = 0.5;  // [m]

bool finite(const Vec2& v) { return std::isfinite(v.x()) && std::isfinite(v.y()); }

bool jumped(const Vec2& from, const Vec2& to, double speed_before, double speed, double elapsed) {
  return (to - from).norm() > kJumpShare * std::max(speed_before, speed) * elapsed + kJumpMargin;
}

/// Key of a pair of places.
std::uint64_t pair_of(std::uint32_t person, std::uint32_t vehicle) {
  return (std::uint64_t{person} << 32) | vehicle;
}

double direction_of(const Vec2& velocity, double heading) {
  return velocity.norm() >= kStill ? angle_of(velocity) : heading;
}

}  // namespace

template <typename Body>
std::uint32_t ConflictTracker::Cast<Body>::place_of(std::string_view id) {
  const auto known = places.find(id);
  if (known != places.end()) return known->second;
  std::uint32_t place = static_cast<std::uint32_t>(bodies.size());
  if (unused.empty()) {
    bodies.emplace_back();
  } else {
    place = unused.back();
    unused.pop_back();
  }
  bodies[place] = {};
  bodies[place].id = id;
  bodies[place].serial = ++serials;
  places.emplace(std::string(id), place);
  return place;
}

template <typename Body>
void ConflictTracker::Cast<Body>::forget_unseen(std::uint64_t step) {
  for (auto known = places.begin(); known != places.end();) {
    Body& body = bodies[known->second];
    if (body.seen == step) {
      ++known;
      continue;
    }
    unused.push_back(known->second);
    known = places.erase(known);
  }
}

ConflictTracker::ConflictTracker(const ConflictLimits& limits)
    : limits_(limits), memory_(std::max(limits.pet, kMemory)) {}

void ConflictTracker::step(double time, std::span<const PersonSample> persons,
                           std::span<const VehicleSample> vehicles, const AwareOf& aware,
                           std::vector<Conflict>& over) {
  before_ = step_ == 0 ? time : time_;
  time_ = time;
  ++step_;
  fastest_ = 0.0;
  rows_.clear();
  for (std::size_t i = 0; i < vehicles.size(); ++i) take(vehicles[i], i);
  for (std::size_t i = 0; i < persons.size(); ++i) take(persons[i], i);
  std::sort(rows_.begin(), rows_.end(), [](const Row& a, const Row& b) {
    return std::tie(a.x, a.place) < std::tie(b.x, b.place);
  });
  for (std::uint32_t v = 0; v < vehicles_.bodies.size(); ++v) {
    if (vehicles_.bodies[v].seen == step_) meet_persons(v, aware);
  }
  close(false, over);
  persons_.forget_unseen(step_);
  vehicles_.forget_unseen(step_);
}

void ConflictTracker::take(const PersonSample& sample, std::size_t index) {
  if (!finite(sample.position) || !finite(sample.velocity) || !std::isfinite(sample.heading))
    return;
  const std::uint32_t place = persons_.place_of(sample.id);
  Person& person = persons_.bodies[place];
  person.seen = step_;
  if (!sample.rides_in.empty()) {
    board(person, place, sample.rides_in);
    return;
  }
  const double speed = sample.velocity.norm();
  PersonPose pose{time_, sample.position, 0.0,
                  static_cast<float>(direction_of(sample.velocity, sample.heading))};
  if (person.trail.size() > 0) {
    const PersonPose& last = person.trail[0];
    pose.travelled = last.travelled + (pose.at - last.at).norm();
    if (jumped(last.at, pose.at, person.velocity.norm(), speed, time_ - last.time)) {
      person.trail.clear();
    }
  }
  person.trail.push(pose, time_ - memory_);
  person.sample = index;
  person.velocity = sample.velocity;
  person.radius = sample.radius;
  fastest_ = std::max(fastest_, speed);
  rows_.push_back({pose.at.x(), pose.at.y(), place});
}

void ConflictTracker::board(Person& person, std::uint32_t place, std::string_view vehicle) {
  person.trail.clear();
  const auto known = vehicles_.places.find(vehicle);
  if (known == vehicles_.places.end()) return;
  person.own_vehicle = vehicles_.bodies[known->second].serial;
  encounters_.erase(pair_of(place, known->second));
}

void ConflictTracker::take(const VehicleSample& sample, std::size_t index) {
  if (!finite(sample.centre) || !finite(sample.velocity) || !std::isfinite(sample.heading)) return;
  Vehicle& vehicle = vehicles_.bodies[vehicles_.place_of(sample.id)];
  const double was = vehicle.velocity.norm(), is = sample.velocity.norm();
  VehiclePose pose{time_, sample.centre, unit(sample.heading), 0.0,
                   static_cast<float>(direction_of(sample.velocity, sample.heading))};
  vehicle.half_length = 0.5 * sample.length;
  vehicle.half_width = 0.5 * sample.width;
  vehicle.braking = false;
  if (vehicle.trail.size() > 0) {
    const VehiclePose& last = vehicle.trail[0];
    const double turn = std::abs(std::atan2(cross(last.axis, pose.axis), last.axis.dot(pose.axis)));
    pose.travelled = last.travelled + (pose.centre - last.centre).norm() +
                     turn * std::hypot(vehicle.half_length, vehicle.half_width);
    vehicle.braking = was - is > kBraking * (time_ - last.time);
    if (jumped(last.centre, pose.centre, was, is, time_ - last.time)) vehicle.trail.clear();
  }
  vehicle.trail.push(pose, time_ - memory_);
  vehicle.seen = step_;
  vehicle.sample = index;
  vehicle.velocity = sample.velocity;
}

/// Asks for the persons who may come near within the horizon, or may have been where the vehicle
/// was, or be where it is now, within the memory.
void ConflictTracker::meet_persons(std::uint32_t v, const AwareOf& aware) {
  const Vehicle& vehicle = vehicles_.bodies[v];
  const double body = std::hypot(vehicle.half_length, vehicle.half_width) + kNear;
  const double ahead = (vehicle.velocity.norm() + fastest_) * limits_.horizon;
  const double reach = body + std::max(std::min(ahead, limits_.range), fastest_ * memory_);
  const Vec2 centre = vehicle.trail[0].centre;
  Vec2 low = centre - Vec2(reach, reach), high = centre + Vec2(reach, reach);
  for (std::size_t k = 1; k < vehicle.trail.size(); ++k) {
    low = low.cwiseMin(vehicle.trail[k].centre - Vec2(body, body));
    high = high.cwiseMax(vehicle.trail[k].centre + Vec2(body, body));
  }
  auto row = std::lower_bound(rows_.begin(), rows_.end(), low.x(),
                              [](const Row& person, double x) { return person.x < x; });
  for (; row != rows_.end() && row->x <= high.x(); ++row) {
    if (row->y >= low.y() && row->y <= high.y()) meet(row->place, v, aware);
  }
}

void ConflictTracker::meet(std::uint32_t p, std::uint32_t v, const AwareOf& aware) {
  const Person& person = persons_.bodies[p];
  const Vehicle& vehicle = vehicles_.bodies[v];
  if (person.own_vehicle == vehicle.serial) return;
  Meeting meeting;
  Approach& approach = meeting.approach;
  const PersonPose& at = person.trail[0];
  const VehiclePose& pose = vehicle.trail[0];
  approach.at = to_frame(pose.axis, at.at - pose.centre);
  approach.velocity = to_frame(pose.axis, person.velocity - vehicle.velocity);
  approach.speed = pose.axis.dot(vehicle.velocity);
  approach.sizes = {vehicle.half_length, vehicle.half_width, person.radius};
  meeting.time = time_;
  meeting.before = before_;
  meeting.person = at.at;
  meeting.person_velocity = person.velocity;
  meeting.vehicle_velocity = vehicle.velocity;
  meeting.centre = pose.centre;
  meeting.axis = pose.axis;
  meeting.braking = vehicle.braking;
  if (!measure(person.trail, vehicle.trail, meeting)) return;

  meeting.type = type_of(approach, at.direction, pose.direction, vehicle.velocity.norm() < kStill);
  const auto [entry, is_new] = encounters_.try_emplace(pair_of(p, v));
  Encounter& encounter = entry->second;
  if (is_new) {
    encounter.conflict.person = person.id;
    encounter.conflict.vehicle = vehicle.id;
  }
  encounter.record(meeting, [&]() -> std::optional<bool> {
    return aware ? aware(person.sample, vehicle.sample) : std::nullopt;
  });
}

/// Fills in what the two have to do with each other in this step; false where nothing.
bool ConflictTracker::measure(const Trail<PersonPose>& person, const Trail<VehiclePose>& vehicle,
                              Meeting& meeting) const {
  const Approach& approach = meeting.approach;
  const double room = clearance(approach);
  if (room <= limits_.range) meeting.ttc = time_to_contact(approach);
  if (meeting.ttc && *meeting.ttc > limits_.horizon) meeting.ttc.reset();
  meeting.closest.clearance = room;
  if (person.size() < 2 || vehicle.size() < 2) {
    if (room < -kTouch) meeting.closest.touch = 1.0;
  } else {
    const double moved =
        person[0].travelled - person[1].travelled + vehicle[0].travelled - vehicle[1].travelled;
    if (room - moved <= kNear) {
      const Vec2 from = to_frame(vehicle[1].axis, person[1].at - vehicle[1].centre);
      meeting.closest = closest_on_way(approach, from, approach.at);
    }
    meeting.passing = latest_passing(person, vehicle, approach.sizes, memory_);
  }
  return meeting.ttc || meeting.passing || meeting.closest.clearance <= kNear;
}

void ConflictTracker::close(bool all, std::vector<Conflict>& over) {
  const std::size_t first = over.size();
  for (auto found = encounters_.begin(); found != encounters_.end();) {
    const auto& [pair, encounter] = *found;
    const bool together = persons_.bodies[pair >> 32].seen == step_ &&
                          vehicles_.bodies[pair & 0xffffffffU].seen == step_;
    if (!all && together && time_ - encounter.conflict.end <= memory_) {
      ++found;
      continue;
    }
    if (limits_.exceeded_by(encounter.conflict)) over.push_back(encounter.conflict);
    found = encounters_.erase(found);
  }
  std::sort(over.begin() + static_cast<std::ptrdiff_t>(first), over.end(),
            [](const Conflict& a, const Conflict& b) {
              return std::tie(a.begin, a.person, a.vehicle) <
                     std::tie(b.begin, b.person, b.vehicle);
            });
}

void ConflictTracker::finish(std::vector<Conflict>& over) { close(true, over); }

}  // namespace pedzone
