#include "app/command_line/option_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/text.hpp"

namespace pedzone {
namespace {

constexpr char kCheckMark = ':';  // CLI11 puts it between a type's name and what the checks allow

/// What the checks of an option's value allow; empty: anything.
std::string allowed_values(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t mark = type.find(kCheckMark);
  return mark == std::string::npos ? "" : type.substr(mark + 1);
}

std::string names_of(const std::set<CLI::Option*>& options) {
  return comma_list(options, [](const CLI::Option* option) { return option->get_name(); });
}

bool takes_many(const CLI::Option& option) {
  return option.get_expected_max() >= CLI::detail::expected_max_vector_size;
}

std::string usage_of(const CLI::Option& option) {
  if (option.get_name(true) == kSumoOptions) return "[-- SUMO OPTIONS]";
  std::string text = value_name(option);
  if (option.nonpositional()) text = option.get_name() + " " + text;
  if (takes_many(option)) text += " ...";
  return option.get_required() ? text : "[" + text + "]";
}

}  // namespace

std::string value_name(const CLI::Option& option) {
  if (option.nonpositional()) {
    const std::string type = option.get_type_name();
    return type.substr(0, type.find(kCheckMark));
  }
  std::string name = option.get_name();
  std::ranges::transform(name, name.begin(), [](unsigned char letter) {
    return letter == '_' ? ' ' : static_cast<char>(std::toupper(letter));
  });
  return name;
}

std::string element_name(const CLI::Option& option) {
  return option.nonpositional() ? "option " + option.get_name() : value_name(option);
}

OptionText text_of(const CLI::Option& option) {
  OptionText text;
  for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  if (option.get_items_expected_max() > 0) text.value = value_name(option);
  if (takes_many(option)) text.value += " ...";
  text.meaning = option.get_description();
  const std::string allowed = allowed_values(option);
  if (!allowed.empty()) text.meaning += fmt::format(" ({})", allowed);
  if (option.get_required() && option.nonpositional()) text.meaning += " (required)";
  if (!option.get_needs().empty()) {
    text.meaning += fmt::format(" (with {})", names_of(option.get_needs()));
  }
  if (!option.get_excludes().empty()) {
    text.meaning += fmt::format(" (not with {})", names_of(option.get_excludes()));
  }
  if (!option.get_default_str().empty()) {
    text.meaning += fmt::format(" [default: {}]", option.get_default_str());
  }
  return text;
}

std::string command_name(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return (parent ? command_name(*parent) + " " : "") + command.get_name();
}

std::string synopsis(const CLI::App& command) {
  std::string text = command_name(command), last;
  for (const CLI::Option* option : shown_options(command)) {
    if (option->get_name(true) == kSumoOptions) {
      last = " " + usage_of(*option);
    } else if (option->get_positional() || option->get_required()) {
      text += " " + usage_of(*option);
    }
  }
  if (!shown_commands(command).empty()) text += " COMMAND";
  return text + " [OPTIONS]" + last;
}

std::vector<const CLI::App*> shown_commands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); });
}

std::vector<const CLI::Option*> shown_options(const CLI::App& command) {
  return command.get_options([](const CLI::Option* one) { return !one->get_group().empty(); });
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : shown_commands(app)) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : shown_options(command)) {
    for (const std::string& name : text_of(*option).names) names.push_back(name);
  }
  return names;
}

InputError unknown_command(const CLI::App& app, const std::string& word) {
  return {"is no command",
          {.element = command_name(app), .value = word, .allowed = comma_list(command_names(app))}};
}

const CLI::App& find_command(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* found = &app;
  for (const std::string& word : words) {
    const auto commands = shown_commands(*found);
    const auto named = std::ranges::find(commands, word, &CLI::App::get_name);
    if (named == commands.end()) throw unknown_command(*found, word);
    found = *named;
  }
  return *found;
}

}  // namespace pedzone
