#include "sumo/live/takeover.hpp"

#include <algorithm>
#include <functional>

#include "core/random.hpp"
#include "sumo/files/frames.hpp"
#include "sumo/live/api.hpp"
#include "sumo/live/person_hints.hpp"

namespace pedzone {
namespace {

constexpr double kWorthWhile = 1.5;    // [m] numerical: a shorter way to the portal stays SUMO's
constexpr double kPlanInterval = 0.5;  // [s] numerical
constexpr double kStray = 1.0;  // [m] numerical: SUMO's place may lie so far outside the area
constexpr double kHandOverLook = 5.0;  // [s] assumed: no hand-over before a vehicle this near ...
constexpr double kHandOverSide = 0.5;  // [m] ... whose swept area comes this near
constexpr double kHandOverPatience = 10.0;  // [s] assumed
constexpr int kKeepRouteFree = 2;           // moveToXY: may leave the network
constexpr double kNoMatch = -1.0;           // moveToXY matchThreshold: no lane is ever matched

std::size_t hash_plan(int stages_left, const std::vector<std::string>& edges) {
  std::size_t hash = static_cast<std::size_t>(stages_left);
  for (const std::string& edge : edges) {
    hash = hash * 1099511628211ULL ^ std::hash<std::string>{}(edge);
  }
  return hash;
}

/// The route index of `edge` after `last`; -1 when it is not there or there more than once, for
/// then SUMO does not tell which passage this is.
int only_index(const std::vector<int>& route, int edge, int last) {
  int index = -1;
  for (int i = last + 1; i < static_cast<int>(route.size()); ++i) {
    if (route[i] != edge) continue;
    if (index >= 0) return -1;
    index = i;
  }
  return index;
}

/// Lane distance [m] that is left to the end of the stretch on its last edge.
double left_on_last(const Network& network, const ZoneStretch& stretch, const Vec2& position) {
  const double at = project_on_lane(network.lanes[stretch.lane], position).offset;
  if (stretch.release != Release::kLeave) return std::abs(stretch.position - at);
  return stretch.forward ? stretch.position - at : at - stretch.position;
}

/// The middle of a destination's width, so narrow that a body there is within the street.
Destination with_room(const Destination& portal, double radius) {
  const Vec2 along = portal.b - portal.a;
  const double share = std::min(0.5, radius / std::max(along.norm(), 1e-9));
  return {portal.a + share * along, portal.b - share * along};
}

}  // namespace

// Striping takes a random share of up to `dawdling` off the top speed in every step, so its free
// walkers average this share of it; ours walk as fast, or a comparison would measure free speed.
Takeover::Takeover(const Network& network, const std::vector<Zone>& zones,
                   std::vector<std::unique_ptr<Crowd>>& crowds, const Profiles& profiles,
                   const std::vector<WaypointPath>& paths, double dawdling)
    : network_(network),
      zones_(zones),
      crowds_(crowds),
      profiles_(profiles),
      paths_(paths),
      striping_share_(1.0 - 0.5 * std::clamp(dawdling, 0.0, 1.0)),
      zone_of_edge_(network.edges.size(), -1),
      bystanders_(zones),
      seen_(zones.size()) {
  for (std::size_t z = 0; z < zones.size(); ++z) {
    for (const int edge : zones[z].edges) zone_of_edge_[edge] = static_cast<int>(z);
  }
}

void Takeover::read(double time, const Fleet& fleet) {
  bystanders_.read(time);
  for (const std::string& id : bystanders_.gone()) guests_[guest_index_.at(id)].gone = true;
  drop_gone();
  check_guests(time, fleet);
  for (const Bystander& person : bystanders_.all()) {
    if (person.near && !person.guest) consider(person.id, nullptr, fleet);
  }
  eyes_.clear();
  for (const Guest& guest : guests_) eyes_.push_back(guest.position);
  for (const FleetVehicle& vehicle : fleet.vehicles()) {
    eyes_.insert(eyes_.end(), {vehicle.front, vehicle.centre()});
  }
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    bystanders_.seen_from(z, eyes_, seen_[z]);
    crowds_[z]->see(seen_[z]);
  }
}

bool Takeover::has_plan(const Guest& guest) {
  const int left = api::Person::getRemainingStages(guest.id);
  return hash_plan(left, api::Person::getEdges(guest.id)) == guest.plan;
}

/// A program that embeds us may have given a person another plan: it is then taken over anew,
/// from where it stands, if the new plan still leads through the zone. Reading plans is dear: each
/// is read twice a second and before it is acted upon, and when the number of stages has changed.
void Takeover::check_guests(double time, const Fleet& fleet) {
  std::vector<std::pair<std::string, Vec2>> replanned;
  for (Guest& guest : guests_) {
    const int left = api::Person::getRemainingStages(guest.id);
    if (time < guest.check_at && left == guest.stages_left) continue;
    guest.check_at = time + kPlanInterval;
    guest.stages_left = left;
    if (has_plan(guest)) continue;
    guest.gone = true;
    replanned.emplace_back(guest.id, guest.position);
  }
  drop_gone();
  for (const auto& [id, position] : replanned) {
    past_[id] = {};
    past_[id].was_controlled = true;
    consider(id, &position, fleet);
  }
}

