// What an option's value may be, said once: for the check, the message, the help, the man page and
// completion.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

namespace pedzone {

/// Names of values, as the help shows them. Completion knows FOLDER.
inline constexpr const char* kFile = "FILE";
inline constexpr const char* kFolder = "FOLDER";
inline constexpr const char* kSeconds = "SECONDS";
inline constexpr const char* kMetres = "METRES";
inline constexpr const char* kNumber = "N";
inline constexpr const char* kNames = "NAME";
inline constexpr const char* kModelValue = "MODEL";
inline constexpr const char* kOption = "OPTION";  ///< of another program

inline constexpr double kLongestTime = 1e9;  ///< [s]

/// A number within a closed range.
CLI::Validator number_in(double least, double most);
CLI::Validator whole_number_in(std::int64_t least, std::int64_t most);
/// As SUMO takes it.
CLI::Validator a_seed();
/// One of the names.
CLI::Validator one_of(const std::vector<std::string>& names);
/// Anything; the names are told and completed. What else it may be is checked where it is used.
CLI::Validator any_beside(const std::vector<std::string>& names);
/// Names of walking models, for any_beside(): a plug-in's path is none.
std::vector<std::string> model_names();

/// The names of one_of() and any_beside() that an option may have; none for others.
std::vector<std::string> choices_of(CLI::Option& option);

}  // namespace pedzone
