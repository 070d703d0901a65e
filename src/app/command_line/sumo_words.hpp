// What stands after `--` on the command line: options for SUMO.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/guarded.hpp"
#include "core/error.hpp"

namespace pedzone {

/// Lets the command take options for SUMO.
void add_sumo_words(CLI::App& command, std::vector<std::string>& words);

/// Throws InputError for a word before `--` that no option takes, and for an option of the command
/// that SUMO does not have.
void require_sumo_words(const CLI::App& command, const std::vector<std::string>& words);

/// Whether the command takes options for SUMO, and this is one; false where no `sumo` can tell.
bool is_sumo_option(const CLI::App& command, const std::string& option);
InputError sumo_option_before_dashes(const CLI::App& command, const std::string& option);

/// Makes the command what `call` does, once what goes to SUMO is found to be SUMO's. Both outlive
/// the parsing of the command line.
template <class Options>
void set_callback(CLI::App& command, const std::shared_ptr<Options>& options,
                  int (*call)(const Options&), int& code) {
  command.callback([&command, options, call, &code] {
    code = guarded([&] { require_sumo_words(command, options->sumo_options); });
    if (code == 0) code = call(*options);
  });
}

}  // namespace pedzone
