#include "zone/obstacles.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace pedzone {
namespace {

constexpr std::array<std::string_view, 3> kObstacleTypes{"building", "jupedsim.obstacle",
                                                         "pedzone.obstacle"};
constexpr std::array<std::string_view, 2> kWalkableTypes{"jupedsim.walkable_area",
                                                         "pedzone.walkable"};
constexpr std::array<std::string_view, 2> kWaterTypes{"water", "natural.water"};

// numerical: a ring whose signed area differs by more than this from its area by the even-odd
// rule crosses itself; below, it is rounding [m²].
constexpr double kAreaTolerance = 0.05;

bool is_any(std::string_view type, const auto& types) {
  return std::find(types.begin(), types.end(), type) != types.end();
}

bool crosses_itself(const Ring& ring, const Region& repaired) {
  return repaired.size() > 1 ||
         std::abs(std::abs(signed_area(ring)) - area(repaired)) > kAreaTolerance;
}

ShapedPolygon shaped(const MapPolygon& polygon, std::vector<std::string>& warnings) {
  ShapedPolygon result{polygon.id, repair(polygon.shape), {}};
  result.box = box_of(result.region);
  if (result.region.empty()) {
    warnings.push_back("polygon '" + polygon.id + "' has no area: left out");
  } else if (crosses_itself(polygon.shape, result.region)) {
    warnings.push_back("polygon '" + polygon.id + "' crosses itself: repaired");
  }
  return result;
}

void check_named(const Network& network, const ZoneSpec& spec) {
  for (const std::string& id : spec.polygons) {
    const auto found = std::find_if(network.polygons.begin(), network.polygons.end(),
                                    [&](const MapPolygon& polygon) { return polygon.id == id; });
    if (found == network.polygons.end()) {
      throw zone_error(spec, "is no polygon", "polygons", id,
                       "ids of polygons in the scenario's additional files");
    }
    const Region region = repair(found->shape);
    if (region.empty()) {
      throw zone_error(spec, "has no area", "polygons", id, "polygons of three points or more");
    }
    if (crosses_itself(found->shape, region)) {
      throw zone_error(spec, "crosses itself", "polygons", id,
                       "polygons whose border does not cross itself");
    }
  }
}

}  // namespace

bool is_walkable(const MapPolygon& polygon, const ZoneSpec& spec) {
  return is_any(polygon.id, spec.polygons) || is_any(polygon.type, kWalkableTypes);
}

ZonePolygons sort_polygons(const Network& network, const ZoneSpec& spec, const Box& near,
                           std::vector<std::string>& warnings) {
  check_named(network, spec);
  ZonePolygons sorted;
  Box reach = near;
  std::vector<std::string> unheard;  // a brook drawn as a line is no mistake
  const auto add = [&](const MapPolygon& polygon, std::vector<ShapedPolygon>& kind) {
    ShapedPolygon result = shaped(polygon, &kind == &sorted.water ? unheard : warnings);
    if (!result.region.empty()) kind.push_back(std::move(result));
  };
  for (const MapPolygon& polygon : network.polygons) {
    if (!is_walkable(polygon, spec)) continue;
    add(polygon, sorted.walkable);
    reach.extend(box_of(polygon.shape));
  }
  for (const MapPolygon& polygon : network.polygons) {
    if (is_walkable(polygon, spec) || !reach.intersects(box_of(polygon.shape))) continue;
    if (is_any(polygon.type, kObstacleTypes)) add(polygon, sorted.obstacles);
    if (is_any(polygon.type, kWaterTypes)) add(polygon, sorted.water);
  }
  return sorted;
}

}  // namespace pedzone
