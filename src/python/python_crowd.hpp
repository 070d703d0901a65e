// A crowd as Python holds it.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <vector>

#include "crowd/crowd.hpp"
#include "python/python_vehicle.hpp"
#include "python/python_zone.hpp"

namespace pedzone {

/// Columns of a crowd that arrays of Python show. An array is what it was when it was asked for,
/// and stays so: before the crowd changes, arrays that somebody still holds keep its storage, and
/// it goes on in a copy. Whoever lets go of them before the next step pays for no copy at all.
class PythonCrowd {
 public:
  PythonCrowd(SharedZone zone, std::uint64_t seed, std::unique_ptr<WalkingModel> model);
  ~PythonCrowd();
  PythonCrowd(const PythonCrowd&) = delete;
  PythonCrowd& operator=(const PythonCrowd&) = delete;

  /// Its `profile` is found by its name; empty: none. Throws InputError where it is unknown.
  Crowd::Handle add(NewPerson person, const std::string& profile);
  /// Without the interpreter's lock while people walk.
  void step(double dt, const std::vector<PythonVehicle>& vehicles);

  /// To be read, or to be changed. Both throw std::runtime_error while another thread, or the model
  /// that it asks, steps the crowd, and after a step that a model's error has ended.
  const Crowd& read() const;
  Crowd& change();

  /// A column without a copy, of shape (n); not to be written to.
  template <class Value>
  pybind11::array_t<Value> show(std::vector<Value> Persons::*column) const {
    const std::vector<Value>& values = read().persons().*column;
    pybind11::array_t<Value> array(static_cast<pybind11::ssize_t>(read().size()), values.data(),
                                   owner());
    array.attr("setflags")(pybind11::arg("write") = false);
    return array;
  }

  /// Of a person without an id.
  std::uint64_t next_key();

 private:
  /// What arrays hold on to. The columns are here once the crowd has gone on.
  struct Shown {
    Persons persons;
  };

  pybind11::capsule owner() const;
  void leave_to_arrays();
  void check_idle() const;

  SharedZone zone_;
  Crowd crowd_;
  std::shared_ptr<Shown> shown_ = std::make_shared<Shown>();
  std::uint64_t unnamed_ = 0;  ///< persons without an id so far
  bool stepping_ = false, broken_ = false;
};

}  // namespace pedzone
