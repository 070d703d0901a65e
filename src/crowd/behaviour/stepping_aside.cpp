#include "crowd/behaviour/stepping_aside.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "crowd/behaviour/claims.hpp"
#include "crowd/behaviour/way.hpp"
#include "crowd/sense/side_room.hpp"
#include "crowd/sense/vehicle_motion.hpp"
#include "crowd/state/parallel.hpp"
#include "geometry/polyline.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kThere = 0.05;     // [m] numerical: so near to its place somebody stands there
constexpr double kApproach = 0.5;   // [s] assumed: time constant with which a place is approached
constexpr double kBefore = 2.0;     // [m] assumed: so far before it a vehicle is gone round
constexpr double kAlong = 0.5;      // cosine: whoever crosses a vehicle's axis does not go past it
constexpr double kAimAhead = 0.6;   // [m] numerical: what is aimed at beside the vehicle
constexpr double kLookAhead = 1.2;  // [m] assumed: a driver expects people to go on so far
constexpr double kLookStep = 0.3;   // [m] numerical
constexpr double kAside = 0.7;      // [m] assumed: for who comes out of a narrow place
constexpr double kBesideReach = 2.0;  // [m] numerical: beyond a vehicle's ends and sides
constexpr double kPastShare = 0.6;    // assumed: of its speed is left to who goes sideways

BodyBeside body_of(const CrowdState& crowd, std::size_t i) {
  return {crowd.persons.radius[i], crowd.persons.turned_radius[i]};
}

/// The bodies of the vehicles within `reach` [m] of a place but one. Valid until the thread's next
/// call: the list is kept for its memory.
std::span<const Rectangle> other_vehicles(const CrowdState& crowd, const VehicleState& but,
                                          const Vec2& place, double reach) {
  thread_local std::vector<Rectangle> bodies;
  bodies.clear();
  for (const std::uint32_t v : crowd.vehicles_near.at(place, reach)) {
    if (&crowd.vehicles[v] != &but) bodies.push_back(crowd.vehicle_bodies[v]);
  }
  return bodies;
}

/// Towards a place that is `way` [m] away, at most at `speed` [m/s].
Decision step_to(const Vec2& way, double heading, double speed) {
  Decision decision;
  decision.turns = true;
  const double distance = way.norm();
  decision.direction = distance > kThere ? angle_of(way) : heading;
  decision.waits = distance <= kThere;
  decision.speed = decision.waits ? 0.0 : std::min(speed, distance / kApproach);
  decision.free_distance = distance;
  return decision;
}

/// A vehicle that stands, or creeps, as one sees it who wants to go past: u along its way, from
/// -length/2 to length/2 beside the vehicle.
class Passing {
 public:
  Passing(const CrowdState& crowd, std::size_t i, const VehicleState& vehicle)
      : crowd_(crowd), i_(i), vehicle_(vehicle), frame_(rectangle_of(vehicle)) {
    sign_ = along(i) >= 0.0 ? 1.0 : -1.0;
    local_ = frame_.into_frame(crowd.position(i));
  }

  std::optional<Decision> decide() const {
    if (std::abs(along(i_)) < kAlong || !in_reach()) return std::nullopt;
    const bool stands = vehicle_.velocity.norm() < kStaticSpeed;
    if (!stands && !beside()) return std::nullopt;  // nobody begins to
    const auto way = narrow_way();
    if (!way) return std::nullopt;
    const double entry = -frame_.half.x() - crowd_.persons.radius[i_];
    double aim = beside() ? u() + kAimAhead : std::max(entry, u());
    const bool lined_up = std::abs(local_.y() - way->lateral) < kThere;
    if (!beside() && lined_up) aim = u() + kAimAhead;
    double lateral = way->lateral;
    const auto comes = somebody_comes(lateral);
    if (comes && beside() && goes_back(*comes)) aim = u() - kAimAhead;
    if (comes && !beside()) {  // leaves the end free
      // ... but not in the room that the vehicle claims: it would wait for this one, and they for
      // it.
      if (can_leave_claim(crowd_, i_, vehicle_)) return std::nullopt;
      aim = std::min(u(), entry - kAside);
      lateral = 0.0;
    }
    const Vec2 to = frame_.out_of_frame({sign_ * aim, lateral});
    return step_to(to - crowd_.position(i_), crowd_.persons.heading[i_],
                   kPastShare * crowd_.persons.preferred_speed[i_]);
  }

