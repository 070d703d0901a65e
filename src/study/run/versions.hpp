// Which programs made results.
#pragma once

#include <map>
#include <optional>
#include <string>

namespace pedzone::study {

/// By name: pedzone, sumo; build (SHA-256 of the program `pedzone` itself: between two versions, it
/// tells one day's from the next). Results of different ones are not mixed.
/// `pedzone`: absolute path of the program. Throws as sumo_answer().
std::map<std::string, std::string> program_versions(const std::string& version,
                                                    const std::string& pedzone);

struct VersionChange {
  std::string program, then, now;  ///< then: "unknown" where it is not said
};

/// The first of the programs that is another now; nothing where all are the same.
std::optional<VersionChange> version_change(const std::map<std::string, std::string>& then,
                                            const std::map<std::string, std::string>& now);

/// Absolute path of the program that runs.
std::string this_program();

}  // namespace pedzone::study
