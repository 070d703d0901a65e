// What shells need to complete command lines of pedzone, made of the commands themselves.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace pedzone {

/// A script for bash: commands, options, and values that are names; files else.
std::string bash_completion(CLI::App& app);
/// A function for zsh: the same, with what each means.
std::string zsh_completion(CLI::App& app);

}  // namespace pedzone
