// Base of walking models that decide from lists of what a person is aware of. A model is one
// function, from Perceived to Decision; sight, hearing, attention, order of persons and threads
// are seen to here. Whom people leave no room decides once more, as narrow as with its shoulders
// turned, among people who have turned theirs.
#pragma once

#include <limits>
#include <vector>

#include "model/perceived.hpp"
#include "model/scenery.hpp"
#include "model/walking_model.hpp"

namespace pedzone {

class PerceivingModel : public WalkingModel {
 public:
  /// `reach` [m]: who is farther away is not listed, to save time; nobody sees farther than
  /// `sight`.
  explicit PerceivingModel(double reach = std::numeric_limits<double>::infinity())
      : reach_(reach) {}

  void prepare(const Snapshot& snapshot) final;
  void decide(std::size_t first, std::size_t last, std::span<Decision> decisions) const final;

 protected:
  /// The decision of one person. Called from many threads at once. The speed is cut at the
  /// preferred one, as every decision's.
  virtual Decision decide_from(const Perceived& who) const = 0;

  /// The decision to walk with that velocity [m/s]; to face the goal where it is zero.
  static Decision walk_with(const Vec2& velocity, const Perceived& who);

 private:
  void perceive(std::size_t person, Perceived& who) const;
  bool is_hindered(const Decision& decision, const Perceived& who) const;
  /// Lists them as they are now, or as they are with their shoulders turned.
  void see_persons(std::size_t person, bool turned, const Walker& walker, const Senses& senses,
                   Perceived& who) const;
  void see_walls(const Walker& walker, Perceived& who) const;
  void notice_vehicles(std::size_t person, const Walker& walker, const Senses& senses,
                       Perceived& who) const;

  double reach_;
  Snapshot snapshot_;
  Scenery scenery_;
};

}  // namespace pedzone
