// Without this, a vehicle that yields to everybody before it and people who fill every gap stand
// before each other for ever: the direction heuristic sees a standing vehicle as a wall, and the
// waiting rule knows moving vehicles only. Not in the paper; its persons "in advance start making
// way", which is the model for it.
#include "crowd/behaviour/claims.hpp"

#include <algorithm>

#include "crowd/sense/claim_room.hpp"
#include "crowd/state/parallel.hpp"

namespace pedzone {
namespace {

constexpr double kBeside = 0.45;    // [m] assumed: room that people leave beside a held-up vehicle
constexpr double kBorder = 0.25;    // [m] numerical: who waits does so farther out than who leaves
constexpr double kLookAhead = 1.2;  // [m] assumed: a person stops so far before the claim's border
constexpr double kLookStep = 0.3;   // [m] numerical
constexpr double kCrossing = 3.0;   // [m] assumed: nobody steps across nearer to the bumper

/// The side to which there is room to step out of the claim, the nearer one first: 1 left, -1
/// right, 0 none. Inside a bend the rear sweeps more than the front: who stepped out there would
/// hold the vehicle up all the same.
double wide_side(const CrowdState& crowd, std::size_t i, const VehicleState& vehicle,
                 const ClaimPlace& place) {
  const Vec2 here = crowd.position(i);
  const double radius = crowd.persons.radius[i];
  const double nearer = place.lateral < 0.0 ? -1.0 : 1.0;
  const Vec2 outward = left_of(place.along) * nearer;
  const double border = 0.5 * vehicle.width + room_beside_claims(crowd, i);
  const auto is_barred = [&](const Vec2& out) {
    return std::ranges::any_of(crowd.vehicles_near.at(here), [&](std::uint32_t v) {
      const VehicleState& other = crowd.vehicles[v];
      return &other != &vehicle && may_be_passed(other) &&
             leads_through(other, here, here + out, 0.5 * radius);
    });
  };
  const auto is_free = [&](const Vec2& out) {
    return crowd.zone.walls.free_line(here, here + out, 0.5 * radius) && !is_barred(out) &&
           !holds_up(vehicle, here + out, radius);
  };
  if (is_free(outward * (border - std::abs(place.lateral)))) return nearer;
  const Vec2 across = -outward * (border + std::abs(place.lateral));
  return place.ahead > kCrossing && is_free(across) ? -nearer : 0.0;
}

/// Out of the claim: sideways where there is room, else ahead of the vehicle.
Vec2 way_out(const CrowdState& crowd, std::size_t i, const VehicleState& vehicle,
             const ClaimPlace& place, double own_direction) {
  const double chosen = wide_side(crowd, i, vehicle, place);
  if (chosen == 0.0) return place.along;
  const Vec2 side = left_of(place.along) * chosen;
  // The farther the vehicle, the more of its own way a person keeps.
  const double share = std::clamp(place.ahead / vehicle.claim, 0.0, 1.0);
  const Vec2 mixed = side + share * unit(own_direction);
  return mixed.dot(side) > 0.25 ? mixed : side;
}

bool enters(const CrowdState& crowd, std::size_t i, const VehicleState& vehicle) {
  const Vec2 step = unit(crowd.decisions[i].direction);
  const double margin = crowd.persons.radius[i] + kBorder;
  for (double ahead = kLookStep; ahead <= kLookAhead; ahead += kLookStep) {
    if (place_in_claim(vehicle, crowd.position(i) + step * ahead, margin)) return true;
  }
  return false;
}

/// Calls what(person) for everybody, in parallel, where there are claims.
template <class What>
void for_each_claimed(const CrowdState& crowd, const What& what) {
  if (crowd.claimants.empty()) return;
  for_each_block(crowd.persons.walking, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) what(i);
  });
}

}  // namespace

bool far_from(const VehicleState& vehicle, const Vec2& point) {
  const double reach = vehicle.claim + vehicle.length + vehicle.width;
  return (point - vehicle.centre).squaredNorm() > reach * reach;
}

double room_beside_claims(const CrowdState& crowd, std::size_t i) {
  return crowd.persons.radius[i] + kBeside;
}

bool can_leave_claim(const CrowdState& crowd, std::size_t i, const VehicleState& vehicle) {
  if (vehicle.claim <= 0.0) return false;
  const auto place = place_in_claim(vehicle, crowd.position(i), room_beside_claims(crowd, i));
  return place && wide_side(crowd, i, vehicle, *place) != 0.0;
}

void order_claims(const CrowdState& crowd, std::vector<std::uint32_t>& claimants) {
  claimants.clear();
  for (std::uint32_t v = 0; v < crowd.vehicles.size(); ++v) {
    if (crowd.vehicles[v].claim > 0.0) claimants.push_back(v);
  }
  std::ranges::sort(claimants, [&](std::uint32_t a, std::uint32_t b) {
    const VehicleState &one = crowd.vehicles[a], &other = crowd.vehicles[b];
    if (one.claimed != other.claimed) return one.claimed > other.claimed;
    return one.key != other.key ? one.key < other.key : a < b;  // parts of one
  });
}

void propose_ways_out_of_claims(const CrowdState& crowd, Proposals& proposals) {
  for_each_claimed(crowd, [&](std::size_t i) {
    if (crowd.walkers[i].arrived || crowd.is_over(i)) return;
    visit_claims(crowd, i, [&](const VehicleState& vehicle, const auto& place) {
      if (!place) return;
      Wish wish = proposals.best(i);
      wish.direction = angle_of(way_out(crowd, i, vehicle, *place, wish.direction));
      wish.by = Behaviour::kClaim;
      proposals.propose(i, wish);
    });
  });
}

void restrain_beside_claims(const CrowdState& crowd, Restraints& restraints) {
  for_each_claimed(crowd, [&](std::size_t i) {
    visit_claims(crowd, i, [&](const VehicleState& vehicle, const auto& place) {
      if (!place && enters(crowd, i, vehicle)) restraints.wait(i);
    });
  });
}

}  // namespace pedzone