  /// Whether the person's route leads past the vehicle, and there is no room beside it.
  bool is_shut_in() const { return along(i_) <= 0.0 && !way_at(own_side()); }

 private:
  /// Cosine of the angle between the person's way and the vehicle's axis.
  double along(std::size_t j) const {
    return unit(wish_of_route(crowd_, j).direction).dot(frame_.axis);
  }
  double u() const { return sign_ * local_.x(); }
  bool beside() const { return std::abs(local_.x()) < frame_.half.x(); }

  bool in_reach() const {
    const double radius = crowd_.persons.radius[i_], length = frame_.half.x();
    return u() > -length - radius - kBefore && u() < length + radius &&
           std::abs(local_.y()) < frame_.half.y() + 2.0 * radius;
  }

  double own_side() const { return local_.y() < 0.0 ? -1.0 : 1.0; }
  std::optional<SideWay> way_at(double side) const {
    const auto others =
        other_vehicles(crowd_, vehicle_, frame_.centre, frame_.half.sum() + kBesideReach);
    return way_beside({crowd_.zone.walls, others}, vehicle_, side, body_of(crowd_, i_));
  }

  /// The way past the vehicle, the own side first; nothing where nobody need turn.
  std::optional<SideWay> narrow_way() const {
    const auto first = way_at(own_side());
    if (beside()) return first && first->narrow ? first : std::nullopt;
    const auto second = way_at(-own_side());
    const bool wide = (first && !first->narrow) || (second && !second->narrow);
    if (wide) return std::nullopt;
    return first ? first : second;
  }

  /// The nearest in that way who comes the other way.
  std::optional<std::size_t> somebody_comes(double lateral) const {
    std::optional<std::size_t> nearest;
    std::pair<double, std::uint64_t> least;  // [m]; key: whatever the order of rows
    for (std::size_t j = 0; j < crowd_.persons.walking; ++j) {
      if (j == i_ || crowd_.walkers[j].arrived) continue;
      const Vec2 there = frame_.into_frame(crowd_.position(j));
      const bool in_way = std::abs(there.x()) < frame_.half.x() + kAside &&
                          std::abs(there.y() - lateral) < crowd_.persons.radius[j];
      const std::pair place{sign_ * there.x(), crowd_.persons.key[j]};
      const bool comes = in_way && sign_ * along(j) < -kAlong && place.first > u();
      if (!comes || (nearest && place >= least)) continue;
      nearest = j;
      least = place;
    }
    return nearest;
  }

  /// Of two that meet beside the vehicle the one goes back that is nearer to where it came in.
  bool goes_back(std::size_t j) const {
    const double own = frame_.half.x() + u();
    const double other = frame_.half.x() - sign_ * frame_.into_frame(crowd_.position(j)).x();
    return own < other || (own == other && crowd_.persons.key[i_] < crowd_.persons.key[j]);
  }

  const CrowdState& crowd_;
  std::size_t i_;
  const VehicleState& vehicle_;
  Rectangle frame_;
  double sign_ = 1.0;
  Vec2 local_ = Vec2::Zero();
};

/// Room beside the vehicle, with the others near row i in it. Valid until the thread's next call:
/// the list is kept for its memory.
SideRoom room_among_others(const CrowdState& crowd, std::size_t i, const VehicleState& vehicle) {
  static_assert(kStepsAside < VehiclesNear::kReach);
  thread_local std::vector<OtherBody> others;
  others.clear();
  const Vec2 here = crowd.position(i);
  for (std::size_t j = 0; j < crowd.persons.walking; ++j) {
    const Vec2 there = crowd.position(j);
    if (j == i || (there - here).squaredNorm() > kStepsAside * kStepsAside) continue;
    others.push_back({there, crowd.persons.turned_radius[j]});
  }
  return {crowd.zone.walls, other_vehicles(crowd, vehicle, here, VehiclesNear::kReach), others};
}

