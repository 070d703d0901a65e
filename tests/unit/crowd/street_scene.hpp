// A street of 200 m and 7 m along x, footways of 2 m on both sides, joined at its western end.
#pragma once

#include "scene.hpp"

namespace pedzone::test {

inline Zone street_zone() {
  Region ground = unite(repair(box(0.0, -5.5, 200.0, -3.5)), repair(box(0.0, 3.5, 200.0, 5.5)));
  Zone zone = zone_of(unite(ground, repair(box(-4.0, -5.5, 0.1, 5.5))));
  Street street;
  street.id = "street";
  street.axis = {{0.0, 0.0}, {200.0, 0.0}};
  street.length = 200.0;
  street.low = -3.5;
  street.high = 3.5;
  street.lanes = {{0, -3.5, 0.0, 1}, {1, 0.0, 3.5, -1}};
  street.places.assign(201, {-3.5, 3.5, true, false});
  zone.streets = {street};
  zone.street_walls = WallIndex(unite(zone.walkable, crossable_ground(zone.streets)));
  return zone;
}

/// A car that comes eastward on the near lane (or westward on the far one), its front `away` [m]
/// before x.
inline VehicleState car_before(double x, double away, double speed, bool near = true) {
  const double side = near ? 1.0 : -1.0;
  VehicleState car = vehicle_at({x - side * (away + 2.5), near ? -1.75 : 1.75}, near ? 0.0 : kPi,
                                speed);
  car.key = static_cast<std::uint64_t>(1000.0 + away);
  return car;
}

}  // namespace pedzone::test
