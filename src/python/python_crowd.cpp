#include "python/python_crowd.hpp"

#include <stdexcept>
#include <utility>

#include "core/error.hpp"
#include "core/random.hpp"

namespace py = pybind11;

namespace pedzone {

PythonCrowd::PythonCrowd(SharedZone zone, std::uint64_t seed, std::unique_ptr<WalkingModel> model)
    : zone_(std::move(zone)), crowd_(zone_->zone, seed, std::move(model)) {}

PythonCrowd::~PythonCrowd() { leave_to_arrays(); }

Crowd::Handle PythonCrowd::add(NewPerson person, const std::string& profile) {
  if (!profile.empty()) {
    person.profile = zone_->profiles->find(profile);
    if (person.profile == nullptr) {
      throw InputError("is no profile",
                       {.element = "profile", .value = profile, .allowed = zone_->profiles->ids()});
    }
  }
  return change().add(person);
}

void PythonCrowd::step(double dt, const std::vector<PythonVehicle>& vehicles) {
  constexpr double kLongest =
      3600.0;  // [s] assumed: nobody means to walk people for longer at once
  if (!(dt > 0.0 && dt <= kLongest)) {
    throw std::invalid_argument("dt: " + std::to_string(dt) +
                                "; allowed: more than 0 s, at most 3600 s");
  }
  const std::vector<VehicleState> states = states_of(vehicles);
  Crowd& crowd = change();
  stepping_ = broken_ = true;
  try {
    const py::gil_scoped_release unlocked;
    crowd.step(dt, states);
  } catch (...) {
    stepping_ = false;
    throw;
  }
  stepping_ = broken_ = false;
}

std::uint64_t PythonCrowd::next_key() { return person_key("#" + std::to_string(++unnamed_)); }

const Crowd& PythonCrowd::read() const {
  check_idle();
  return crowd_;
}

Crowd& PythonCrowd::change() {
  check_idle();
  leave_to_arrays();
  return crowd_;
}

void PythonCrowd::check_idle() const {
  if (stepping_) throw std::runtime_error("the crowd is in a step: it cannot be asked now");
  if (broken_) {
    throw std::runtime_error("the crowd cannot be used: its walking model failed within a step");
  }
}

/// Counts of `shown_` change under the interpreter's lock only.
void PythonCrowd::leave_to_arrays() {
  if (shown_.use_count() == 1) return;
  shown_->persons = crowd_.give_away_persons();
  shown_ = std::make_shared<Shown>();
}

py::capsule PythonCrowd::owner() const {
  return py::capsule(new std::shared_ptr<Shown>(shown_),
                     [](void* held) { delete static_cast<std::shared_ptr<Shown>*>(held); });
}

}  // namespace pedzone
