// Children in a group with an adult.
#pragma once

#include <span>

#include "crowd/state.hpp"

namespace pedzone {

/// Whether a person of that profile is a child that goes with an adult: guarded, or "child".
/// Nobody without a profile is.
bool goes_with_adult(const Profile* profile);

/// Before the decisions of a substep of `dt` [s]: finds each child's adult, takes its hand or lets
/// it go, and sends the child that is too far from it to its side.
void guide_children(CrowdState& crowd, std::span<const GroupMember> group, double dt);

/// After the decisions: adults go no faster than their children, who go where the hand leads.
void lead_children(CrowdState& crowd, std::span<const GroupMember> group);

/// The person is nobody's child any more.
void let_go(WalkState& child);

}  // namespace pedzone
