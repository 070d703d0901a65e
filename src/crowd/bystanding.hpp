// People who stand while others pass: they turn, and step back for who cannot get by.
#pragma once

#include <cstdint>

#include "core/vec.hpp"

namespace pedzone {

struct CrowdState;

/// What a crowd remembers of somebody it only sees. SUMO says where such a person stands and does
/// not let it be moved, so the crowd has its own place for it: SUMO's and what it has stepped back.
struct Bystanding {
  std::uint64_t key = 0;         ///< of its id; 0: nothing is remembered
  Vec2 stepped = Vec2::Zero();   ///< [m] own place less SUMO's, at most kStepBack long
  Vec2 foreseen = Vec2::Zero();  ///< [m] where SUMO's place is if the person goes on as it did
  double still = 0.0;            ///< [s] for which it has stood
  double turn = 1.0;             ///< of its shoulders: 0: straight, 1: as narrow as it can be, as
                                 ///< who walks always is: it does not give way to anybody
};

/// Who has come, gone or been put elsewhere since the crowd last looked: crowd.seen becomes sorted
/// by key and crowd.bystanding as long, in its order.
void recognise_seen(CrowdState& crowd);

/// After the moves are set: who stands, but for those whom others hold up, and so may make a step.
void notice_standing(CrowdState& crowd, double dt);

/// Once it is known who is near whom: who stands turns while others pass, and steps back for who is
/// held up, by its move.
void make_room(CrowdState& crowd, double dt);

/// After all have moved: how long the seen have stood, and where SUMO's next place will be.
void remember_seen(CrowdState& crowd, double dt);

/// [m] Where the seen person k is for the crowd.
Vec2 own_place(const CrowdState& crowd, std::size_t k);

}  // namespace pedzone
