#include "app/command_line/values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/xml.hpp"
#include "world/model_names.hpp"

namespace pedzone {
namespace {

constexpr const char* kChoices = "choices";  // the name by which choices_of() finds a validator

std::string complaint(const std::string& problem, const std::string& value,
                      const std::string& allowed) {
  return InputError(problem, {.value = value, .allowed = allowed}).what();
}

CLI::Validator checked_number(const NumberRange& range, bool whole) {
  const std::string allowed = describe(range);
  const auto check = [=](const std::string& text) -> std::string {
    double number = 0.0;
    if (!parse_number(text, number)) return complaint("is not a number", text, allowed);
    if (whole && number != std::floor(number)) {
      return complaint("is no whole number", text, allowed);
    }
    const bool inside = number >= range.least && number <= range.most;
    return inside ? "" : complaint("is out of range", text, allowed);
  };
  return {check, allowed};
}

}  // namespace

CLI::Validator number_in(double least, double most) { return checked_number({least, most}, false); }

CLI::Validator whole_number_in(std::int64_t least, std::int64_t most) {
  return checked_number({static_cast<double>(least), static_cast<double>(most)}, true);
}

CLI::Validator a_seed() { return whole_number_in(0, std::numeric_limits<std::int32_t>::max()); }

CLI::Validator one_of(const std::vector<std::string>& names) {
  const auto check = [names](const std::string& text) -> std::string {
    if (std::ranges::find(names, text) != names.end()) return "";
    return complaint("is unknown", text, comma_list(names));
  };
  return {check, comma_list(names), kChoices};
}

CLI::Validator any_beside(const std::vector<std::string>& names) {
  return {[](const std::string&) { return std::string(); }, comma_list(names), kChoices};
}

std::vector<std::string> model_names() { return {std::begin(kModelNames), std::end(kModelNames)}; }

std::vector<std::string> choices_of(CLI::Option& option) {
  try {
    return split_words(option.get_validator(kChoices)->get_description(), ',');
  } catch (const CLI::OptionNotFound&) {
    return {};
  }
}

}  // namespace pedzone