/// Out of what a vehicle that claims room is about to sweep with its rear, when it turns. Where
/// there is no place to step to the person goes on: the vehicle waits for who is beside it. Where
/// that leads nowhere, it goes the way that the vehicle takes, before it.
std::optional<Decision> leave_sweep(const CrowdState& crowd, std::size_t i,
                                    const VehicleState& vehicle) {
  const Vec2 here = crowd.position(i);
  const double heading = crowd.persons.heading[i], speed = crowd.persons.preferred_speed[i];
  const auto place =
      place_clear(room_among_others(crowd, i, vehicle), vehicle, here, body_of(crowd, i), heading);
  if (place) return step_to(*place - here, heading, speed);
  if (!Passing(crowd, i, vehicle).is_shut_in()) return std::nullopt;
  const double offset = project_on(vehicle.way, here).offset;
  return step_to(point_on(vehicle.way, offset).direction * kAimAhead, heading, speed);
}

/// Who is out of the sweep does not step into it.
std::optional<Decision> clear_of(const CrowdState& crowd, std::size_t i,
                                 const VehicleState& vehicle, const Decision& decided) {
  const Vec2 here = crowd.position(i);
  const double radius = crowd.persons.radius[i];
  if (swings_over(vehicle, here, radius)) return leave_sweep(crowd, i, vehicle);
  if (holds_up(vehicle, here, radius)) return std::nullopt;  // it cannot come past: no use to wait
  const Vec2 ahead = unit(decided.direction);
  bool enters = false;
  for (double way = kLookStep; way <= kLookAhead && !enters; way += kLookStep) {
    enters = swings_over(vehicle, here + ahead * way, radius);
  }
  if (!enters) return std::nullopt;
  return step_to(Vec2::Zero(), crowd.persons.heading[i], 0.0);
}

/// What person i does about a vehicle that claims room; nothing: what it has decided.
std::optional<Decision> decision_about_claim(const CrowdState& crowd, std::size_t i,
                                             const VehicleState& vehicle, bool in_claim,
                                             const Decision& decided) {
  if (!in_claim) return clear_of(crowd, i, vehicle, decided);
  if (can_leave_claim(crowd, i, vehicle)) return std::nullopt;
  const Vec2 here = crowd.position(i);
  const double margin = room_beside_claims(crowd, i);
  const auto place =
      place_aside(room_among_others(crowd, i, vehicle), vehicle, here, body_of(crowd, i), margin);
  if (!place) return std::nullopt;
  return step_to(*place - here, crowd.persons.heading[i], crowd.persons.preferred_speed[i]);
}

/// The nearest vehicle that is in the way decides.
std::optional<Decision> decision_about_slow(const CrowdState& crowd, std::size_t i) {
  std::optional<Decision> decision;
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::uint32_t v : crowd.vehicles_near.at(crowd.position(i))) {
    const VehicleState& vehicle = crowd.vehicles[v];
    if (!may_be_passed(vehicle) || far_from(vehicle, crowd.position(i))) continue;
    const double distance = crowd.vehicle_bodies[v].distance(crowd.position(i));
    if (distance >= nearest) continue;
    if (const auto passing = Passing(crowd, i, vehicle).decide()) {
      decision = passing;
      nearest = distance;
    }
  }
  return decision;
}

/// What person i does about vehicles; nothing: what it has decided.
std::optional<Decision> decision_about_vehicles(const CrowdState& crowd, std::size_t i,
                                                const Decision& decided) {
  std::optional<Decision> decision;
  visit_claims(crowd, i, [&](const VehicleState& vehicle, const auto& place) {
    if (!decision) decision = decision_about_claim(crowd, i, vehicle, place.has_value(), decided);
  });
  return decision ? decision : decision_about_slow(crowd, i);
}

}  // namespace

void step_aside(const CrowdState& crowd, std::vector<Decision>& decisions) {
  if (crowd.vehicles.empty()) return;
  for_each_block(crowd.persons.walking, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      if (crowd.walkers[i].arrived || crowd.children[crowd.handle(i)].holds_hand) continue;
      if (crowd.is_over(i)) continue;
      const auto decision = decision_about_vehicles(crowd, i, decisions[i]);
      if (decision) decisions[i] = *decision;
    }
  });
}

}  // namespace pedzone
