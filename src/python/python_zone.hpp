// A zone as Python holds it.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "world/profiles.hpp"
#include "zone/zone.hpp"

namespace pedzone {

/// With the profiles that its people may have.
struct PythonZone {
  Zone zone;
  std::shared_ptr<const Profiles> profiles;
};
using SharedZone = std::shared_ptr<PythonZone>;

/// The zones of a scenario (.sumocfg) or network (.net.xml, .net.xml.gz), as `pedzone run` makes
/// them. `zone_file`: empty: none. Throws InputError.
std::vector<SharedZone> read_zones(const std::string& scenario, const std::string& zone_file);

/// What is asked for beside its ground.
struct ZoneWishes {
  std::string id, model;
  std::map<std::string, double> parameters;
};

/// A zone of plain polygons without a network: `outer` less `holes`, all the rest being walls that
/// nobody sees through. Throws InputError.
SharedZone zone_of_polygons(const Ring& outer, const std::vector<Ring>& holes,
                            const ZoneWishes& wishes);

}  // namespace pedzone
