#include "study/run/versions.hpp"

#include <filesystem>

#include "study/plan/sumo_answer.hpp"
#include "study/run/file_sums.hpp"

namespace pedzone {

std::map<std::string, std::string> program_versions(const std::string& version,
                                                    const std::string& pedzone) {
  const std::string sumo = sumo_answer({"--version"});
  return {{"pedzone", version},
          {"sumo", sumo.substr(0, sumo.find('\n'))},
          {"build", sha256_of_file(pedzone)}};
}

std::string this_program() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

}  // namespace pedzone
