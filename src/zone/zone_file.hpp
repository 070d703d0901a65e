// The optional zone file (XML, schema in src/zone/zones.xsd).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "world/parameters.hpp"
#include "world/profiles.hpp"
#include "world/weather.hpp"
#include "zone/panel.hpp"
#include "zone/paths.hpp"
#include "zone/vehicle_path.hpp"

namespace pedzone {

/// Where people cross the streets of a zone.
enum class CrossingRule {
  kNodes,     ///< at the junctions, as SUMO's persons do
  kAnywhere,  ///< between them, too
};

/// One <zone>. Every list is empty and every optional unset where the file says nothing.
struct ZoneSpec {
  std::string id = "shared-space";
  std::string file;  ///< where it stands, for messages; empty: by default
  int line = 0;
  std::vector<std::string> edges;       ///< ids
  std::vector<std::string> edge_types;  ///< e.g. highway.service
  std::vector<std::string> lanes;       ///< ids
  std::vector<std::string> polygons;    ///< ids of polygons that are walkable
  CrossingRule crossing = CrossingRule::kNodes;
  std::optional<double> open_space;  ///< [m] [0, 50]; unset: 12 on highway.pedestrian edges
  std::string model = "heuristic";
  const Weather* weather = &weather_list().front();
  Parameters parameters;  ///< defaults with the file's <param> applied
  /// Names no edges, edge types or lanes: its edges are found by the rule of selection.hpp.
  bool automatic() const { return edges.empty() && edge_types.empty() && lanes.empty(); }
};

/// What `openSpace` may be [m].
constexpr double kOpenSpaceLeast = 0.0, kOpenSpaceMost = 50.0;

/// The error for a zone of a zone file, or for one of its attributes.
InputError zone_error(const ZoneSpec& zone, const std::string& problem,
                      const std::string& attribute, const std::string& value,
                      const std::string& allowed);

/// All that a zone file says.
struct ZoneFile {
  std::vector<ZoneSpec> zones;    ///< empty: the zone is found by itself
  Profiles profiles;              ///< the built-in ones and those of the file
  std::vector<PathSpec> paths;    ///< ids are unique
  std::vector<PanelSpec> panels;  ///< people to be made
  std::vector<VehiclePathSpec> vehicle_paths;
};

/// Reads a zone file. Throws InputError naming file, line, element, value and what is allowed.
ZoneFile read_zone_file(const std::string& file);

}  // namespace pedzone
