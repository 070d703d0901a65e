// A network's places on Earth, by PROJ, as SUMO's tools find them.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/vec.hpp"

namespace pedzone {

/// Where a network lies on Earth.
struct GeoReference {
  std::string file;            ///< of the network, as the user named it
  std::string projection;      ///< a definition for PROJ; "!" or empty: none is known
  Vec2 offset = Vec2::Zero();  ///< [m] added to what the projection gives
};

/// Between a network's places and longitude and latitude, in the datum of its projection (WGS84 in
/// what netconvert makes of OpenStreetMap's data).
class GeoFrame {
 public:
  /// Throws InputError for a network without a projection or with one that PROJ does not know.
  explicit GeoFrame(GeoReference geo);
  ~GeoFrame();

  /// Longitude and latitude [°] of a place [m] in the network. Throws InputError for a place off
  /// Earth.
  Vec2 lon_lat(const Vec2& place) const;
  /// Place [m] in the network of a longitude and latitude [°]; nothing where the projection has
  /// none for them.
  std::optional<Vec2> place(const Vec2& lon_lat) const;

 private:
  struct Projection;
  GeoReference geo_;
  std::unique_ptr<Projection> projection_;
};

}  // namespace pedzone
