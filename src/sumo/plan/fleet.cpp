#include "sumo/plan/fleet.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <unordered_map>

#include "core/random.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kNear = 60.0;  // [m] numerical: vehicles farther from every zone are not read on,
                                // unless they need more to stop
constexpr double kNearStreets = 150.0;  // [m] ... where people cross streets: as far as they look
constexpr double kReaction = 1.0;       // [s] SUMO's default (tau)
constexpr double kLookAhead = 30.0;     // [m] numerical: least length of the way that is built
constexpr double kLeaderAhead = 10.0;   // [m] numerical: who is farther ahead lets it drive off
constexpr double kRounding = 1e-6;      // [m] numerical
constexpr double kWaitingSpeed = 0.5;   // [m/s] numerical: slower vehicles wait

/// Whether any of a line is in a box, which is wider than kNear: of a long vehicle the front and
/// the rear may be beyond it.
bool comes_into(const Box& box, const Vec2& from, const Vec2& to) {
  const Vec2 line = to - from;
  const double pieces = std::max(1.0, std::ceil(line.norm() / kNear));
  for (double k = 0.0; k <= pieces; ++k) {
    if (box.contains(Vec2(from + line * (k / pieces)))) return true;
  }
  return false;
}

/// What is carried over of what a vehicle was told, after a step of `dt` [s].
void carry_command(const FleetVehicle& old, double dt, FleetVehicle& vehicle) {
  vehicle.commanded = old.commanded;
  vehicle.left_alone = old.commanded >= 0.0 ? 0.0 : old.left_alone + dt;
  vehicle.pull = old.pull;
}

/// What else is, if it drove to where it is now.
void carry_over(const FleetVehicle& old, double dt, FleetVehicle& vehicle) {
  vehicle.seen_for = old.seen_for + dt;
  vehicle.new_loss = vehicle.time_loss - old.time_loss;
  vehicle.blocked_time = old.blocked_time;
  vehicle.gave_way = old.gave_way;
  vehicle.creeping = old.creeping;
  vehicle.slowed = old.slowed;
  vehicle.gain = old.gain;
  vehicle.gain.follow(vehicle.speed, dt);
  const bool told = old.commanded >= 0.0 && old.commanded < kHaltingSpeed;
  vehicle.waits = !told && std::max(old.speed, vehicle.speed) < kHaltingSpeed;
  const Vec2 moved = vehicle.centre() - old.centre();
  if (dt > 0.0 && moved.norm() > kShortMove) vehicle.velocity = moved.normalized() * vehicle.speed;
}

/// [m/s] sideways on its lane since a step of `dt` [s] before.
double drift_of(const Network& network, const FleetVehicle& before, const FleetVehicle& vehicle,
                double dt) {
  if (!vehicle.traits.drifts || vehicle.lane < 0 || before.lane < 0 || dt <= 0.0) return 0.0;
  const Lane& lane = network.lanes[vehicle.lane];
  if (network.lanes[before.lane].edge != lane.edge) return 0.0;
  return (vehicle.lateral - project_on(lane.shape, before.front).lateral) / dt;
}

/// [m/s] that is safe `gap` [m] behind one that drives at `speed` and may brake as hard: SUMO's
/// default model (Krauss 1998), with its reaction time of 1 s.
double safe_behind(const VehicleTraits& traits, double gap, double speed) {
  const double room = std::max(0.0, gap - traits.min_gap);
  return -traits.decel + std::sqrt(traits.decel * (traits.decel + 2.0 * room) + speed * speed);
}

/// [m] from the vehicle's front to the other's body along its way; nothing where that is not ahead
/// on it, within `distance` [m].
std::optional<double> gap_before(const FleetVehicle& vehicle, const FleetVehicle& other,
                                 double distance) {
  const Vec2 to = other.front - vehicle.front;
  if (to.norm() > distance + other.traits.length) return std::nullopt;
  std::optional<double> gap;
  const double sideways = 0.5 * (vehicle.traits.width + other.traits.width);
  const VehicleBody body = body_of(other);
  for (const Rectangle& part : body.parts()) {
    for (const double along : {1.0, 0.0, -1.0}) {
      const Vec2 point = part.centre + part.axis * (along * part.half.x());
      const LineProjection at = project_on(vehicle.way, point);
      const double ahead = at.offset - vehicle.traits.length;
      if (ahead <= 0.0 || std::abs(at.lateral) >= sideways) continue;
      gap = std::min(gap.value_or(ahead), ahead);
    }
  }
  return gap && *gap <= distance ? gap : std::nullopt;
}

