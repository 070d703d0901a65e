// What every walking model is: from a frozen snapshot, a direction and a speed for each person.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "world/snapshot.hpp"

namespace pedzone {

struct Decision {
  double direction = 0.0;      ///< [rad] chosen walking direction
  double speed = 0.0;          ///< [m/s] [0, preferred speed]; of the default model more in a hurry
  double free_distance = 0.0;  ///< [m] [0, sight] f(α) in the chosen direction
  bool waits = false;          ///< stands for a vehicle that is about to cross
  bool turns = false;          ///< its shoulders, for want of room among people
  bool escapes = false;        ///< from a vehicle that would reach it: whoever has arrived, too
};

/// How far one candidate direction is free.
struct Ray {
  double direction;      ///< [rad]
  double free_distance;  ///< [m] [0, sight] f(α)
};

/// How vehicles are minded: as in the paper (obstacles that move, and the waiting rule), or as more
/// than obstacles, by a discomfort that grows before contact (giving_way.hpp; none: as in the
/// paper) or by a model's own rule.
enum class VehicleForm { kPlain, kDiscomfort };

/// A walking model. prepare() is called once a step, then decide() for disjoint ranges from many
/// threads at once. A decision depends on the snapshot alone, never on the order of persons or
/// calls. Persons that stand at the same index in `decisions` and Persons.
class WalkingModel {
 public:
  virtual ~WalkingModel() = default;
  /// Builds what the decisions share (grids). Keeps a reference to the snapshot until the next
  /// call. No allocation once sizes have settled.
  virtual void prepare(const Snapshot& snapshot) = 0;
  /// Decides for persons [first, last) of those pedzone walks, into decisions[first .. last).
  virtual void decide(std::size_t first, std::size_t last, std::span<Decision> decisions) const = 0;
  /// Whether a decision is the velocity that the person has at once, its inertia included. Else the
  /// crowd lets velocities relax towards decisions (relaxationTime).
  virtual bool sets_velocity() const { return false; }
  /// How the model minds vehicles, which says how far people see them.
  virtual VehicleForm vehicle_form() const { return VehicleForm::kDiscomfort; }
  /// Whether its people look before they cross a street.
  virtual bool minds_vehicles() const { return true; }
  /// For pictures, and slow: the candidate directions of one person, once round. After prepare();
  /// none where the model does not compare directions.
  virtual void rays(std::size_t /*person*/, std::vector<Ray>& out) const { out.clear(); }
};

/// A model that cannot be had: its name, what is wrong with it (a clause), what is allowed.
struct ModelError : std::invalid_argument {
  ModelError(const std::string& model, const std::string& its_problem, const std::string& what_is)
      : invalid_argument("walking model \"" + model + "\" " + its_problem +
                         "; allowed: " + what_is),
        problem(its_problem),
        allowed(what_is) {}
  std::string problem, allowed;
};

/// The model of that name (world/model_names.hpp), which may be a plug-in's path (plugin.hpp).
/// Throws ModelError.
std::unique_ptr<WalkingModel> make_model(const std::string& name);

/// Throws ModelError where make_model() would. Makes no model but of a plug-in, whose constructor
/// may throw.
void check_model(const std::string& name);

}  // namespace pedzone
