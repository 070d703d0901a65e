#include "crowd/crowd.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/random.hpp"
#include "crowd/behaviour/bystanding.hpp"
#include "crowd/behaviour/kerbs.hpp"
#include "crowd/behaviour/path_walk.hpp"
#include "crowd/behaviour/shade.hpp"
#include "crowd/insight.hpp"
#include "crowd/motion/placement.hpp"
#include "crowd/sense/apart.hpp"
#include "crowd/sense/awareness.hpp"
#include "crowd/state/state.hpp"
#include "crowd/step.hpp"
#include "geometry/segment.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kLeastRadius = 0.05;  // [m] numerical: a body is never a point
constexpr double kMostRadius = 1.0;    // [m] as Persons::radius
constexpr double kLeastSpeed = 1e-3;   // [m/s] numerical: models divide by the preferred speed;
                                       // at this one a person stands

bool is_finite(const VehicleState& v) {
  return finite(v.centre) && finite(v.velocity) && std::isfinite(v.heading) &&
         std::isfinite(v.yaw_rate) && std::isfinite(v.length) && std::isfinite(v.width);
}

void require(bool good, const char* what) {
  if (!good) throw std::invalid_argument(std::string("crowd: ") + what + " is not a finite number");
}

double speed_in_range(double speed) { return std::clamp(speed, kLeastSpeed, kMostSpeed); }

void require_finite(const NewPerson& person) {
  require(finite(person.position), "a position");
  require(finite(person.velocity) && std::isfinite(person.heading), "a velocity or heading");
  require(finite(person.destination.a) && finite(person.destination.b), "a destination");
  require(std::isfinite(person.radius), "a radius");
  for (const Waypoint& waypoint : person.path) {
    require(finite(waypoint.at) && std::isfinite(waypoint.radius), "a waypoint");
  }
  require(std::isfinite(person.preferred_speed), "a preferred speed");
}

/// Row i becomes that person, at `place` [m].
void put_there(const NewPerson& person, const Vec2& place, std::size_t i, CrowdState& crowd) {
  Persons& persons = crowd.persons;
  WalkState& walker = crowd.walkers[i];
  const double preferred = speed_in_range(person.preferred_speed);
  const double speed = person.velocity.norm();
  const Vec2 velocity =
      speed > preferred ? Vec2(person.velocity * (preferred / speed)) : person.velocity;
  persons.key[i] = person.key;
  persons.x[i] = place.x();
  persons.y[i] = place.y();
  persons.vx[i] = velocity.x();
  persons.vy[i] = velocity.y();
  persons.heading[i] = wrap_angle(person.heading);
  persons.preferred_speed[i] = walker.own_speed = preferred;
  walker.profile = person.profile;
  // The variation starts in its stationary state, with the number of the substep before.
  walker.heading_noise =
      crowd.zone.parameters.heading_noise * kPi / 180.0 *
      random_normal(crowd.seed, person.key, crowd.clock.substep - 1, Purpose::kHeadingNoise);
}

/// How wide row i is, with a body of `radius` [m].
void set_widths(const NewPerson& person, double radius, std::size_t i, CrowdState& crowd) {
  Persons& persons = crowd.persons;
  WalkState& walker = crowd.walkers[i];
  walker.turned_width =
      static_cast<float>(person.profile != nullptr ? person.profile->turned_width
                                                   : crowd.zone.parameters.turned_width);
  walker.full_radius = static_cast<float>(radius);
  persons.radius[i] = walker.full_radius;
  persons.turned_radius[i] = static_cast<double>(walker.turned_width * walker.full_radius);
  persons.present_radius[i] = persons.turned_radius[i];  // until it is known who is near
}

/// What behaviours know of the person from the start.
void remember(const NewPerson& person, PersonHandle handle, CrowdState& crowd) {
  crowd.groups[handle].group = person.group;
  if (person.group != 0) ++crowd.grouped;
  std::ranges::copy(person.rates, crowd.activities[handle].rates.begin());
  if (!crowd.zone.streets.empty()) crowd.crossings[handle].by_junctions = person.by_junctions;
  const double awareness = person.profile != nullptr ? person.profile->awareness : 1.0;
  crowd.traffic[handle].aware = person.aware.value_or(
      random_uniform(crowd.seed, person.key, 0, Purpose::kAwareness) < awareness);
}

