#include "results/geojson_file.hpp"

#include <cmath>
#include <utility>

namespace pedzone {
namespace {

constexpr double kSteps = 1e8;  // [1/°] numerical: a step is 1 mm

}  // namespace

GeoJsonFile::GeoJsonFile(const std::string& path, const std::string& option, const GeoFrame& frame)
    : file_(path, option), frame_(frame) {
  file_.write(R"({"type":"FeatureCollection","features":[)");
}

Json GeoJsonFile::position(const Vec2& at) const {
  const Vec2 place = frame_.lon_lat(at);
  return {std::round(place.x() * kSteps) / kSteps, std::round(place.y() * kSteps) / kSteps};
}

Json GeoJsonFile::positions(const Polyline& points) const {
  Json all = Json::array();
  for (const Vec2& point : points) all.push_back(position(point));
  return all;
}

/// A ring ends where it begins.
Json GeoJsonFile::closed(const Ring& ring) const {
  Json all = positions(ring);
  all.push_back(all.front());
  return all;
}

void GeoJsonFile::feature(const char* type, const Json& coordinates, const Json& properties) {
  const Json feature = {{"type", "Feature"},
                        {"geometry", {{"type", type}, {"coordinates", coordinates}}},
                        {"properties", properties}};
  file_.write(std::exchange(empty_, false) ? "\n" : ",\n");
  file_.write(feature.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void GeoJsonFile::point(const Vec2& at, const Json& properties) {
  feature("Point", position(at), properties);
}

void GeoJsonFile::line(const Polyline& line, const Json& properties) {
  feature("LineString", positions(line), properties);
}

void GeoJsonFile::region(const Region& region, const Json& properties) {
  Json polygons = Json::array();
  for (const Polygon& polygon : region) {
    Json rings = Json::array({closed(polygon.outer)});  // counter-clockwise; holes clockwise
    for (const Ring& hole : polygon.holes) rings.push_back(closed(hole));
    polygons.push_back(std::move(rings));
  }
  feature("MultiPolygon", polygons, properties);
}

void GeoJsonFile::finish() {
  file_.write("\n]}\n");
  file_.finish();
}

}  // namespace pedzone
