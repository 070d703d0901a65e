// The persons in SUMO whom pedzone does not walk: who of them is near a zone, to be seen by the
// people there or to be taken over. Those far away are looked at again when they may have come
// near.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <unordered_set>
#include <vector>

#include "crowd/state/person.hpp"
#include "sumo/files/body_sizes.hpp"
#include "zone/zone_distance.hpp"

namespace pedzone {

struct Bystander {
  std::string id;
  bool guest = false;            ///< pedzone walks it
  bool external = false;         ///< another program moves it
  bool declared = false;         ///< and its parameter pedzone.external says so
  double ask_at = 0.0;           ///< [s] when it is looked at again whether it still does
  bool near = false;             ///< within sight of a zone's walkable area
  double look_at = -1.0;         ///< [s] not looked at before
  double radius = 0.0;           ///< [m] 0: not measured yet
  std::uint64_t key = 0;         ///< person_key(id), with the radius
  bool turns = true;             ///< its shoulders, with the radius
  double looked_at = -1.0;       ///< [s] when last looked at; < 0: not yet
  Vec2 position = Vec2::Zero();  ///< [m] then
  Vec2 velocity = Vec2::Zero();  ///< [m/s] since the time before that
  double heading = 0.0;          ///< [rad] in which it moved last
  std::string barred_edge;       ///< on which it was found that it stays SUMO's; empty: on none
  int barred_stages = 0;         ///< so many stages of its plan were left then
};

/// Once its length and width are known.
void measure(Bystander& person, const BodySize& size);

/// It as people see it. SUMO tells `speed` [m/s] and `heading` [rad]. Of whom another program moves
/// SUMO knows the speed along a lane at best: there the last two places count.
SeenPerson seen(const Bystander& person, double speed, double heading);

class Bystanders {
 public:
  explicit Bystanders(const std::vector<Zone>& zones);

  /// Takes in who is in SUMO after a step, and who has gone.
  void update(std::vector<std::string> ids);

  /// Whether a person has to be looked at, at `time` [s]: nobody who is walked by pedzone, nor who
  /// cannot have come near a zone since the last look.
  static bool is_due(const Bystander& person, double time) {
    return !person.guest && time >= person.look_at;
  }
  /// It is at `position` [m] now.
  void look(Bystander& person, double time, const Vec2& position) const;

  /// Everybody in SUMO, by ascending id. `near` and `position` are of now for those who are near.
  std::vector<Bystander>& all() { return all_; }
  const std::vector<Bystander>& gone() const { return gone_; }  ///< in the last update
  void set_guest(const std::string& id, bool guest);
  /// nullptr: it is not in SUMO.
  Bystander* find(const std::string& id);

  /// Those near a zone and within sight of one of `eyes` [m] at least, riders included: reading
  /// all of them is dear, and most have nobody near.
  void seen_from(std::size_t zone, std::span<const Vec2> eyes, std::vector<Bystander*>& out);

 private:
  const std::vector<Zone>& zones_;
  std::vector<ZoneDistance> distances_;
  std::vector<Bystander> all_, before_;  ///< by ascending id
  std::vector<Bystander> gone_;
  std::unordered_set<std::int64_t> eyed_;  ///< cells with eyes; kept for its memory
};

}  // namespace pedzone
