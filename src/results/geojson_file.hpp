// GeoJSON (RFC 7946): features with a shape on Earth and properties, as QGIS and others read them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "geometry/polygon.hpp"
#include "geometry/polyline.hpp"
#include "results/complete_file.hpp"
#include "results/geo_frame.hpp"

namespace pedzone {

/// Properties or a shape; keeps the order in which members were named.
using Json = nlohmann::ordered_json;

/// A FeatureCollection. Places are given in the network [m].
class GeoJsonFile {
 public:
  /// `frame` must outlive it. Throws InputError as CompleteFile.
  GeoJsonFile(const std::string& path, const std::string& option, const GeoFrame& frame);

  void point(const Vec2& at, const Json& properties);
  void line(const Polyline& line, const Json& properties);
  void region(const Region& region, const Json& properties);
  void finish();

 private:
  Json position(const Vec2& at) const;
  Json positions(const Polyline& points) const;
  Json closed(const Ring& ring) const;
  void feature(const char* type, const Json& coordinates, const Json& properties);

  CompleteFile file_;
  const GeoFrame& frame_;
  bool empty_ = true;
};

}  // namespace pedzone
