// How fast the persons of a type like to walk, from a scenario's own files: over TraCI SUMO tells
// a type's greatest speed only (measured: 10.4 m/s for pedestrians, with 1.15 and its default
// type).
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

namespace pedzone {

class DesiredSpeeds {
 public:
  /// Takes in the types of a route or additional file, which may be large. Throws InputError.
  void read(const std::string& file);

  /// [m/s] of a type, or of what a program has derived from it ("child@person7"), as SUMO has it
  /// where a type leaves it open; without a bound for types of vehicles.
  double of_type(std::string_view type) const;

 private:
  std::unordered_map<std::string, double> types_;
};

}  // namespace pedzone
