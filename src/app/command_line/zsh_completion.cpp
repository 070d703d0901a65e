#include <fmt/format.h>

#include <algorithm>

#include "app/command_line/completion.hpp"
#include "app/command_line/option_text.hpp"
#include "app/command_line/values.hpp"

namespace pedzone {
namespace {

/// Inside single quotes of a specification of _arguments, where some characters part its fields.
std::string quoted(std::string_view text, std::string_view parting) {
  std::string out;
  for (const char letter : text) {
    if (letter == '\'') {
      out += "'\\''";
      continue;
    }
    if (parting.find(letter) != std::string_view::npos) out += '\\';
    out += letter;
  }
  return out;
}

/// "_pedzone_study_run".
std::string function_of(const CLI::App& command) {
  std::string name = "_" + command_name(command);
  std::ranges::replace(name, ' ', '_');
  return name;
}

std::string action_of(CLI::Option& option) {
  const std::vector<std::string> choices = choices_of(option);
  if (!choices.empty()) return fmt::format("({})", fmt::join(choices, " "));
  if (value_name(option) == kFolder) return "_files -/";
  return !option.nonpositional() || value_name(option) == kFile ? "_files" : " ";
}

std::string spec_of(CLI::Option& option, int& place) {
  const OptionText text = text_of(option);
  const bool many = text.value.ends_with("...");
  std::string value;
  if (!text.value.empty()) {
    value = fmt::format(":{}:{}", quoted(value_name(option), ":"), action_of(option));
  }
  if (text.names.empty()) {
    return fmt::format(" \\\n    '{}{}'", many ? "*" : std::to_string(place++), value);
  }
  std::string specs;
  for (const std::string& name : text.names) {
    specs += fmt::format(" \\\n    '{}{}[{}]{}'", many ? "*" : "", name, quoted(text.meaning, "[]"),
                         value);
  }
  return specs;
}

std::string specs_of(CLI::App& command) {
  std::string specs;
  int place = 1;
  for (CLI::Option* option : command.get_options()) {
    if (!option->get_group().empty()) specs += spec_of(*option, place);
  }
  return specs;
}

/// The functions of a command and of those inside it.
std::string functions_of(CLI::App& command) {
  std::string text, inner, names;
  for (CLI::App* one : command.get_subcommands({})) {
    if (one->get_group().empty()) continue;
    inner += functions_of(*one);
    names += fmt::format("    '{}:{}'\n", one->get_name(), quoted(one->get_description(), ":"));
  }
  const std::string function = function_of(command), specs = specs_of(command);
  if (names.empty()) return fmt::format("{}() {{\n  _arguments{}\n}}\n", function, specs);
  return inner +
         fmt::format(
             "{0}() {{\n  local curcontext=$curcontext state line\n"
             "  local -a commands=(\n{1}  )\n"
             "  _arguments -C{2} \\\n    '1: :->command' \\\n    '*:: :->words'\n"
             "  case $state in\n    command) _describe command commands ;;\n"
             "    words) (( ! $+functions[{0}_$line[1]] )) || {0}_$line[1] ;;\n  esac\n}}\n",
             function, names, specs);
}

}  // namespace

std::string zsh_completion(CLI::App& app) {
  return "#compdef pedzone\n# made by `pedzone completion zsh`\n" + functions_of(app) +
         "_pedzone \"$@\"\n";
}

}  // namespace pedzone
