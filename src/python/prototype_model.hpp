// A walking model written in Python, for prototypes.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "model/walking_model.hpp"
#include "python/python_vehicle.hpp"

namespace pedzone {

/// What a model in Python derives from.
struct PythonModel {};

/// A snapshot as Python gets it: copies, so that it may keep them.
struct PythonSnapshot {
  std::size_t walking;  ///< those who decide have the first rows
  double step;          ///< [s]
  pybind11::object time;
  pybind11::array_t<double> x, y, vx, vy, heading, radius, preferred_speed, goal_direction,
      goal_distance;
  pybind11::array_t<std::uint64_t> key;
  std::vector<PythonVehicle> vehicles;
};

/// Asks the object in Python once a step for everybody: in prepare(), which one thread calls. So
/// the threads that share out decide() never wait for the interpreter's lock.
class PrototypeModel : public WalkingModel {
 public:
  /// `model`: an instance of a class that derives from PythonModel.
  explicit PrototypeModel(pybind11::object model);

  /// Without the interpreter's lock, which it takes. Throws what Python raises, and InputError for
  /// decisions outside of Decision's ranges.
  void prepare(const Snapshot& snapshot) override;
  void decide(std::size_t first, std::size_t last, std::span<Decision> decisions) const override;
  bool sets_velocity() const override { return sets_velocity_; }

 private:
  void take(const Snapshot& snapshot, const pybind11::tuple& answer);

  pybind11::object model_;
  std::string name_;  ///< of its class, for messages
  bool sets_velocity_;
  std::vector<Decision> decisions_;
};

}  // namespace pedzone
