#include "conflict/tracker.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "world/speeds.hpp"

namespace pedzone {
namespace {

// A step that is longer than both speeds explain is a jump: twice as long, and a margin for what
// positions in a file are rounded to and for being put beside a vehicle. Assumed.
constexpr double kJumpShare = 2.0;
constexpr double kJumpMargin = 0.5;  // [m]

bool jumped(const Vec2& from, const Vec2& to, double speed_before, double speed, double elapsed) {
  return (to - from).norm() > kJumpShare * std::max(speed_before, speed) * elapsed + kJumpMargin;
}

/// Key of a pair of places.
std::uint64_t pair_of(std::uint32_t person, std::uint32_t vehicle) {
  return (std::uint64_t{person} << 32) | vehicle;
}

/// What a part is known by. No id of SUMO's has such a character.
std::string part_name(std::string_view vehicle, int part) {
  return std::string(vehicle) + '\x1f' + std::to_string(part);
}

double direction_of(const Vec2& velocity, double heading) {
  return velocity.norm() >= kHaltingSpeed ? angle_of(velocity) : heading;
}

}  // namespace

void add_parts(std::string_view id, std::span<const Rectangle> parts, double speed,
               std::vector<VehicleSample>& samples) {
  int number = 0;
  for (const Rectangle& part : parts) {
    samples.push_back({id, part.centre, angle_of(part.axis), part.axis * speed, 2.0 * part.half.x(),
                       2.0 * part.half.y(), number++});
  }
}

ConflictTracker::ConflictTracker(const ConflictLimits& limits)
    : limits_(limits), memory_(std::max(limits.pet, kMemory)) {
  limits_.horizon = std::max(limits.horizon, limits.ttc);  // what is to be told is looked for
}

void ConflictTracker::step(double time, std::span<const PersonSample> persons,
                           std::span<const VehicleSample> vehicles, const AwareOf& aware,
                           std::vector<Conflict>& over) {
  before_ = begun_ ? time_ : time;
  time_ = time;
  longest_ = std::max(longest_, time_ - before_);
  begun_ = true;
  vehicles_.begin_step();
  persons_.begin_step();
  unsorted_.clear();
  for (std::size_t i = 0; i < vehicles.size(); ++i) take(vehicles[i], i);
  for (std::size_t i = 0; i < persons.size(); ++i) take(persons[i], i);
  sort_persons();
  for (std::uint32_t v = 0; v < vehicles_.bodies.size(); ++v) {
    if (vehicles_.is_here(v)) meet_persons(v, aware);
  }
  close(false, over);
  persons_.forget_gone();
  vehicles_.forget_gone();
}

void ConflictTracker::take(const PersonSample& sample, std::size_t index) {
  if (sample.id.empty() || !finite(sample.position) || !finite(sample.velocity) ||
      !std::isfinite(sample.heading)) {
    return;
  }
  const std::uint32_t place = persons_.take(sample.id, index);
  Person& person = persons_.bodies[place];
  if (!sample.rides_in.empty()) {
    board(person, place, sample.rides_in);
    return;
  }
  const double speed = sample.velocity.norm();
  PersonPose pose{sample.position, time_, 0.0F,
                  static_cast<float>(direction_of(sample.velocity, sample.heading))};
  if (person.trail.size() > 0) {
    const PersonPose& last = person.trail[0];
    pose.travelled = last.travelled + static_cast<float>((pose.at - last.at).norm());
    if (jumped(last.at, pose.at, person.velocity.norm(), speed, time_ - last.time)) {
      person.trail.clear();
    }
  }
  person.trail.push(pose, time_ - memory_);
  person.velocity = sample.velocity;
  person.radius = sample.radius;
  person.by_pedzone = sample.by_pedzone;
  const auto& trail = person.trail;
  const auto way_since = [&](std::size_t k) {
    return static_cast<double>(trail[0].travelled - trail[k].travelled);
  };
  unsorted_.push_back({pose.at, sample.velocity, sample.radius, way_since(trail.size() - 1),
                       way_since(std::min<std::size_t>(1, trail.size() - 1)), place});
}

void ConflictTracker::board(Person& person, std::uint32_t place, std::string_view vehicle) {
  person.trail.clear();
  std::uint32_t vehicle_place = 0;
  const Vehicle* own = vehicles_.find(vehicle, vehicle_place);
  if (own == nullptr) return;
  person.own_vehicle = own->serial;
  if (encounters_.erase(pair_of(place, vehicle_place)) > 0) --person.encounters;
}

void ConflictTracker::take(const VehicleSample& sample, std::size_t index) {
  if (sample.id.empty() || !finite(sample.centre) || !finite(sample.velocity) ||
      !std::isfinite(sample.heading)) {
    return;
  }
  const std::uint32_t place = sample.part == 0
                                  ? vehicles_.take(sample.id, index)
                                  : vehicles_.take(part_name(sample.id, sample.part), index);
  Vehicle& vehicle = vehicles_.bodies[place];
  vehicle.whole = place;
  if (sample.part > 0 && vehicles_.find(sample.id, vehicle.whole) == nullptr) return;
  const double was = vehicle.velocity.norm(), is = sample.velocity.norm();
  VehiclePose pose{time_, sample.centre, unit(sample.heading), 0.0,
                   static_cast<float>(direction_of(sample.velocity, sample.heading))};
  vehicle.half_length = 0.5 * sample.length;
  vehicle.half_width = 0.5 * sample.width;
  vehicle.braking = false;
  if (vehicle.trail.size() > 0) {
    const VehiclePose& last = vehicle.trail[0];
    pose.travelled = last.travelled +
                     way_between(last, pose, Vec2(vehicle.half_length, vehicle.half_width).norm());
    vehicle.braking = was - is > kBraking * (time_ - last.time);
    if (jumped(last.centre, pose.centre, was, is, time_ - last.time)) vehicle.trail.clear();
  }
  vehicle.trail.push(pose, time_ - memory_);
  vehicle.velocity = sample.velocity;
}

void ConflictTracker::sort_persons() {
  order_.clear();
  rows_.clear();
  most_ = {};
  for (std::uint32_t i = 0; i < unsorted_.size(); ++i) {
    order_.emplace_back(unsorted_[i].at.x(), i);
    most_.take(unsorted_[i]);
  }
  std::sort(order_.begin(), order_.end());
  for (const auto& [x, row] : order_) rows_.push_back(unsorted_[row]);
}

void ConflictTracker::meet_persons(std::uint32_t v, const AwareOf& aware) {
  const Vehicle& vehicle = vehicles_.bodies[v];
  const Search search(vehicle.trail, vehicle.velocity,
                      {vehicle.half_length, vehicle.half_width, 0.0}, most_, limits_);
  const Vec2 reach(search.reach(), search.reach());
  const Vec2 low = search.centre() - reach, high = search.centre() + reach;
  auto row = std::lower_bound(rows_.begin(), rows_.end(), low.x(),
                              [](const PersonRow& person, double x) { return person.at.x() < x; });
  for (; row != rows_.end() && row->at.x() <= high.x(); ++row) {
    if (row->at.y() < low.y() || row->at.y() > high.y()) continue;
    const Search::Reasons reasons = search.look_at(*row);
    if (reasons.any() || is_followed(*row, vehicle)) meet(*row, v, reasons, aware);
  }
}

/// Whether the two have an encounter that is not over.
bool ConflictTracker::is_followed(const PersonRow& person, const Vehicle& vehicle) const {
  return persons_.bodies[person.place].encounters > 0 &&
         encounters_.contains(pair_of(person.place, vehicle.whole));
}

void ConflictTracker::meet(const PersonRow& person, std::uint32_t v, const Search::Reasons& reasons,
                           const AwareOf& aware) {
  const Vehicle& vehicle = vehicles_.bodies[v];
  const VehiclePose& pose = vehicle.trail[0];
  Meeting meeting;
  Approach& approach = meeting.approach;
  approach.at = to_frame(pose.axis, person.at - pose.centre);
  approach.velocity = to_frame(pose.axis, person.velocity - vehicle.velocity);
  approach.speed = pose.axis.dot(vehicle.velocity);
  approach.sizes = {vehicle.half_length, vehicle.half_width, person.radius};
  measure(persons_.bodies[person.place].trail, vehicle.trail, reasons, meeting);
  const bool matters = meeting.ttc || meeting.passing || meeting.closest.clearance <= kNear;
  Person& known = persons_.bodies[person.place];
  const Vehicle& whole = vehicles_.bodies[vehicle.whole];
  if (known.own_vehicle == whole.serial) return;
  if (!matters && !is_followed(person, vehicle)) return;

  meeting.time = time_;
  meeting.before = before_;
  meeting.person = person.at;
  meeting.person_velocity = person.velocity;
  meeting.vehicle_velocity = vehicle.velocity;
  meeting.centre = pose.centre;
  meeting.axis = pose.axis;
  meeting.braking = vehicle.braking;
  meeting.by_pedzone = known.by_pedzone;
  meeting.type = type_of(approach, known.trail[0].direction, pose.direction,
                         vehicle.velocity.norm() < kHaltingSpeed);
  const auto [entry, is_new] = encounters_.try_emplace(pair_of(person.place, vehicle.whole));
  Encounter& encounter = entry->second;
  if (!matters) {
    encounter.record_clearance(meeting);
    return;
  }
  if (is_new) {
    ++known.encounters;
    encounter.conflict.person = known.id;
    encounter.conflict.vehicle = whole.id;
  }
  encounter.record(meeting, [&]() -> std::optional<bool> {
    return aware ? aware(known.sample, vehicle.sample) : std::nullopt;
  });
}

/// Fills in what the two have to do with each other in this step.
void ConflictTracker::measure(const Trail<PersonPose>& person, const Trail<VehiclePose>& vehicle,
                              const Search::Reasons& reasons, Meeting& meeting) const {
  const Approach& approach = meeting.approach;
  const double room = clearance(approach);
  if (reasons.course && room <= limits_.range) meeting.ttc = time_to_contact(approach);
  if (meeting.ttc && *meeting.ttc > limits_.horizon) meeting.ttc.reset();
  meeting.closest.clearance = room;
  const bool far_ahead = reasons.course && !reasons.near;  // it comes nearer yet
  if (!far_ahead && person.size() >= 2 && vehicle.size() >= 2) {
    meeting.closest = closest_on_ways(person[1], person[0], vehicle[1], vehicle[0], approach.sizes);
  } else if (room < -kTouch) {
    meeting.closest.touch = 1.0;
  }
  if (reasons.order.vehicle_first || reasons.order.person_first) {
    meeting.passing = latest_passing(person, vehicle, approach.sizes, memory_, reasons.order);
  }
}

void ConflictTracker::close(bool all, std::vector<Conflict>& over) {
  const std::size_t first = over.size();
  for (auto found = encounters_.begin(); found != encounters_.end();) {
    const auto& [pair, encounter] = *found;
    const auto person = static_cast<std::uint32_t>(pair >> 32);
    const bool together =
        persons_.is_here(person) && vehicles_.is_here(static_cast<std::uint32_t>(pair));
    if (!all && together && time_ - encounter.conflict.end <= memory_) {
      ++found;
      continue;
    }
    --persons_.bodies[person].encounters;
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
