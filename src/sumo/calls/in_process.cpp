#include <libsumo/libsumo.h>

#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "sumo/calls/both.hpp"
#include "sumo/files/sumo_home.hpp"
#include "sumo/files/sumo_messages.hpp"

namespace pedzone {
namespace {

constexpr std::string_view kError = "Error: ";  // so SUMO begins its messages
constexpr std::string_view kBadOptions = "Could not parse commandline options";
constexpr std::string_view kBadNumber = "Invalid Number Format";  // of an option's value

}  // namespace

std::unique_ptr<Session> start_in_process(const std::string& config,
                                          const std::vector<std::string>& words) {
  find_sumo_data();
  std::vector<std::string> command{"sumo", "-c", config};
  command.insert(command.end(), words.begin(), words.end());
  std::ostream before(std::cerr.rdbuf());
  std::string errors;             // and all that follows: an error can take several lines
  std::vector<std::string> held;  // the same, as SUMO says it: it may start all the same
  const StreamLines lines(std::cerr, [&](const std::string& line) {
    if (errors.empty() && !line.starts_with(kError)) {
      before << line << std::endl;
    } else {
      held.push_back(line);
      errors += "\n" + (line.starts_with(kError) ? line.substr(kError.size()) : line);
    }
  });
  try {
    libsumo::Simulation::start(command);
  } catch (const std::exception& error) {
    const std::string_view what = error.what();
    if (what.starts_with(kBadOptions)) {
      throw InputError("SUMO does not understand its options:" + errors, {});
    }
    if (what.starts_with(kBadNumber)) {
      throw InputError("SUMO does not understand its options: " + std::string(what), {});
    }
    throw SumoError("SUMO failed to start " + config + ": " + error.what() + errors);
  } catch (...) {
    throw SumoError("SUMO failed to start " + config + errors);
  }
  for (const std::string& line : held) before << line << std::endl;
  return in_process::session_calls();
}

}  // namespace pedzone
