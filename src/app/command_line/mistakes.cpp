#include "app/command_line/mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/command_line/option_text.hpp"
#include "app/command_line/sumo_words.hpp"
#include "app/command_line/values.hpp"
#include "core/nearest_word.hpp"

namespace pedzone {
namespace {

/// `element`: empty where CLI11 puts it in front.
InputError without_value(const CLI::Option& option, const std::string& element) {
  return {"has no value", {.element = element, .allowed = value_name(option)}};
}

InputError unknown_option(const CLI::App& command, const std::string& word) {
  const std::string option = word.substr(0, word.find('='));
  if (is_sumo_option(command, option)) return sumo_option_before_dashes(command, option);
  std::vector<std::string> names = option_names(command);
  std::erase_if(names, [](const std::string& name) { return !name.starts_with("--"); });
  std::string allowed = fmt::format("those of `{} --help`", command_name(command));
  if (!shown_commands(command).empty()) allowed += "; options of a command go after its name";
  return {"is no option",
          {.element = command_name(command),
           .value = option,
           .allowed = allowed + did_you_mean(option, names)}};
}

/// A word that nothing expects.
InputError unexpected_word(const CLI::App& command, const std::string& word) {
  if (word.starts_with("-")) return unknown_option(command, word);
  if (!shown_commands(command).empty()) return unknown_command(command, word);
  return {"is one word too many",
          {.element = command_name(command), .value = word, .allowed = synopsis(command)}};
}

/// The number of values was wrong.
InputError wrong_count(const CLI::Option& option) {
  const auto given = static_cast<int>(option.count());
  if (option.get_items_expected_max() == 0) {
    return {"takes no value",
            {.element = element_name(option), .allowed = option.get_name() + " alone"}};
  }
  if (given == 0) return without_value(option, element_name(option));
  const int wanted = option.get_items_expected_min();
  if (wanted > 1) {
    return {fmt::format("has {} values", given),
            {.element = element_name(option),
             .allowed = fmt::format("{}: {}", wanted, value_name(option))}};
  }
  return {fmt::format("is given {} times", given),
          {.element = element_name(option), .allowed = "once"}};
}

/// The option that CLI11's message begins or ends with; null where it is about something else.
const CLI::Option* option_named(const CLI::App& command, std::string word) {
  if (word.ends_with(':')) word.pop_back();
  for (const char* dashes : {"", "--"}) {
    if (const CLI::Option* found = command.get_option_no_throw(dashes + word)) return found;
  }
  return nullptr;
}

InputError mistake_of(const CLI::Option& option, const CLI::ParseError& error) {
  const std::string text = error.what(), element = element_name(option);
  const std::string last = text.substr(text.rfind(' ') + 1);
  switch (static_cast<CLI::ExitCodes>(error.get_exit_code())) {
    case CLI::ExitCodes::RequiredError:
      return {"is missing", {.element = element, .allowed = option.get_description()}};
    case CLI::ExitCodes::RequiresError:
      return {"is given without " + last, {.element = element, .allowed = "both of them, or none"}};
    case CLI::ExitCodes::ExcludesError:
      return {"is given beside " + last, {.element = element, .allowed = "one of them"}};
    case CLI::ExitCodes::ArgumentMismatch:
      return wrong_count(option);
    case CLI::ExitCodes::ValidationError:  // the checks of values.hpp say it all
      return {text.substr(text.find(' ') + 1), {.element = element}};
    default:
      return {text, {.element = element}};
  }
}

/// The command that was given words which it does not expect; null: there is none. After a word too
/// many before `--`, CLI11 leaves what stands after `--` to the command above: the innermost knows.
const CLI::App* command_with_extras(const CLI::App& app) {
  const CLI::App* puzzled = nullptr;
  for (const CLI::App* command = &app;; command = command->get_subcommands().front()) {
    if (!command->remaining().empty()) puzzled = command;
    if (command->get_subcommands().empty()) return puzzled;
  }
}

/// Throws InputError where the word too many was taken for one that SUMO is given.
void refuse_word_before_dashes(const CLI::App& command) {
  const CLI::Option* words = command.get_option_no_throw(kSumoOptions);
  if (words != nullptr) require_sumo_words(command, words->results());
}

}  // namespace

const CLI::App& chosen_command(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  return *command;
}

InputError mistake(const CLI::App& app, const CLI::ParseError& error) {
  // What is missing may be so because of a word that was not understood; a value that is odd is
  // odd.
  const bool odd = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ValidationError);
  const CLI::App* puzzled = odd ? nullptr : command_with_extras(app);
  const CLI::App& command = chosen_command(app);
  if (puzzled != nullptr) {
    if (puzzled != &command) refuse_word_before_dashes(command);
    return unexpected_word(*puzzled, puzzled->remaining().front());
  }
  const std::string text = error.what();
  const CLI::Option* option = option_named(command, text.substr(0, text.find(' ')));
  if (option != nullptr) return mistake_of(*option, error);
  return {text, {.element = command_name(command)}};
}

void refuse_odd_values(CLI::App& command) {
  for (CLI::Option* option : command.get_options()) {
    if (!option->nonpositional() || value_name(*option) == kOption) continue;
    if (option->get_items_expected_max() == 0) {
      option->disable_flag_override();
      continue;
    }
    option->transform(CLI::Validator(
        [option](const std::string& value) -> std::string {
          return value.starts_with("--") ? without_value(*option, "").what() : "";
        },
        ""));
  }
}

}  // namespace pedzone
