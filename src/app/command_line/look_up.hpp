// Commands that print what pedzone knows: tables, help, the man page, completion for shells.
#pragma once

#include <CLI/CLI.hpp>

namespace pedzone {

void add_parameters(CLI::App& app, int& code);
void add_profiles(CLI::App& app, int& code);
void add_help(CLI::App& app, int& code);
void add_completion(CLI::App& app, int& code);
void add_man(CLI::App& app, int& code);

}  // namespace pedzone
