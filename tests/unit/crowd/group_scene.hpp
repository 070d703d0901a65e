// People of groups for the crowd's tests.
#pragma once

#include "core/random.hpp"
#include "scene.hpp"

namespace pedzone::test {

/// Somebody of that group (0: of none) who walks towards its destination.
inline NewPerson member(const Vec2& from, const Destination& to, std::uint64_t group) {
  NewPerson person;
  person.position = from;
  person.destination = to;
  person.group = group;
  person.heading = angle_of(0.5 * (to.a + to.b) - from);
  person.velocity = person.preferred_speed * unit(person.heading);
  return person;
}

/// A built-in profile.
inline const Profile* profile(std::string_view id) {
  static const Profiles profiles;
  return profiles.find(id);
}

}  // namespace pedzone::test
