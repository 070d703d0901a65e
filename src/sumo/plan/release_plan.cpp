#include "sumo/plan/release_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sumo/plan/lane_end.hpp"
#include "zone/lane_geometry.hpp"

namespace pedzone {
namespace {

constexpr double kVehicleLook = 5.0;  // [s] assumed: no release before a vehicle this near ...
constexpr double kVehicleSide = 0.5;  // [m] ... whose swept area comes this near
constexpr double kPatience = 10.0;    // [s] assumed; then only one that would touch it counts ...
constexpr double kSoon = 2.0;         // [s] ... so soon
constexpr double kAtSide = 0.4;       // [m] numerical: nearer to its side than SUMO's second stripe
constexpr double kCar = VehicleTraits{}.width, kPerson = 0.478;  // [m] SUMO's usual widths
constexpr double kOverlap = 0.03;                                // [m] numerical
constexpr double kAheadOf = 1.25;    // [m] of a vehicle: SUMO's gap of 1 m, and a body
constexpr double kLongest = 30.0;    // [s] assumed, all together; for one that comes on its lane
constexpr double kWalks = 1.5;       // [m/s] assumed: a faster one is not before people who walk on
constexpr double kStepsOver = 0.05;  // [m] numerical: beyond the end SUMO has it on the next lane
constexpr double kReachBeyond = 0.5;  // [m] numerical: more than a step's walk

/// [m] on the lane. Where the walk goes on, SUMO walks the person for this step: it starts from
/// where it was at the step's beginning.
double release_position(const Lane& lane, const ZoneStretch& stretch, const Walked& walked,
                        double dt) {
  if (stretch.release != Release::kLeave) return stretch.position;
  const double at = project_on_lane(lane, walked.from).offset;
  const double reach = walked.preferred_speed * dt + kReachBeyond;
  const double position = stretch.forward
                              ? std::clamp(at, stretch.position - reach, stretch.position)
                              : std::clamp(at, stretch.position, stretch.position + reach);
  return std::clamp(position, 0.0, lane.length);
}

/// [m] from the lane's middle, at most: so far the body is on it.
double most_on_lane(const Lane& lane, double radius) {
  return std::max(0.0, 0.5 * lane.width - radius);
}

/// [m] from the lane's middle, at most, where vehicles drive, too. SUMO has nobody walk on right
/// before a vehicle whose share of the lane, by whole stripes, is the last one, too: only whom the
/// vehicle would touch.
double most_beside_vehicles(const Network& network, const Lane& lane, double radius) {
  const double most = most_on_lane(lane, radius);
  const bool is_free =
      network.left_hand
          ? lane.width - kCar >= 2.0 * kStripe
          : lane.width + kCar < 2.0 * kStripe * (std::floor(lane.width / kStripe) - 1.0);
  return is_free ? most : std::min(most, 0.5 * kCar + std::min(kPerson, 2.0 * radius) - kOverlap);
}

/// [m] on the lane. SUMO keeps whom it gets there on its stripe: where vehicles drive, too, on that
/// at the side, or they follow it at its pace.
double release_lateral(const Network& network, const ZoneStretch& stretch, double lateral,
                       double radius) {
  const Lane& lane = network.lanes[stretch.lane];
  if (!lane.vehicles || stretch.release != Release::kLeave) {
    const double most = most_on_lane(lane, radius);
    return std::clamp(lateral, -most, most);
  }
  const double most = most_beside_vehicles(network, lane, radius);
  const double outer = network.left_hand ? 1.0 : -1.0;
  const double least =
      std::clamp(0.5 * lane.width - kAtSide, 0.0, std::min(most, kClearOfVehicles));
  return std::abs(lateral) < least ? outer * least : std::clamp(lateral, -most, most);
}

/// Another lane that SUMO can put a person on who is on the route's edge `index`; -1: none.
int hop_beside(const Network& network, const std::vector<int>& route, int index) {
  for (const int other : {index - 1, index + 1}) {
    if (other < 0 || other >= static_cast<int>(route.size()) || route[other] < 0) continue;
    if (route[other] == route[index] || !is_first_occurrence(route, other)) continue;
    if (const int lane = walking_lane(network, route[other]); lane >= 0) return lane;
  }
  const int own = walking_lane(network, route[index]);
  for (const int lane : network.edges[route[index]].lanes) {
    if (lane != own) return lane;
  }
  return -1;
}

}  // namespace

ReleasePlan plan_release(const Network& network, const ZoneStretch& stretch, const Walked& walked,
                         const std::string& present_lane, double dt) {
  ReleasePlan plan;
  if (stretch.release == Release::kRemoveStage) {
    plan.remove_stage = true;
    return plan;
  }
  const Lane& lane = network.lanes[stretch.lane];
  const Lane& hop = network.lanes[stretch.hop_lane];
  if (stretch.release == Release::kStepOver) {
    // By way of the edge before, or SUMO takes the next one for the begin of a walk.
    if (present_lane == hop.id) plan.moves.push_back({lane.id, 0.5 * lane.length, {}});
    plan.moves.push_back({hop.id, 0.5 * hop.length, {}});
  } else if (present_lane == lane.id) {
    plan.moves.push_back({hop.id, 0.5 * hop.length, {}});
  }
  const double lateral = project_on_lane(lane, walked.to).lateral;
  plan.moves.push_back({lane.id, release_position(lane, stretch, walked, dt),
                        release_lateral(network, stretch, lateral, walked.radius)});
  return plan;
}

bool go_ahead_of_vehicles(const Network& network, const ZoneStretch& stretch, const Fleet& fleet,
                          double dt, double& kept, ReleasePlan& plan) {
  if (stretch.release != Release::kLeave || !stretch.forward || plan.moves.empty()) return true;
  const Lane& lane = network.lanes[stretch.lane];
  double& position = plan.moves.back().position;
  // The nearest last: who is put ahead of one may come before another.
  std::vector<std::pair<double, double>> on_lane;  // [m] front, [m/s]
  for (const FleetVehicle& vehicle : fleet.vehicles()) {
    if (vehicle.lane != stretch.lane) continue;
    on_lane.emplace_back(project_on_lane(lane, vehicle.front).offset, vehicle.speed);
  }
  std::ranges::sort(on_lane);
  for (const auto& [front, speed] : on_lane) {
    if (front >= position) continue;
    const double first = front + kAheadOf;
    if (speed <= kWalks) {
      position = std::max(position, std::min(first, lane.length + kStepsOver));
    } else if (first + speed * kSoon > position && kept < kLongest) {
      kept += dt;
      return false;
    }
  }
  return true;
}

std::optional<ReleasePlan> plan_let_go(const Network& network, const std::vector<int>& route,
                                       int last, const Vec2& position, double radius,
                                       const std::string& present_lane) {
  int best = -1;
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= std::min(last, static_cast<int>(route.size()) - 1); ++i) {
    if (route[i] < 0 || is_too_short(network, route[i]) || !is_first_occurrence(route, i)) continue;
    const Lane& lane = network.lanes[walking_lane(network, route[i])];
    const double distance = distance_to_lane(lane, position);
    if (distance < nearest) {
      nearest = distance;
      best = i;
    }
  }
  if (best < 0) return std::nullopt;
  const Lane& lane = network.lanes[walking_lane(network, route[best])];
  ReleasePlan plan;
  if (present_lane == lane.id) {
    const int hop = hop_beside(network, route, best);
    plan.begin_anew = hop < 0;
    if (hop >= 0)
      plan.moves.push_back({network.lanes[hop].id, 0.5 * network.lanes[hop].length, {}});
  }
  const auto [offset, lateral] = project_on_lane(lane, position);
  const double side = most_on_lane(lane, radius);
  plan.moves.push_back(
      {lane.id, std::clamp(offset, 0.0, lane.length), std::clamp(lateral, -side, side)});
  return plan;
}

