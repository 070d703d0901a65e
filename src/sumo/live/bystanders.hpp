// The persons in SUMO whom pedzone does not walk: who of them is near a zone, to be seen by the
// people there or to be taken over. Those far away are looked at again when they may have come
// near.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <unordered_set>
#include <vector>

#include "crowd/crowd.hpp"
#include "zone/zone_distance.hpp"

namespace pedzone {

struct Bystander {
  std::string id;
  bool guest = false;            ///< pedzone walks it
  bool near = false;             ///< within sight of a zone's walkable area
  double look_at = -1.0;         ///< [s] not looked at before
  double radius = 0.0;           ///< [m] 0: not known yet
  std::uint64_t key = 0;         ///< person_key(id), with the radius
  bool turns = true;             ///< its shoulders, with the radius
  double looked_at = -1.0;       ///< [s] when last looked at; < 0: not yet
  Vec2 position = Vec2::Zero();  ///< [m] then
  Vec2 velocity = Vec2::Zero();  ///< [m/s] since the time before that
  double heading = 0.0;          ///< [rad] in which it moved last
};

class Bystanders {
 public:
  explicit Bystanders(const std::vector<Zone>& zones);

  /// After a step of SUMO, at `time` [s]: takes in who is there, tells who has gone.
  void read(double time);

  /// Everybody in SUMO, in its order. `near` and `position` are of now for those who are near.
  std::vector<Bystander>& all() { return all_; }
  const std::vector<std::string>& gone() const { return gone_; }  ///< guests that SUMO lost
  void set_guest(const std::string& id, bool guest);

  /// Those near a zone, who walk or stand, within sight of one of `eyes` [m] at least: reading them
  /// all is dear, and most have nobody near.
  void seen_from(std::size_t zone, std::span<const Vec2> eyes, std::vector<SeenPerson>& out);

 private:
  void look(Bystander& person, double time) const;

  const std::vector<Zone>& zones_;
  std::vector<ZoneDistance> distances_;
  std::vector<Bystander> all_, before_;  ///< by ascending id
  std::vector<std::string> gone_;
  std::unordered_set<std::int64_t> eyed_;  ///< cells with eyes; kept for its memory
};

/// A person's body as a disc [m]: as large as its rectangle and never narrower than it is.
double body_radius(const std::string& id);

}  // namespace pedzone
