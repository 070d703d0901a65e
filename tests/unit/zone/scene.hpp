// Small networks made by hand, for tests of zones.
#pragma once

#include <string>
#include <vector>

#include "zone/zone.hpp"

namespace pedzone::test {

/// A street of one lane.
struct Street {
  std::string id;
  Polyline shape;  ///< [m]
  std::string type = "highway.pedestrian";
  std::string from = "", to = "";    ///< junctions; by default of its own
  double width = 2.0, speed = 2.78;  ///< [m], [m/s]
  bool persons = true, vehicles = false, by_default = false;
  std::vector<double> z = {};
};

class Scene {
 public:
  Scene& add(const Street& street);
  /// An ordinary road: for vehicles only, 50 km/h.
  Scene& add_road(const std::string& id, const Polyline& shape, double width = 6.0);
  Scene& add_polygon(const std::string& id, const std::string& type, const Ring& shape);
  Scene& add_building(const std::string& id, const Ring& shape);

  const Network& network() const { return network_; }
  /// The only zone of these specs, or the one found by the rule.
  Zone zone(const std::vector<ZoneSpec>& specs = {}) const;
  int edge(const std::string& id) const { return network_.edge_index.at(id); }
  int lane(const std::string& id) const { return network_.lane_index.at(id); }

 private:
  Network network_;
};

/// Corners of an axis-parallel rectangle.
Ring rectangle(double left, double bottom, double right, double top);

/// A spec with openSpace off, so that an area is what lanes and polygons make.
ZoneSpec closed_spec();

/// What `build_zones` complains about; empty when it does not.
std::string complaint(const Network& network, const std::vector<ZoneSpec>& specs);

/// Ids of a zone's edges, sorted.
std::vector<std::string> edge_ids(const Network& network, const Zone& zone);

/// Ids of a zone's lanes, sorted.
std::vector<std::string> lane_ids(const Network& network, const Zone& zone);

/// A file of the folder of test data.
std::string data_file(const std::string& name);

/// A file of the project's networks/.
std::string network_file(const std::string& name);

}  // namespace pedzone::test
