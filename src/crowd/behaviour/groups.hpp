// Groups without a leader: whoever is too far ahead of the last one waits for it.
#pragma once

#include <span>

#include "crowd/state/state.hpp"

namespace pedzone {

/// Calls what(members) for each group in the order of their numbers. Members: a span of
/// GroupMember, const or not.
template <class Members, class What>
void for_each_group(Members& members, const What& what) {
  const std::span all(members);
  for (std::size_t first = 0, last = 0; first < all.size(); first = last) {
    while (last < all.size() && all[last].group == all[first].group) ++last;
    what(all.subspan(first, last - first));
  }
}

/// Who belongs together in this substep: all of groups that are still under way, by group and key.
/// Who has arrived waits for nobody, and is nobody's child any more.
void index_members(const CrowdState& crowd, std::vector<GroupMember>& members,
                   ByHandle<GroupMemory>& groups, ByHandle<ChildMemory>& children);

/// Who waits for the others of its group, after a substep of `dt` [s] more.
void update_waits(const CrowdState& crowd, double dt, ByHandle<GroupMemory>& groups);

/// Who waits goes towards the others, or makes room for the first (by key) who is behind it and
/// cannot get past; that one `steps_aside`. Reads where the others go: to be called after the
/// proposals of their routes and families.
void propose_room_in_groups(const CrowdState& crowd, std::vector<GroupMember>& members,
                            Proposals& proposals);

/// Who waits stands, turned to the others. Nobody waits in the way of a vehicle: there the model's
/// decision stands.
void restrain_by_groups(const CrowdState& crowd, Restraints& restraints);

}  // namespace pedzone
