// Where a network lies on Earth, as its file says.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "results/geo_frame.hpp"

namespace pedzone {

/// Reads the <location> of a .net.xml or .net.xml.gz. Throws InputError where the file is missing
/// or malformed.
GeoReference read_geo_reference(const std::string& net_file);

/// Places that the user gives by longitude and latitude. The network's file is read for the first
/// of them.
class GeoPlaces {
 public:
  explicit GeoPlaces(std::string net_file) : net_file_(std::move(net_file)) {}

  /// Where that [°] is in the network [m]; nothing where the network has no projection that PROJ
  /// knows, or that has no place for it.
  std::optional<Vec2> at(const Vec2& lon_lat);

 private:
  std::string net_file_;
  bool is_read_ = false;
  std::optional<GeoFrame> frame_;
};

}  // namespace pedzone
