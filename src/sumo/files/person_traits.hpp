// What a scenario's own files say of persons for whoever looks at a run's outputs, which name only
// ids: profile and group.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

namespace pedzone {

/// Values of pedzone.profile and pedzone.group; empty: none, or not known.
struct PersonTraits {
  std::string profile, group;
};

class TraitReader {
 public:
  /// Takes in the types, persons and flows of a route or additional file, which may be large.
  /// Throws InputError.
  void read(const std::string& file);

  /// A person's own parameters (those of its flow) win over its type's. Of a type distribution the
  /// files do not tell which member a person has: nothing is known by it.
  PersonTraits of_person(std::string_view person) const;

 private:
  struct Person : PersonTraits {
    std::string type;
  };
  std::unordered_map<std::string, PersonTraits> types_;
  std::unordered_map<std::string, Person> persons_;  ///< persons and flows
};

}  // namespace pedzone