/// [m/s] it will drive in the next step of `dt` [s], as far as it can be foreseen, in the mean.
struct NextSpeed {
  double least = 0.0, expected = 0.0, most = 0.0;
};

/// Expected is as fast as it may: taken too fast, people behind it walk into its rear (in steps of
/// 1 s by metres), so that behind another it is expected to keep its distance, braking as it likes.
NextSpeed next_speed(const FleetVehicle& vehicle, double dt) {
  NextSpeed next;
  next.most = std::min(vehicle.speed + vehicle.traits.accel * dt,
                       std::max(vehicle.allowed_speed, vehicle.speed));
  if (vehicle.commanded >= 0.0) next.most = std::min(next.most, vehicle.commanded);
  const double slowest = speed_if_braked(vehicle, dt);
  next.expected = std::min(next.most, std::max(vehicle.follows_at, slowest));
  if (vehicle.stopped || vehicle.waits) next.expected = 0.0;  // as long as it does not drive off
  next.least = std::min(slowest, next.expected);
  for (double* const speed : {&next.least, &next.expected, &next.most}) {
    *speed = speed_within(vehicle.traits, vehicle.speed, *speed, 0.5);
  }
  return next;
}

/// As people see the vehicle, but for where its parts are and how they move.
VehicleState looks_of(const FleetVehicle& vehicle) {
  VehicleState state;
  state.width = vehicle.traits.width;
  state.way = vehicle.way;
  state.yields_at = vehicle.yields_at;
  state.leaves = vehicle.leaves;
  state.key = person_key(vehicle.id);
  state.electric = vehicle.traits.electric;
  state.horn = vehicle.horn;
  state.invites = vehicle.invites;
  return state;
}

/// How a part moves that gets to `later` within `dt` [s].
void set_motion(const FleetVehicle& vehicle, const NextSpeed& next, const Rectangle& later,
                double dt, VehicleState& part) {
  const Vec2 moved = later.centre - part.centre;
  part.velocity =
      moved.norm() > 0.0 ? Vec2(moved.normalized() * next.expected) : Vec2(Vec2::Zero());
  part.forwards = true;
  part.yaw_rate = wrap_angle(angle_of(later.axis) - part.heading) / dt;
  part.slower = next.expected - next.least;
  // The velocity is what it will drive in the step: in a long one the gain is in it.
  const double shown = next.expected - vehicle.speed;
  if (shown >= 0.0) part.gain = std::max(0.0, vehicle.gain.ahead() - shown);
  if (!vehicle.stopped) (vehicle.waits ? part.starts : part.lead) = next.most * dt;
}

/// The same of one that moves on as it did: nobody knows its way.
void set_last_motion(const FleetVehicle& vehicle, VehicleState& part) {
  part.velocity = vehicle.velocity;
  if (vehicle.traits.parts.bends()) {
    part.velocity = unit(part.heading) * vehicle.velocity.dot(unit(vehicle.heading));
  }
  part.yaw_rate = vehicle.yaw_rate;
  part.gain = vehicle.gain.ahead();
}

/// Makes the rear of each part a point of the vehicle's way: the part's own begins there.
void mark_parts(FleetVehicle& vehicle) {
  const VehicleTraits& traits = vehicle.traits;
  for (int k = 0; k < traits.parts.others; ++k) {
    insert_point(part_of(traits.parts, traits.length, k).rear, vehicle.way);
  }
}

/// The way of a part, from its rear on, as far as that is a point of the vehicle's.
void set_way(const FleetVehicle& vehicle, double rear, VehicleState& part) {
  std::span<const Vec2> way = vehicle.way;
  double left = rear;
  while (way.size() > 1) {
    const double piece = (way[1] - way[0]).norm();
    if (piece > left + kRounding) break;
    left -= piece;
    way = way.subspan(1);
  }
  part.way = way;
  part.gone = std::max(0.0, left);
}

