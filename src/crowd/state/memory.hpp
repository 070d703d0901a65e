// What each behaviour remembers of a person, in tables of its own.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "crowd/state/person.hpp"

namespace pedzone {

/// A table of what one behaviour remembers, by the persons' handles: nothing is copied when others
/// leave the crowd.
template <class T>
class ByHandle {
 public:
  T& operator[](PersonHandle handle) { return rows_[handle]; }
  const T& operator[](PersonHandle handle) const { return rows_[handle]; }

  /// Nothing is remembered of the person that gets this handle.
  void begin(PersonHandle handle) {
    if (handle >= rows_.size()) rows_.resize(handle + std::size_t{1});
    rows_[handle] = T();
  }

 private:
  std::vector<T> rows_;
};

/// A vehicle that a person has perceived.
struct Noticed {
  std::uint64_t vehicle = 0;       ///< its key
  double since = 0.0, last = 0.0;  ///< [s] on the crowd's clock
  bool warned = false;             ///< it has sounded its horn
  bool minds = false;              ///< gives way to it at present
  bool near = false;               ///< so near that nobody stands and chats before it
};

/// Of the vehicles around (perception.cpp).
struct TrafficMemory {
  std::vector<Noticed> noticed;
  bool aware = true;  ///< of vehicles at all
};

/// Of what it does beside walking (activities.cpp, dash.cpp).
struct ActivityMemory {
  std::array<float, kActivities> rates{};  ///< [1/min] at which each begins
  Activity activity = Activity::kNone;
  std::int32_t seat = -1;  ///< index in Zone::seats of where it sits, or goes to; -1: where it is
  double dash = 0.0;       ///< [s] that it still runs in front of a vehicle
};

/// Of its group (groups.cpp).
struct GroupMemory {
  std::uint64_t group = 0;  ///< 0: alone
  double in_vain = 0.0;     ///< [s] waited for the others in vain; below 0: goes on
  double nearest = 0.0;     ///< [m] that the last one has come meanwhile
  bool waits = false;       ///< for the others
};

/// Of a child in a group with an adult (families.cpp).
struct ChildMemory {
  std::uint64_t adult = 0;  ///< key of the one that it goes with; 0: none
  double calm = 0.0;        ///< [s] since a vehicle drove near the child
  double awaited = 0.0;     ///< [s] since the adult began to wait for the child's hand
  double hand_side = 1.0;   ///< 1: at the adult's left hand, -1: at its right
  bool led = false;         ///< on its way to its adult, or by its hand
  bool holds_hand = false;  ///< of its adult
};

/// Of the crosswalk without priority that it comes to (kerbs.cpp).
struct KerbMemory {
  double waited = 0.0;                                    ///< [s] at the kerb
  double room = std::numeric_limits<double>::infinity();  ///< [m] until it waits
};

/// The user's waypoints of a person. While it has them, its route leads to the current one.
struct PathWalk {
  std::vector<Waypoint> waypoints;
  std::size_t next = 0;     ///< the one that the person is on the way to
  Destination destination;  ///< after the last

  const Waypoint& current() const { return waypoints[next]; }
};

/// Null: none, or all its waypoints are behind it (path_walk.cpp).
using PathMemory = std::unique_ptr<PathWalk>;

/// How far somebody is with a street that it may cross.
enum class CrossingPhase : std::uint8_t {
  kByNodes,  ///< goes by the junctions, and crosses before if a gap comes
  kToKerb,   ///< on the way to the kerb, or waits there
  kOver,     ///< on the carriageway
};

/// A street that a person may cross between the junctions (crossings.cpp).
struct StreetCrossing {
  std::uint32_t street = 0;  ///< index in Zone::streets
  int side = 1;              ///< 1: towards high t, -1: towards low t
  CrossingPhase phase = CrossingPhase::kByNodes;
  double at = 0.0;           ///< [m] s where it crosses at last: nearest to where it goes then
  Destination destination;   ///< beyond
  double beyond = 0.0;       ///< [m] way from the other side to there
  double detour = 0.0;       ///< [s] that the way by the junctions takes longer; infinity: none
  bool at_kerb = false;      ///< it has come to where it crosses at last
  double waited = 0.0;       ///< [s] for a gap
  bool turned_back = false;  ///< on the carriageway, in vain: goes by the junctions
  double hurry = 1.0;        ///< of its speed, while a vehicle comes
  double room = std::numeric_limits<double>::infinity();  ///< [m] to go before it lets one pass
  std::uint64_t next = 0;       ///< key of the vehicle that comes next; 0: none, or not looked yet
  double gap = 0.0;             ///< [s] until that came, when it became the next
  std::vector<float> rejected;  ///< [s] gaps that it has let pass
};

/// Of crossing streets, in zones with streets that may be crossed anywhere.
struct CrossingMemory {
  std::unique_ptr<StreetCrossing> now;  ///< null: it has no street to cross
  double by_junctions = kNoWay;         ///< [m] as NewPerson, when it was added
  bool stays_outside = false;           ///< would rather go by SUMO's junctions
};

/// Of not getting on among people (jams.cpp).
struct JamMemory {
  float least_left = std::numeric_limits<float>::infinity();  ///< [m] least way left so far
  float stuck = 0.0F;                                         ///< [s] without room since that was
  float faced = 0.0F;     ///< [s] added for what it stood face to face with others
  float squeezed = 0.0F;  ///< [s] since it began to squeeze; 0: it does not
  float free = 0.0F;      ///< [s] since it last lacked room

  bool squeezes() const { return squeezed > 0.0F; }
};

/// Of somebody whom the crowd only sees. SUMO says where such a person stands and does not let it
/// be moved, so the crowd has its own place for it: SUMO's and what it has stepped back.
struct SeenMemory {
  std::uint64_t key = 0;         ///< of its id; 0: nothing is remembered
  Vec2 stepped = Vec2::Zero();   ///< [m] own place less SUMO's, at most kStepBack long
  Vec2 foreseen = Vec2::Zero();  ///< [m] where SUMO's place is if the person goes on as it did
  double still = 0.0;            ///< [s] for which it has stood
  double turn = 1.0;             ///< of its shoulders: 0: straight, 1: as narrow as it can be, as
                                 ///< who walks always is: it does not give way to anybody
};

}  // namespace pedzone
