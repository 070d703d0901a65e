#include "app/box_option.hpp"

#include "app/command_line/values.hpp"
#include "core/error.hpp"

namespace pedzone {

CLI::Option* add_box_option(CLI::App& command, const std::string& name, std::vector<double>& sides,
                            const std::string& what) {
  return command.add_option(name, sides, what)
      ->expected(4)
      ->check(number_in(-1e9, 1e9))
      ->type_name("LEFT BOTTOM RIGHT TOP");
}

Box box_of_sides(const std::vector<double>& sides, const std::string& option) {
  if (sides.empty()) return {};
  const Box box(Vec2(sides[0], sides[1]), Vec2(sides[2], sides[3]));
  if (box.isEmpty() || !(box.sizes().minCoeff() > 0.0)) {
    throw InputError("is no area", {.element = "option " + option,
                                    .allowed = "LEFT BOTTOM RIGHT TOP with LEFT < RIGHT and "
                                               "BOTTOM < TOP, network metres"});
  }
  return box;
}

}  // namespace pedzone