std::optional<Vec2> place_of(const Network& network, const ReleasePlan& plan) {
  if (plan.moves.empty()) return std::nullopt;
  const LaneMove& last = plan.moves.back();
  const Lane& lane = network.lanes[network.lane_index.at(last.lane)];
  const LinePoint at = point_on_lane(lane, last.position);
  return at.point + left_of(at.direction) * last.lateral.value_or(0.0);
}

bool ends_trip(const ZoneStretch& stretch, int stages_left) {
  const bool arrives =
      stretch.release == Release::kArrive || stretch.release == Release::kRemoveStage;
  return arrives && stages_left == 1;
}

bool may_release(const Vec2& place, const Walked& walked, const Fleet& fleet, double dt,
                 double& kept) {
  const double room = walked.radius + kVehicleSide;
  const bool patient = kept < kPatience;
  if (patient ? fleet.approaches(place, room, kVehicleLook)
              : !walked.ends_trip && fleet.approaches(place, walked.radius, kSoon)) {
    kept += dt;
    return false;
  }
  const FleetVehicle* beside = fleet.waiting_beside(place, room);
  if (beside == nullptr || walked.ends_trip || !patient) return true;
  if (beside->commanded >= 0.0 || beside->lets_go) kept += dt;
  return false;
}

bool may_hand_over(const Walked& walked, const std::optional<Vec2>& place, const Fleet& fleet,
                   double dt, double& kept) {
  return may_release(walked.to, walked, fleet, dt, kept) &&
         (!place || may_release(*place, walked, fleet, dt, kept));
}

}  // namespace pedzone
