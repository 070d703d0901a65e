// Who people are: named sets of numbers, each with its source. The README's table, the checks of
// the zone file and the people that pedzone makes come from this list.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pedzone {

/// A kind of person. Ranges and units stand in profile_fields().
struct Profile {
  std::string id;
  std::string meaning;  ///< e.g. "19 to 40 years"

  double speed, speed_deviation, top_speed;  ///< preferred speeds are normal; cut at the limits
  double length, width;                      ///< of the body, along and across its heading
  double turned_width;                       ///< with the shoulders turned, over the full width
  double reaction_time, field_of_view, hearing, awareness;
  double caution, impulsiveness, patience;
  double share;    ///< among people of whom nothing else is said
  double guarded;  ///< 1: never alone, walks with somebody who may be (a small child)
};

/// One number of a profile, for tables, checks and attributes of <profile>.
struct ProfileField {
  std::string_view key;  ///< as in the zone file
  double Profile::*member;
  double least, most;  ///< closed range, in `unit`
  std::string_view unit, meaning;
};

std::span<const ProfileField> profile_fields();

/// The profiles that a scenario can name: the built-in ones and the user's.
class Profiles {
 public:
  Profiles();  ///< the built-in ones

  /// Nullptr where none has that id.
  const Profile* find(std::string_view id) const;
  /// A new one. Its id is not known yet.
  void add(Profile profile) { all_.push_back(std::move(profile)); }
  std::span<const Profile> all() const { return all_; }
  std::string ids() const;  ///< "infant, child, ...", for messages

 private:
  std::vector<Profile> all_;
};

/// Where a number of a built-in profile comes from: paper, data, or "assumed".
std::string_view source_of(const Profile& profile, const ProfileField& field);

}  // namespace pedzone