void Takeover::consider(const std::string& id, const Vec2* known_position, const Fleet& fleet) {
  const auto found = network_.edge_index.find(api::Person::getRoadID(id));
  if (found == network_.edge_index.end()) return;
  const int edge = found->second;
  const int zone = zone_of_edge_[edge];
  if (zone < 0) return;
  Past& past = past_[id];
  if (past.refused_edge == edge) return;
  const libsumo::TraCIStage stage = api::Person::getStage(id);
  if (stage.type != libsumo::STAGE_WALKING) return;

  const std::vector<std::string> edges = api::Person::getEdges(id);
  const std::size_t plan = hash_plan(api::Person::getRemainingStages(id), edges);
  if (past.plan != plan) {
    past.plan = plan;
    past.last = -1;
  }
  past.refused_edge = edge;  // unless all goes well below
  const std::vector<int> route = edge_indices(network_, edges);
  const int index = only_index(route, edge, past.last);
  if (index < 0) return;
  const auto there = api::Person::getPosition(id);
  const Vec2 position = known_position ? *known_position : Vec2(there.x, there.y);
  const auto walk = plan_walk(zone, route, index, stage.arrivalPos, position);
  if (!walk) return;
  // Who was walked until now goes on even so: SUMO would walk on from where it was taken over.
  if (!known_position && !worth_while(*walk, index, position)) return;
  past.refused_edge = -1;
  // SUMO walks people through vehicles. Whom it brings here inside one is put beside it. (Whom the
  // crowd walked until now is where the crowd put it.)
  const bool blocked = !known_position && fleet.touches(walk->start, body_radius(id));
  const bool departs = !known_position && index == 0 && api::Person::getSpeed(id) == 0.0;
  if (!add_guest(id, zone, *walk, plan, blocked || departs, fleet)) return;
  if (!past.was_controlled) ++totals_.controlled;
  past.was_controlled = true;
}

bool Takeover::worth_while(const Walk& walk, int index, const Vec2& position) const {
  return walk.stretch.last != index ||
         left_on_last(network_, walk.stretch, position) >= kWorthWhile;
}

/// The walk of a person at `position` on route[index]; nothing where pedzone cannot take it over.
std::optional<Takeover::Walk> Takeover::plan_walk(int zone, const std::vector<int>& route,
                                                  int index, double arrival_position,
                                                  const Vec2& position) const {
  const auto stretch = plan_stretch(network_, zones_[zone], route, index, arrival_position);
  if (!stretch) return std::nullopt;
  const Vec2 inside = zones_[zone].walls.nearest_inside(position, 0.0);
  if ((inside - position).norm() > kStray) return std::nullopt;
  const Vec2 goal = 0.5 * (stretch->destination.a + stretch->destination.b);
  if (!zones_[zone].ways.way(inside, goal)) return std::nullopt;
  return Walk{*stretch, inside};
}

/// False, and nothing has changed, where there is no room beside a vehicle.
bool Takeover::add_guest(const std::string& id, int zone, const Walk& walk, std::size_t plan,
                         bool place_freely, const Fleet& fleet) {
  Guest guest;
  guest.id = id;
  guest.zone = zone;
  guest.stretch = walk.stretch;
  guest.plan = plan;
  guest.radius = body_radius(id);
  guest.preferred_speed = striping_share_ * api::Person::getMaxSpeed(id);
  const PersonHints hints = read_hints(id, {profiles_, paths_});
  NewPerson person;
  person.key = person_key(id);
  person.profile = hints.profile;
  person.aware = hints.aware;
  person.group = hints.group;
  person.rates = hints.rates;
  if (hints.path != nullptr) person.path = hints.path->waypoints(static_cast<std::size_t>(zone));
  person.position = walk.start;
  person.heading = radians_from_sumo(api::Person::getAngle(id));
  person.velocity = unit(person.heading) *
                    std::min(std::max(0.0, api::Person::getSpeed(id)), guest.preferred_speed);
  person.radius = guest.radius;
  person.preferred_speed = guest.preferred_speed;
  person.destination = with_room(walk.stretch.destination, guest.radius);
  person.place_freely = place_freely;
  guest.handle = crowds_[zone]->add(person);
  guest.position = crowds_[zone]->view(guest.handle).position;
  if (place_freely && fleet.touches(guest.position, guest.radius)) {
    crowds_[zone]->remove(guest.handle);
    return false;
  }
  bystanders_.set_guest(id, true);
  guest_index_[id] = guests_.size();
  guests_.push_back(std::move(guest));
  return true;
}

