#include "zone/network.hpp"

#include <algorithm>
#include <array>

namespace pedzone {
namespace {

// SUMO's classes of vehicles that share roads; the others are persons, rails, water and air
// (SUMO documentation, "Vehicle permissions / abstract vehicle classes").
constexpr std::array<std::string_view, kRoadClassCount> kRoadClasses{
    "private", "emergency", "authority", "army",     "vip",       "passenger", "hov",
    "taxi",    "bus",       "coach",     "delivery", "truck",     "trailer",   "motorcycle",
    "moped",   "bicycle",   "scooter",   "evehicle", "container", "custom1",   "custom2"};

}  // namespace

RoadClasses road_class(std::string_view name) {
  const auto found = std::ranges::find(kRoadClasses, name);
  if (found == kRoadClasses.end()) return 0;
  return RoadClasses{1} << (found - kRoadClasses.begin());
}

int walking_lane(const Network& network, int edge) {
  int shared = -1;
  for (const int index : network.edges[edge].lanes) {
    const Lane& lane = network.lanes[index];
    if (!lane.persons) continue;
    if (!lane.vehicles) return index;
    if (shared < 0) shared = index;
  }
  return shared;
}

bool is_too_short(const Network& network, int edge) {
  const int lane = walking_lane(network, edge);
  return lane < 0 || network.lanes[lane].length < kShortEdge;
}

}  // namespace pedzone
