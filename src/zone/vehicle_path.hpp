// Scripted vehicles: <vehiclePath vehicle="av" file="path.csv"/> of a zone file, where a vehicle of
// the scenario is at which time.
#pragma once

#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/vec.hpp"

namespace pedzone {

class XmlFile;

/// Where the middle of a vehicle's front bumper (SUMO's reference point) is: straight and at a
/// constant speed from each row to the next.
class VehiclePath {
 public:
  /// [s] [0, 1e9], [m].
  struct Row {
    double time;
    Vec2 front;
  };

  /// At least two rows with increasing times, not all at one place.
  VehiclePath(std::string vehicle, std::vector<Row> rows);

  const std::string& vehicle() const { return vehicle_; }  ///< id
  double begin() const { return rows_.front().time; }      ///< [s]
  double end() const { return rows_.back().time; }         ///< [s]

  /// [m] before and after the path: its first and last place.
  Vec2 front(double time) const;
  /// [rad] of a vehicle of `length` [m] > 0, which drives forwards. Its rear bumper follows the
  /// same path (before the first row: straight), so that it turns smoothly at the path's corners.
  double heading(double time, double length) const;
  /// [m] the part from `behind` [m] >= 0 before the front to `ahead` [m] >= 0 after it, no farther
  /// than the last row.
  Polyline way(double time, double behind, double ahead) const;

  /// What is wrong with its vehicle.
  InputError error(const std::string& problem, const std::string& allowed) const;

  /// Where it stands, for messages.
  std::string file;
  int line = 0;

 private:
  double gone(double time) const;  ///< [m] along the path since the first row
  Vec2 place(double gone) const;   ///< negative: straight before the first row

  std::string vehicle_;
  std::vector<Row> rows_;
  std::vector<double> gone_;  ///< [m] at each row
};

/// One <vehiclePath> of a zone file.
struct VehiclePathSpec {
  std::string vehicle;    ///< id
  std::string file;       ///< CSV, as named from here: a relative name is relative to the zone file
  std::string given;      ///< the same as the zone file names it
  std::string zone_file;  ///< where it stands, for messages
  int line = 0;           ///< there
};

/// The <vehiclePath>s of a zone file, without their CSV files. Throws InputError, also for a
/// vehicle with two paths.
std::vector<VehiclePathSpec> read_vehicle_path_specs(const XmlFile& zone_file);

/// Reads their CSV files: header t,x,y, then a row for each time. Throws InputError.
std::vector<VehiclePath> read_vehicle_paths(const std::vector<VehiclePathSpec>& specs);

}  // namespace pedzone
