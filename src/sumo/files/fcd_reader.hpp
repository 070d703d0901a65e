// SUMO's floating-car data (fcd-output) as the steps that conflicts are measured on.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "conflict/tracker.hpp"
#include "core/xml_stream.hpp"
#include "sumo/files/body_sizes.hpp"
#include "sumo/files/front_trail.hpp"

namespace pedzone {

class FcdReader {
 public:
  /// `as_persons`: vehicle types that count as persons. Both must outlive the reader.
  FcdReader(const BodySizes& sizes, const std::unordered_set<std::string>& as_persons)
      : sizes_(sizes), as_persons_(as_persons) {}

  using StepVisitor = std::function<void(double time, std::span<const PersonSample>,
                                         std::span<const VehicleSample>)>;

  /// Visits the time steps of a file, gzipped or not. Speeds are the file's; directions are those
  /// of the way gone in the last few centimetres, since angles are where bodies face. A person who
  /// is exactly where a vehicle is rides in it: so SUMO writes it. Throws InputError where the file
  /// is missing, not fcd-output or broken off, has places in degrees (fcd-output.geo), and where a
  /// vehicle's type is not known.
  void read(const std::string& file, const StepVisitor& visitor, const ReadProgress& progress);

  /// Type of a vehicle that is being visited.
  const std::string& type_of(std::string_view vehicle) const {
    return vehicles_.at(std::string(vehicle)).type;
  }

 private:
  /// One who moves, from step to step.
  struct Mover {
    std::uint64_t seen = 0;    ///< number of the step
    Vec2 at = Vec2::Zero();    ///< [m] centre of the body
    Vec2 way = Vec2::UnitX();  ///< [m] the latest way, what is longer ago counting less
    BodySize size{0.0, 0.0};   ///< [m] length 0: not known yet
    std::string type;          ///< of a vehicle
    VehicleParts parts;        ///< of a vehicle
    FrontTrail trail;          ///< of a vehicle that bends
    std::string edge;          ///< of a person; empty where the file has none
  };
  struct Row {
    const std::string* id;
    const Mover* mover;
    const std::string* edge;
    Vec2 reference;         ///< [m] as in the file
    double angle, speed;    ///< [deg], [m/s] as in the file
    double heading;         ///< [rad]
    Vec2 centre, velocity;  ///< [m], [m/s]
    BodySize size;
  };
  using Movers = std::unordered_map<std::string, Mover>;

  void begin_step(const XmlElement& element, const StepVisitor& visitor);
  void end_step(const StepVisitor& visitor);
  void follow_front(const Row& row, Mover& mover) const;
  void add_samples(const Row& vehicle);
  void add(const XmlElement& element, bool person);
  Row row_of(const XmlElement& element, bool person, Movers::value_type& mover);

  const BodySizes& sizes_;
  const std::unordered_set<std::string>& as_persons_;
  std::string file_;
  double told_way_ = 0.0, gone_way_ = 0.0;  ///< [m] of people: by their speeds, by their places
  bool in_step_ = false;
  double time_ = 0.0, before_ = 0.0;  ///< [s] of this step and the one before
  std::uint64_t step_ = 0;
  Movers persons_, vehicles_;
  std::vector<Row> person_rows_, vehicle_rows_;
  std::vector<PersonSample> person_samples_;
  std::vector<VehicleSample> vehicle_samples_;
};

}  // namespace pedzone
