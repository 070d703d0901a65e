// What there is to say of commands and options, once: help, man page, completion and messages are
// made of it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace pedzone {

/// The group of commands that print what pedzone knows, and do no work.
inline constexpr const char* kLookUpGroup = "To look up";
/// The argument that takes what stands after `--`.
inline constexpr const char* kSumoOptions = "sumo_options";

struct OptionText {
  std::vector<std::string> names;  ///< "-h", "--help"; an argument, known by its place, has none
  std::string value;               ///< "FILE"; of a flag empty
  std::string meaning;             ///< what is allowed and the default included
};
OptionText text_of(const CLI::Option& option);

/// "FILE" of an option, "SCENARIO" of an argument.
std::string value_name(const CLI::Option& option);
/// "option --out", "SCENARIO": as messages name it.
std::string element_name(const CLI::Option& option);
/// "pedzone study run".
std::string command_name(const CLI::App& command);
/// "pedzone study run STUDY --out FOLDER [OPTIONS]".
std::string synopsis(const CLI::App& command);
/// Those that help shows.
std::vector<const CLI::App*> shown_commands(const CLI::App& app);
std::vector<const CLI::Option*> shown_options(const CLI::App& command);
/// Their names.
std::vector<std::string> command_names(const CLI::App& app);
std::vector<std::string> option_names(const CLI::App& command);

/// The error for a word where a command of `app` is expected.
InputError unknown_command(const CLI::App& app, const std::string& word);
/// The command that words such as {"study", "run"} name. Throws unknown_command().
const CLI::App& find_command(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace pedzone
