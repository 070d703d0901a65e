// A network's places on Earth.
#pragma once

#include <memory>
#include <string>

#include "core/vec.hpp"

namespace pedzone {

/// Where a network lies on Earth.
struct GeoReference {
  std::string file;            ///< of the network, as the user named it
  std::string projection;      ///< a definition for PROJ; "!" or empty: none is known
  Vec2 offset = Vec2::Zero();  ///< [m] added to what the projection gives
};

/// Leads back through the network's projection, by PROJ, as SUMO's tools do.
class GeoFrame {
 public:
  /// Throws InputError for a network without a projection or with one that PROJ does not know.
  explicit GeoFrame(GeoReference geo);
  ~GeoFrame();

  /// Longitude and latitude [°] of a place [m] in the network, in the datum of the projection
  /// (WGS84 in what netconvert makes of OpenStreetMap's data). Throws InputError for a place off
  /// Earth.
  Vec2 lon_lat(const Vec2& place) const;

 private:
  struct Projection;
  GeoReference geo_;
  std::unique_ptr<Projection> projection_;
};

}  // namespace pedzone
