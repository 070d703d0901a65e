// Children in a group with an adult.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Whether that is a child, who does not go about alone. Nobody without a profile is one.
bool goes_with_adult(const Profile* profile);

/// Finds each child's adult, takes its hand or lets it go in a substep of `dt` [s], and says
/// whether it is led: by the hand, or back to an adult that is too far away. A child is one whose
/// profile is guarded, or "child".
void guide_children(const CrowdState& crowd, double dt, ByHandle<ChildMemory>& children);

/// Children that are led go to their adult's side.
void propose_ways_to_adults(const CrowdState& crowd, Proposals& proposals);

/// Adults go no faster than their children.
void restrain_adults(const CrowdState& crowd, Restraints& restraints);

/// Once all that restrains people is applied: who is led by the hand goes where that leads.
void lead_by_hand(const CrowdState& crowd, std::vector<Decision>& decisions);

}  // namespace pedzone
