// Vehicles that bend: a tram, a bus with a bellows, a lorry with a trailer.
#pragma once

#include <optional>
#include <string_view>

namespace pedzone {

/// Of what parts a vehicle is made, one behind the other. They bend where they meet, and nobody
/// gets through between them.
struct VehicleParts {
  double first = 0.0;  ///< [m] ≥ 0 length of the first; 0: the vehicle does not bend
  int others = 0;      ///< behind it, all of one length

  bool bends() const { return others > 0; }
  int count() const { return 1 + others; }
};

/// Where one part is along its vehicle.
struct VehiclePart {
  double rear;    ///< [m] ≥ 0 from the vehicle's rear to the part's
  double length;  ///< [m] > 0
};

/// Part `k` of a vehicle of `length` [m]; 0: the first.
VehiclePart part_of(const VehicleParts& parts, double length, int k);

/// [m] of the longest part.
double longest_part(const VehicleParts& parts, double length);

/// What a type says of its parts, in SUMO's words; unset: as SUMO's shape has it.
struct CarriageLengths {
  std::optional<double> locomotive, carriage, gap;  ///< [m]
};

/// The parts that sumo-gui draws of a vehicle of `length` [m] with that guiShape ("rail/railcar",
/// "bus/flexible" ...) and vClass, without the gaps between them. Numbers and lengths are those of
/// SUMO's MSTrainHelper and SUMOVTypeParameter (1.15 to 1.20).
VehicleParts parts_of(std::string_view shape, std::string_view vclass, double length,
                      const CarriageLengths& own);

/// SUMO's guiShape of a vClass whose type names none, where that bends; else empty.
std::string_view bending_shape_of(std::string_view vclass);

}  // namespace pedzone
