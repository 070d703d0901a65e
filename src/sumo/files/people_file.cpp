#include "sumo/files/people_file.hpp"

#include "core/text.hpp"
#include "demand/route_file.hpp"

namespace pedzone {
namespace {

std::string comment_of(const PeopleFileInput& input, std::uint64_t seed) {
  std::string text = "Made by `pedzone demand` for " + input.scenario.config + ", seed " +
                     std::to_string(seed) + ", from";
  for (const PanelSpec& panel : input.panels) {
    text += "\n     <pedestrians";
    for (const auto& [attribute, value] : panel.text.values) {
      text += " " + attribute + "=\"" + xml_value(value) + "\"";
    }
    text += "/>";
  }
  return text;
}

}  // namespace

std::string people_file(const PeopleFileInput& input) {
  const ScenarioNumbers numbers = read_numbers(input.scenario);
  const std::uint64_t seed = input.seed.value_or(numbers.seed);
  const auto people =
      plan_people({input.network, input.zones, input.profiles, input.panels, seed, numbers.begin});
  // Striping takes a random share of up to `dawdling` off in every step.
  return route_file(people, input.network, comment_of(input, seed), 1.0 - 0.5 * numbers.dawdling);
}

}  // namespace pedzone
