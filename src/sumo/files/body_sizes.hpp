// How long and wide the bodies of a scenario are, from its own files: floating-car data names only
// vehicles' types.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/xml_stream.hpp"
#include "world/vehicle_parts.hpp"

namespace pedzone {

struct BodySize {
  double length, width;  ///< [m] > 0
};

/// A person's body as a disc [m]: as large as its rectangle and never narrower than it is.
double disc_radius(const BodySize& size);

class BodySizes {
 public:
  /// Knows SUMO's default types.
  BodySizes();

  /// Takes in the types, and persons' types, of a route or additional file, which may be large, or
  /// what SUMO tells of these in tripinfo or vehroute output. What a type leaves open is the
  /// default of its vClass. Throws InputError.
  void read(const std::string& file);
  /// The same of one element after the other; those of a file in its order.
  void visit(const XmlElement& element);

  /// Size of a type; nothing where it is not known. A type that a program has derived for one
  /// vehicle ("van@car7") is as large as what it comes from; a distribution as its first member.
  std::optional<BodySize> of_type(std::string_view type) const;
  /// The types that a vehicle of that type may have: itself, or a distribution's members.
  std::vector<std::string> members(std::string_view type) const;
  /// Where vehicles of a type of that length [m] bend; as a whole where it is not known.
  VehicleParts parts_of_type(std::string_view type, double length) const;
  /// SUMO's vClass of a type; passenger where it is not known.
  std::string_view class_of(std::string_view type) const;
  /// Size of a person: of its type where the files name one (also for those of a flow), else of
  /// SUMO's default type.
  BodySize of_person(std::string_view person) const;
  /// A distribution that people have for a type, whose members are not of one size, where nothing
  /// has told which of them a person got; empty: none.
  std::string guessed() const;

 private:
  struct Type {
    BodySize size;
    std::string vclass;
    std::string shape = {};  ///< guiShape; empty: none is named
    CarriageLengths carriages = {};
  };
  const Type* find(std::string_view type) const;
  void visit_parameter(const XmlElement& element);

  std::unordered_map<std::string, Type> types_;
  std::unordered_map<std::string, std::vector<std::string>> members_of_;  ///< distribution -> types
  std::map<std::string, std::string> persons_;  ///< person or flow -> type
  std::string distribution_;                    ///< that encloses what is visited
  int distribution_depth_ = -1;
  Type* visited_ = nullptr;  ///< the type that was visited last
  int visited_depth_ = -1;
};

}  // namespace pedzone