/// By the user's waypoints; else from `place` [m] through shade, where the zone has any; else null.
PathMemory path_of(const NewPerson& person, const Vec2& place, const Zone& zone) {
  std::vector<Waypoint> path = person.path;
  if (path.empty()) path = way_through_shade(zone, place, person.destination);
  if (path.empty()) return nullptr;
  return std::make_unique<PathWalk>(PathWalk{std::move(path), 0, person.destination});
}

}  // namespace

struct Crowd::State : CrowdState {
  using CrowdState::CrowdState;

  std::size_t row_of(Handle handle) const { return row[handle]; }

  /// Of a person of whom nothing is remembered.
  Handle new_handle() {
    if (unused.empty()) {
      unused.push_back(static_cast<Handle>(row.size()));
      row.push_back(0);
    }
    const Handle handle = unused.back();
    unused.pop_back();
    traffic.begin(handle);
    activities.begin(handle);
    groups.begin(handle);
    children.begin(handle);
    paths.begin(handle);
    jams.begin(handle);
    if (!zone.streets.empty()) crossings.begin(handle);
    if (!zone.crosswalks.empty()) kerbs.begin(handle);
    return handle;
  }

  /// Of a person of whom nothing is known yet.
  std::size_t new_row() {
    const Handle handle = new_handle();
    const std::size_t i = persons.walking++;
    resize_rows(persons, persons.walking);
    walkers.emplace_back().handle = handle;
    row[handle] = static_cast<std::uint32_t>(i);
    return i;
  }

  /// Puts row `from` where row `to` is.
  void copy_row(std::size_t from, std::size_t to) {
    for (std::vector<double>* column : persons.numbers()) (*column)[to] = (*column)[from];
    persons.key[to] = persons.key[from];
    walkers[to] = std::move(walkers[from]);
    row[walkers[to].handle] = static_cast<std::uint32_t>(to);
  }
};

const char* name_of(Motion motion) {
  switch (motion) {
    case Motion::kWalking:
      return "walking";
    case Motion::kWaiting:
      return "waiting";
    case Motion::kStanding:
      return "standing";
  }
  return "unknown";
}

Crowd::Crowd(const Zone& zone, std::uint64_t seed) : Crowd(zone, seed, make_model(zone.model)) {
  // Models keep what they have made of the walls: one for each kind of walls.
  if (!zone.streets.empty()) state_->street_model = make_model(zone.model);
}

Crowd::Crowd(const Zone& zone, std::uint64_t seed, std::unique_ptr<WalkingModel> model)
    : state_(std::make_unique<State>(zone, seed, std::move(model))) {}

Crowd::~Crowd() = default;
Crowd::Crowd(Crowd&&) noexcept = default;
Crowd& Crowd::operator=(Crowd&&) noexcept = default;

Crowd::Handle Crowd::add(const NewPerson& person) {
  require_finite(person);
  State& state = *state_;
  const double radius = std::clamp(person.radius, kLeastRadius, kMostRadius);
  Vec2 place = state.zone.walls.nearest_inside(person.position, radius);
  if (person.place_freely) place = free_place(state, place, radius);

  const std::size_t i = state.new_row();
  const Handle handle = state.handle(i);
  put_there(person, place, i, state);
  set_widths(person, radius, i, state);
  remember(person, handle, state);
  state.paths[handle] = path_of(person, place, state.zone);
  start_way(state, i, person.destination, state.ways());
  return handle;
}

void Crowd::remove(Handle handle) {
  State& state = *state_;
  const std::size_t i = state.row_of(handle), last = state.persons.walking - 1;
  if (state.groups[handle].group != 0) --state.grouped;
  if (i != last) state.copy_row(last, i);
  state.walkers.pop_back();
  state.persons.walking = last;
  resize_rows(state.persons, last);
  state.unused.push_back(handle);
}

void Crowd::set_destination(Handle handle, const Destination& destination) {
  require(finite(destination.a) && finite(destination.b), "a destination");
  start_way(*state_, state_->row_of(handle), destination, state_->ways());
}

void Crowd::set_preferred_speed(Handle handle, double speed) {
  require(std::isfinite(speed), "a preferred speed");
  const std::size_t i = state_->row_of(handle);
  state_->walkers[i].own_speed = state_->persons.preferred_speed[i] = speed_in_range(speed);
}

