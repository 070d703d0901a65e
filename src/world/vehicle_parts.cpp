#include "world/vehicle_parts.hpp"

#include <algorithm>
#include <cmath>

namespace pedzone {
namespace {

constexpr double kUsualGap = 1.0;  // [m] SUMO's between carriages

struct Carriages {
  double locomotive = 0.0, carriage = 0.0, gap = kUsualGap;  ///< [m]
};

/// As SUMO has them for types that say nothing; carriages of 0 m: none.
Carriages usual_carriages(std::string_view shape, std::string_view vclass) {
  if (shape == "bus/flexible") return {8.25, 8.25, 0.0};
  if (shape == "truck/semitrailer") return {2.5, 13.5, 0.5};
  if (shape == "truck/trailer") return {9.25, 6.75, 0.5};
  if (shape == "rail/cargo") return {13.86, 13.86};
  if (shape == "rail/railcar") {
    if (vclass == "tram") return {5.71, 5.71};
    if (vclass == "rail_urban") return {18.4, 18.4};
    return {16.85, 16.85};
  }
  if (shape == "rail") {
    if (vclass == "rail_electric") return {19.1, 24.5};
    if (vclass == "rail_fast") return {25.835, 24.775};
    return {16.4, 24.5};
  }
  return {};
}

}  // namespace

VehiclePart part_of(const VehicleParts& parts, double length, int k) {
  if (!parts.bends()) return {0.0, length};
  if (k == 0) return {length - parts.first, parts.first};
  const double each = (length - parts.first) / parts.others;
  return {(parts.others - k) * each, each};
}

double longest_part(const VehicleParts& parts, double length) {
  return std::max(part_of(parts, length, 0).length, part_of(parts, length, parts.others).length);
}

VehicleParts parts_of(std::string_view shape, std::string_view vclass, double length,
                      const CarriageLengths& own) {
  Carriages usual = usual_carriages(shape, vclass);
  if (own.carriage) usual.locomotive = usual.carriage = *own.carriage;
  if (own.locomotive) usual.locomotive = *own.locomotive;
  if (own.gap) usual.gap = *own.gap;
  if (!(usual.carriage > 0.0) || !(usual.locomotive > 0.0)) return {};
  const double each = usual.carriage + std::max(0.0, usual.gap);
  const double others = std::round((length - usual.locomotive) / each);
  if (!(others >= 1.0)) return {};
  const double share = length / (usual.locomotive + others * usual.carriage);
  return {usual.locomotive * share, static_cast<int>(others)};
}

std::string_view bending_shape_of(std::string_view vclass) {
  if (vclass == "tram" || vclass == "rail_urban") return "rail/railcar";
  if (vclass == "rail" || vclass == "rail_electric" || vclass == "rail_fast") return "rail";
  return vclass == "trailer" ? "truck/trailer" : "";
}

}  // namespace pedzone