/// Gives a person back to SUMO where the crowd has brought it. False: not yet.
bool Takeover::hand_over(const Guest& guest, const PersonView& view, double dt) {
  const ZoneStretch& stretch = guest.stretch;
  const std::string& lane_id = network_.lanes[stretch.lane].id;
  const Lane& lane = network_.lanes[stretch.lane];
  const double side = std::max(0.0, 0.5 * lane.width - guest.radius);
  double position = stretch.position;
  double lateral = project_on_lane(lane, view.position).lateral;
  if (stretch.release == Release::kLeave) {
    // SUMO walks the person for this step: start from where it was at the step's beginning.
    const double at = project_on_lane(lane, guest.position).offset;
    const double reach = guest.preferred_speed * dt + 0.5;
    position = stretch.forward ? std::clamp(at, position - reach, position)
                               : std::clamp(at, position, position + reach);
    position = std::clamp(position, 0.0, lane.length);
  }
  lateral = std::clamp(lateral, -side, side);
  if (stretch.release == Release::kRemoveStage) {
    api::Person::removeStage(guest.id, 0);
    return true;
  }
  const Lane& hop = network_.lanes[stretch.hop_lane];
  const std::string present = api::Person::getLaneID(guest.id);
  if (stretch.release == Release::kStepOver) {
    // By way of the edge before, or SUMO takes the next one for the begin of a walk.
    if (present == hop.id) api::Person::moveTo(guest.id, lane_id, 0.5 * lane.length);
    api::Person::moveTo(guest.id, hop.id, 0.5 * hop.length);
  } else if (present == lane_id) {
    api::Person::moveTo(guest.id, hop.id, 0.5 * hop.length);
  }
  api::Person::moveTo(guest.id, lane_id, position, lateral);
  return true;
}

/// SUMO walks people into vehicles: not beside one that moves or will. For one that waits for
/// people a person does not wait for ever, since that may be the one it waits for.
bool Takeover::may_hand_over(Guest& guest, const Vec2& place, double dt, const Fleet& fleet) {
  const double room = guest.radius + kHandOverSide;
  if (fleet.approaches(place, room, kHandOverLook)) return false;
  const FleetVehicle* beside = fleet.waiting_beside(place, room);
  if (beside == nullptr || guest.held >= kHandOverPatience) return true;
  if (beside->commanded >= 0.0) guest.held += dt;
  return false;
}

/// The crowds know handles only.
void Takeover::list_jams(double time) {
  for (std::size_t z = 0; z < crowds_.size(); ++z) {
    for (const JamNotice& jam : crowds_[z]->jams()) {
      const auto found = std::ranges::find_if(guests_, [&](const Guest& guest) {
        return guest.zone == static_cast<int>(z) && guest.handle == jam.handle;
      });
      if (found != guests_.end()) {
        jams_.push_back({time, found->id, zones_[z].id, jam.position});
      }
    }
  }
}

void Takeover::write(double time, double dt, const Fleet& fleet) {
  list_jams(time);
  for (Guest& guest : guests_) {
    const PersonView view = crowds_[guest.zone]->view(guest.handle);
    const double walked = (view.position - guest.position).norm();
    totals_.distance += walked;
    totals_.time += dt;
    if (guest.preferred_speed > 0.0) totals_.free_time += walked / guest.preferred_speed;
    if (view.activity != Activity::kWalking) totals_.waiting += dt;
    if (view.arrived && !has_plan(guest)) guest.check_at = 0.0;
    if (view.arrived && guest.check_at > 0.0 && may_hand_over(guest, view.position, dt, fleet)) {
      guest.gone = hand_over(guest, view, dt);
      past_[guest.id].last = guest.stretch.last;
    } else {
      api::Person::moveToXY(guest.id, "", view.position.x(), view.position.y(),
                            sumo_from_radians(view.heading), kKeepRouteFree, kNoMatch);
    }
    guest.colour.show(guest.id, guest.gone ? Pastime::kNone : view.pastime);
    guest.position = view.position;
  }
  drop_gone();
}

void Takeover::drop_gone() {
  const auto gone = [](const Guest& guest) { return guest.gone; };
  if (std::none_of(guests_.begin(), guests_.end(), gone)) return;
  for (const Guest& guest : guests_) {
    if (!guest.gone) continue;
    crowds_[guest.zone]->remove(guest.handle);
    bystanders_.set_guest(guest.id, false);
  }
  std::erase_if(guests_, gone);
  guest_index_.clear();
  for (std::size_t i = 0; i < guests_.size(); ++i) guest_index_[guests_[i].id] = i;
}

void Takeover::people(std::vector<PersonAhead>& out) const {
  out.clear();
  for (const Guest& guest : guests_) {
    const PersonView view = crowds_[guest.zone]->view(guest.handle);
    out.push_back({view.position, view.velocity, guest.radius});
  }
}

void Takeover::add_bystanders(std::vector<PersonAhead>& out) const {
  for (const auto& near_zone : seen_) {
    for (const SeenPerson& person : near_zone) {
      out.push_back({person.position, person.velocity, person.radius});
    }
  }
}

}  // namespace pedzone
