#include "study/run/versions.hpp"

#include <filesystem>

#include "study/plan/sumo_answer.hpp"
#include "study/run/file_sums.hpp"

namespace pedzone::study {

std::map<std::string, std::string> program_versions(const std::string& version,
                                                    const std::string& pedzone) {
  const std::string sumo = sumo_answer({"--version"});
  return {{"pedzone", version},
          {"sumo", sumo.substr(0, sumo.find('\n'))},
          {"build", sha256_of_file(pedzone)}};
}

std::optional<VersionChange> version_change(const std::map<std::string, std::string>& then,
                                            const std::map<std::string, std::string>& now) {
  for (const auto& [program, version] : now) {
    const auto found = then.find(program);
    if (found != then.end() && found->second == version) continue;
    return VersionChange{program, found == then.end() ? "unknown" : found->second, version};
  }
  return std::nullopt;
}

std::string this_program() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

}  // namespace pedzone::study
