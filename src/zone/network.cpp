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

bool has_carriageway(const Network& network, int edge) {
  return std::ranges::any_of(network.edges[edge].lanes,
                             [&](int lane) { return network.lanes[lane].vehicles_only(); });
}

bool is_street_end(const Network& network, const std::string& junction) {
  const auto found = network.junction_index.find(junction);
  return found != network.junction_index.end() && network.junctions[found->second].street_end;
}

bool is_rail_crossing(const Network& network, const std::string& junction) {
  const auto found = network.junction_index.find(junction);
  return found != network.junction_index.end() &&
         network.junctions[found->second].type == "rail_crossing";
}

bool is_too_short(const Network& network, int edge) {
  const int lane = walking_lane(network, edge);
  return lane < 0 || network.lanes[lane].length < kShortEdge;
}

}  // namespace pedzone
