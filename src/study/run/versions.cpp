#include "study/run/versions.hpp"

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "core/error.hpp"
#include "study/run/file_sums.hpp"

namespace pedzone {
namespace {

/// First line of what `sumo --version` prints; empty where it cannot be started.
std::string sumo_version() {
  struct Close {
    void operator()(std::FILE* pipe) const { pclose(pipe); }
  };
  const std::unique_ptr<std::FILE, Close> pipe(popen("sumo --version 2>/dev/null", "r"));
  std::string text;
  std::array<char, 4096> block{};
  while (pipe) {
    const std::size_t size = std::fread(block.data(), 1, block.size(), pipe.get());
    if (size == 0) break;
    text.append(block.data(), size);
  }
  return text.substr(0, text.find('\n'));
}

}  // namespace

std::map<std::string, std::string> program_versions(const std::string& version,
                                                    const std::string& pedzone) {
  const std::string sumo = sumo_version();
  if (sumo.empty()) {
    throw InputError("cannot be started",
                     {.element = "SUMO", .value = "sumo", .allowed = "a program on the PATH"});
  }
  return {{"pedzone", version}, {"sumo", sumo}, {"build", sha256_of_file(pedzone)}};
}

std::string this_program() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

}  // namespace pedzone