/// Adds each part of the vehicle, its first one first.
void add_states(const FleetVehicle& vehicle, double dt, std::vector<VehicleState>& out) {
  const VehicleTraits& traits = vehicle.traits;
  const bool foreseen = !traits.external && !vehicle.reverses && goes_on(vehicle) && dt > 0.0;
  const NextSpeed next = foreseen ? next_speed(vehicle, dt) : NextSpeed{};
  const VehicleBody now = body_of(vehicle);
  const VehicleBody later = body_after(vehicle, next.expected * dt);
  for (int k = 0; k < static_cast<int>(now.parts().size()); ++k) {
    const VehiclePart part = part_of(traits.parts, traits.length, k);
    VehicleState state = looks_of(vehicle);
    state.centre = now.parts()[k].centre;
    state.heading = traits.parts.bends() ? angle_of(now.parts()[k].axis) : vehicle.heading;
    state.length = 2.0 * now.parts()[k].half.x();
    if (traits.parts.bends()) set_way(vehicle, part.rear, state);
    // Each part asks for the room up to there: in a bend those behind sweep what is beside it.
    if (vehicle.claim > 0.0) state.claim = vehicle.claim + traits.length - part.rear - part.length;
    state.claimed = vehicle.slowed;
    if (foreseen) {
      set_motion(vehicle, next, later.parts()[k], dt, state);
    } else {
      set_last_motion(vehicle, state);
    }
    out.push_back(state);
  }
}

/// [m] in which a usual vehicle stops that comes to the zone as fast as it may.
double stopping_distance(const Network& network, const Zone& zone) {
  const std::set<int> edges(zone.edges.begin(), zone.edges.end());
  const auto is_in = [&](int lane) { return edges.contains(network.lanes[lane].edge); };
  FleetVehicle usual;
  usual.traits.decel *= zone.weather->deceleration;
  const auto take = [&](const Lane& lane) {
    if (lane.vehicles) usual.speed = std::max(usual.speed, lane.speed);
  };
  for (const int edge : edges) {
    for (const int lane : network.edges[edge].lanes) take(network.lanes[lane]);
  }
  for (const Connection& connection : network.connections) {
    if (is_in(connection.to)) take(network.lanes[connection.from]);
  }
  return braking_distance(usual) + usual.speed * kReaction;
}

}  // namespace

Fleet::Fleet(const Network& network, const std::vector<Zone>& zones)
    : network_(network), ways_(network, zones) {
  for (const Zone& zone : zones) {
    grip_ = std::min(grip_, zone.weather->deceleration);
    const double near =
        std::max(zone.streets.empty() ? kNear : kNearStreets, stopping_distance(network, zone));
    boxes_.push_back(grown(box_of(zone.walkable), near));
  }
}

bool Fleet::near_zone(const Vec2& point) const {
  return std::ranges::any_of(boxes_, [&](const Box& box) { return box.contains(point); });
}

bool Fleet::near_zone(const Vec2& front, const Vec2& rear) const {
  return std::ranges::any_of(boxes_, [&](const Box& box) { return comes_into(box, front, rear); });
}

std::vector<VehicleState> Fleet::states_near(std::size_t zone,
                                             std::span<const VehicleState> states) const {
  std::vector<VehicleState> near;
  for (const VehicleState& state : states) {
    const Vec2 half = 0.5 * state.length * unit(state.heading);
    if (comes_into(boxes_[zone], state.centre + half, state.centre - half)) near.push_back(state);
  }
  return near;
}

void Fleet::update(std::vector<VehicleSeen> seen, double dt) {
  std::swap(vehicles_, previous_);
  vehicles_.clear();
  previous_index_.clear();
  for (std::size_t i = 0; i < previous_.size(); ++i) previous_index_[previous_[i].id] = i;
  for (const std::string& id : replaced_) previous_index_.erase(id);
  for (VehicleSeen& told : seen) {
    FleetVehicle vehicle;
    static_cast<VehicleSeen&>(vehicle) = std::move(told);
    vehicle.velocity = unit(vehicle.heading) * vehicle.speed;
    vehicle.gain = SpeedGain(vehicle.speed);
    const auto found = previous_index_.find(vehicle.id);
    const FleetVehicle* const before =
        found == previous_index_.end() ? nullptr : &previous_[found->second];
    // Told to stand, it is seen until it has been let go.
    const bool is_told = before != nullptr && before->commanded >= 0.0;
    if (ways_.is_apart(vehicle.lane) && !is_told) continue;
    const bool drove_here = before != nullptr && !teleported_.contains(vehicle.id);
    if (before != nullptr) carry_command(*before, dt, vehicle);
    if (drove_here) {
      carry_over(*before, dt, vehicle);
      ways_.remember(*before, vehicle);
      vehicle.drift = drift_of(network_, *before, vehicle, dt);
    }
    ways_.look(vehicle, braking_distance(vehicle) + kLookAhead);
    mark_parts(vehicle);
    vehicle.reverses = drove_here && came_from_ahead(vehicle, before->front);
    vehicles_.push_back(std::move(vehicle));
  }
  replaced_.clear();
  teleported_.clear();
  share_junctions();
  note_places();
  find_leaders();
}