void Crowd::see(std::span<const SeenPerson> others) {
  state_->seen.assign(others.begin(), others.end());
  std::erase_if(state_->seen, [](const SeenPerson& person) {
    return !finite(person.position) || !finite(person.velocity) || !std::isfinite(person.radius) ||
           !std::isfinite(person.heading);
  });
  recognise_seen(state_->seen, state_->seen_memory, state_->seen_before);
}

void Crowd::step(double dt, std::span<const VehicleState> vehicles) {
  if (!(dt > 0.0) || !std::isfinite(dt)) return;
  std::vector<VehicleState>& present = state_->vehicles;
  present.assign(vehicles.begin(), vehicles.end());
  std::erase_if(present, [](const VehicleState& vehicle) { return !is_finite(vehicle); });
  if (state_->persons.walking > 0) {
    for (VehicleState& vehicle : present) {
      vehicle.ground = ground_ahead(state_->zone.walls, vehicle);
    }
  }
  walk(*state_, dt);
  // What stays is where they are; their ways belong to the caller.
  for (VehicleState& vehicle : present) {
    vehicle.way = {};
    vehicle.yields_at = {};
  }
}

PersonView Crowd::view(Handle handle) const {
  const State& state = *state_;
  const std::size_t i = state.row_of(handle);
  const WalkState& walker = state.walkers[i];
  const Motion motion = walker.waits                       ? Motion::kWaiting
                        : walker.standing >= kStandingTime ? Motion::kStanding
                                                           : Motion::kWalking;
  return {state.position(i),
          state.velocity(i),
          state.persons.heading[i],
          motion,
          state.activities[handle].activity,
          walker.arrived,
          walker.gave_up,
          state.groups[handle].waits,
          i < state.proposals.size() && state.proposals.best(i).by == Behaviour::kClaim,
          state.children[handle].holds_hand,
          state.is_over(i),
          crosswalk_used(state, i),
          !state.zone.streets.empty() && state.crossings[handle].stays_outside,
          state.persons.present_radius[i]};
}

bool Crowd::aware_of(Handle handle, const VehicleState& vehicle) const {
  const State& state = *state_;
  const std::size_t i = state.row_of(handle);
  const bool moving = vehicle.velocity.norm() >= kStaticSpeed;
  if (!state.perception_varies || !moving) {
    return is_aware(state.persons, i, vehicle, state.zone.parameters, state.model->vehicle_form());
  }
  return std::ranges::any_of(state.traffic[handle].noticed, [&](const Noticed& noticed) {
    return noticed.vehicle == vehicle.key && noticed.minds;
  });
}

std::vector<Insight> Crowd::insights(std::span<const Handle> handles) {
  std::vector<std::size_t> rows;
  for (const Handle handle : handles) rows.push_back(state_->row_of(handle));
  return look_into(*state_, rows);
}

std::optional<Vec2> Crowd::seen_at(std::uint64_t key) const {
  const auto found = std::ranges::lower_bound(state_->seen, key, {}, &SeenPerson::key);
  if (found == state_->seen.end() || found->key != key) return std::nullopt;
  return own_place(*state_, static_cast<std::size_t>(found - state_->seen.begin()));
}

std::span<const JamNotice> Crowd::jams() const { return state_->jam_notices; }
std::span<const CrossingBegun> Crowd::crossings() const { return state_->crossings_begun; }
std::span<const VehiclePush> Crowd::pushes() const { return state_->pushes; }
bool Crowd::kept_anybody_out() const { return state_->kept_out; }
void Crowd::let_vehicles_through() { state_->solid_vehicles = false; }

std::size_t Crowd::size() const { return state_->persons.walking; }
std::uint64_t Crowd::person_steps() const { return state_->clock.person_steps; }

bool Crowd::has(Handle handle) const {
  const State& state = *state_;
  if (handle >= state.row.size()) return false;
  const std::size_t i = state.row[handle];
  return i < state.walkers.size() && state.handle(i) == handle;
}

const Persons& Crowd::persons() const { return state_->persons; }
Crowd::Handle Crowd::handle_in(std::size_t row) const { return state_->handle(row); }

Persons Crowd::give_away_persons() {
  Persons given = std::move(state_->persons);
  state_->persons = given;
  return given;
}

}  // namespace pedzone
