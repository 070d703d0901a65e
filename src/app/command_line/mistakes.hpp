// What is wrong with a command line, in the form of all errors of the input.
#pragma once

#include <CLI/CLI.hpp>

#include "core/error.hpp"

namespace pedzone {

/// The command that was chosen, as far as the words were understood.
const CLI::App& chosen_command(const CLI::App& app);

/// The error for what CLI11 refused.
InputError mistake(const CLI::App& app, const CLI::ParseError& error);

/// From now on a value is not the name of another option, and a flag has none. To be called when
/// all options of the command are there.
void refuse_odd_values(CLI::App& command);

}  // namespace pedzone
