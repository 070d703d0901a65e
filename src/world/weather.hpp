// What the weather does to people and vehicles.
#pragma once

#include <span>
#include <string_view>

namespace pedzone {

struct Weather {
  std::string_view id;   ///< as in the zone file
  double speed;          ///< factor of people's preferred speeds
  double field_of_view;  ///< factor
  double deceleration;   ///< factor of what vehicles are taken to brake with
  bool shade;            ///< people go through polygons of type pedzone.shade
  std::string_view meaning, source;
};

/// "fair", which changes nothing, first.
std::span<const Weather> weather_list();
/// Nullptr where none has that id.
const Weather* find_weather(std::string_view id);

}  // namespace pedzone