void Fleet::note_places() {
  std::vector<Vec2> fronts;
  longest_ = widest_ = 0.0;
  for (const FleetVehicle& vehicle : vehicles_) {
    fronts.push_back(vehicle.front);
    longest_ = std::max(longest_, vehicle.traits.length);
    widest_ = std::max(widest_, vehicle.traits.width);
  }
  fronts_.build(fronts);
}

/// Those whose bodies may be within `reach` [m] of a place, and a few more, in their order.
std::vector<std::uint32_t> Fleet::near(const Vec2& place, double reach) const {
  constexpr double kRounding = 1.0;  // [m] numerical: farther than needed
  return fronts_.within(place, reach + longest_ + widest_ + kRounding);
}

/// In a queue nobody drives off before the one ahead: people behind it would walk into its rear.
void Fleet::find_leaders() {
  for (FleetVehicle& vehicle : vehicles_) {
    if (!goes_on(vehicle)) continue;
    const double distance = braking_distance(vehicle) + vehicle.speed + kLeaderAhead;
    for (const std::uint32_t k : near(vehicle.front, distance)) {
      const FleetVehicle& other = vehicles_[k];
      const auto gap = &other == &vehicle ? std::nullopt : gap_before(vehicle, other, distance);
      if (!gap) continue;
      vehicle.follows_at =
          std::min(vehicle.follows_at, safe_behind(vehicle.traits, *gap, other.speed));
      if (!vehicle.leader || *gap < vehicle.leader->gap) vehicle.leader = {k, *gap};
    }
  }
}

/// Tells which vehicles come to a junction, or are in it, with others from another edge.
void Fleet::share_junctions() {
  std::unordered_map<int, std::set<int>> edges;  // by junction
  const auto edge_of = [&](const FleetVehicle& v) { return network_.lanes[v.lane].edge; };
  for (const FleetVehicle& vehicle : vehicles_) {
    if (vehicle.junction.junction >= 0 && vehicle.lane >= 0) {
      edges[vehicle.junction.junction].insert(edge_of(vehicle));
    }
  }
  for (FleetVehicle& vehicle : vehicles_) {
    const auto found = edges.find(vehicle.junction.junction);
    vehicle.junction.shared = found != edges.end() && vehicle.lane >= 0 && found->second.size() > 1;
  }
}

void Fleet::states(double dt, std::vector<VehicleState>& out) const {
  out.clear();
  for (const FleetVehicle& vehicle : vehicles_) {
    if (!ways_.is_apart(vehicle.lane)) add_states(vehicle, dt, out);
  }
}

bool Fleet::touches(const Vec2& point, double radius) const {
  return std::ranges::any_of(near(point, radius), [&](std::uint32_t k) {
    return body_of(vehicles_[k]).signed_distance(point) < radius;
  });
}

bool Fleet::approaches(const Vec2& point, double margin, double horizon) const {
  constexpr double kStep = 1.0;  // [m] numerical: sampling of the swept area
  for (const FleetVehicle& vehicle : vehicles_) {
    if (vehicle.speed < kWaitingSpeed) continue;
    const double reach = vehicle.speed * horizon;
    if ((point - vehicle.front).norm() > reach + vehicle.traits.length + margin) continue;
    for (double travelled = 0.0; travelled <= reach; travelled += kStep) {
      if (body_after(vehicle, travelled).signed_distance(point) < margin) return true;
    }
  }
  return false;
}

const FleetVehicle* Fleet::waiting_beside(const Vec2& point, double margin) const {
  for (const std::uint32_t k : near(point, margin)) {
    const FleetVehicle& vehicle = vehicles_[k];
    const bool waits = vehicle.speed < kWaitingSpeed && !vehicle.stopped;
    if (waits && body_of(vehicle).signed_distance(point) < margin) return &vehicle;
  }
  return nullptr;
}

}  // namespace pedzone
