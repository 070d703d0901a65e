#include "sumo/files/said_options.hpp"

#include <algorithm>
#include <cstdlib>
#include <regex>
#include <string_view>

#include "sumo/files/truth.hpp"

namespace pedzone {
namespace {

bool is_name_of(const SumoOption& option, std::string_view name) {
  return std::find(option.names.begin(), option.names.end(), name) != option.names.end();
}

/// What an option's element says, in one of SUMO's three ways.
std::optional<std::string> said_by(const pugi::xml_node& node) {
  for (const char* name : {"value", "v"}) {
    if (const pugi::xml_attribute attribute = node.attribute(name)) return attribute.value();
  }
  const std::string text = node.child_value();
  return text.find_first_not_of(" \t\r\n") == std::string::npos ? std::nullopt
                                                                : std::optional(text);
}

/// With ${NAME} replaced by the variable of the environment, as SUMO does; empty: there is none.
std::string with_environment(const std::string& text) {
  static const std::regex variable(R"(\$\{(.+?)\})");
  std::string replaced;
  auto rest = text.cbegin();
  for (std::sregex_iterator at(text.begin(), text.end(), variable), none; at != none; ++at) {
    replaced.append(rest, (*at)[0].first);
    const char* const value = std::getenv((*at)[1].str().c_str());
    if (value != nullptr) replaced += value;
    rest = (*at)[0].second;
  }
  return replaced.append(rest, text.cend());
}

/// -5 is a value, -e an option.
bool begins_option(std::string_view word) {
  return word.size() > 1 && word.front() == '-' && (word[1] < '0' || word[1] > '9');
}

}  // namespace

std::optional<OptionWords> find_option_words(const std::vector<std::string>& words,
                                             const SumoOption& option) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string_view word = words[i];
    if (!begins_option(word)) continue;
    word.remove_prefix(word.starts_with("--") ? 2 : 1);
    const std::size_t equals = word.find('=');
    if (!is_name_of(option, word.substr(0, equals))) continue;
    if (equals != std::string_view::npos) {
      return OptionWords{std::string(word.substr(equals + 1)), i, 1};
    }
    const bool has_value = i + 1 < words.size() && !begins_option(words[i + 1]);
    return has_value ? OptionWords{words[i + 1], i, 2} : OptionWords{"true", i, 1};
  }
  return std::nullopt;
}

void set_option(std::vector<std::string>& words, const SumoOption& option,
                const std::string& value) {
  while (const auto given = find_option_words(words, option)) {
    const auto first = words.begin() + static_cast<std::ptrdiff_t>(given->first);
    words.erase(first, first + static_cast<std::ptrdiff_t>(given->count));
  }
  words.insert(words.end(), {"--" + option.names.front(), value});
}

/// Sections nest an option's element one level deep.
pugi::xml_node SaidOptions::in_configuration(const SumoOption& option) const {
  return config_.root().find_node([&](const pugi::xml_node& node) {
    return is_name_of(option, node.name()) && said_by(node).has_value();
  });
}

std::optional<std::string> SaidOptions::value(const SumoOption& option) const {
  if (const auto given = find_option_words(words_, option)) return given->value;
  const pugi::xml_node node = in_configuration(option);
  return node ? std::optional(with_environment(*said_by(node))) : std::nullopt;
}

bool SaidOptions::on_command_line(const SumoOption& option) const {
  return find_option_words(words_, option).has_value();
}

bool SaidOptions::is_true(const SumoOption& option) const {
  return pedzone::is_true(value(option).value_or(""));
}

InputError SaidOptions::error(const SumoOption& option, const std::string& problem,
                              const std::string& value, const std::string& allowed) const {
  if (!on_command_line(option)) {
    if (const pugi::xml_node node = in_configuration(option)) {
      return config_.error(problem, node, "value", value, allowed);
    }
  }
  return {problem, {"", 0, "SUMO option --" + option.names.front(), value, allowed}};
}

}  // namespace pedzone
