// start_in_process() of the program: that of the library, see entry.hpp.
#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>

#include "app/sumo_library/entry.hpp"
#include "core/error.hpp"
#include "study/run/versions.hpp"

namespace pedzone {
namespace {

/// Lies beside the program, wherever both were installed to.
std::string library_file() {
  const std::filesystem::path program = study::this_program();
  return (program.parent_path() / PEDZONE_SUMO_LIBRARY).lexically_normal().string();
}

StartInProcess* load() {
  const std::string file = library_file();
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const entry = library == nullptr ? nullptr : dlsym(library, kStartInProcess);
  if (entry == nullptr) {
    throw SumoError(fmt::format(
        "SUMO cannot be started: {}. pedzone is installed together with this library, and that "
        "needs SUMO's (Debian: package sumo)",
        dlerror()));
  }
  return *static_cast<StartInProcess* const*>(entry);
}

}  // namespace

std::unique_ptr<Session> start_in_process(const std::string& config,
                                          const std::vector<std::string>& words) {
  static StartInProcess* const start = load();
  return start(config, words);
}

}  // namespace pedzone
