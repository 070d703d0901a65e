// Who decides where somebody goes when behaviours disagree. This is the one place that says so.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "world/snapshot.hpp"

namespace pedzone {

/// What may send a person somewhere, the least important first: of several, the last one wins.
enum class Behaviour : std::uint8_t {
  kWay,    ///< along its route, by the user's waypoints if it has any: while nothing else matters
  kChild,  ///< a child to its adult, whose way leads to the same place in the end
  kGroup,  ///< towards the others it waits for, or out of the way of one of them who is behind:
           ///< on its route it would get farther ahead. No child that is led waits
  kSeat,   ///< to a seat: who wants to rest does so, and the others find it there
  kRound,  ///< round a vehicle that stands in its way. Bends the way that would win without it
  kDash,   ///< in front of a vehicle: an impulse minds nobody
  kClaim,  ///< out of the room that a held-up vehicle claims: until it is through, nobody else gets
           ///< on either. Bends the way that would win without it
  kCrossing,  ///< over the street: on the carriageway nothing else counts
};

/// Where a behaviour wants a person to go.
struct Wish {
  double direction = 0.0;  ///< [rad]
  double distance = 0.0;   ///< [m] ≥ 0
  Behaviour by = Behaviour::kWay;
};

/// Of each walked person, the most important wish of a substep so far. Each person has its own
/// place, so that several threads may propose for different persons.
class Proposals {
 public:
  void begin(std::size_t persons) { best_.assign(persons, {}); }

  /// Of two wishes by one behaviour, the later one holds.
  void propose(std::size_t person, const Wish& wish) {
    if (wish.by >= best_[person].by) best_[person] = wish;
  }
  /// Where the person goes as far as that is known.
  const Wish& best(std::size_t person) const { return best_[person]; }

  std::size_t size() const { return best_.size(); }

 private:
  std::vector<Wish> best_;
};

/// Towards a place that is `way` [m] away.
Wish towards(const Vec2& way, Behaviour by);

/// What won becomes each walked person's goal: all that the models are told of behaviours.
void resolve(const Proposals& proposals, Persons& persons);

}  // namespace pedzone
