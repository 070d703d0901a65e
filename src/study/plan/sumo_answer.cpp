#include "study/plan/sumo_answer.hpp"

#include <fmt/format.h>

#include "core/command_output.hpp"
#include "core/error.hpp"

namespace pedzone::study {

std::string sumo_answer(const std::vector<std::string>& arguments) {
  std::vector<std::string> command{"sumo"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  std::optional<CommandOutput> said = command_output(command);
  if (!said) {
    throw InputError("is not installed",
                     {.element = "SUMO", .value = "sumo", .allowed = "a program on the PATH"});
  }
  if (said->code != 0) {
    throw SumoError(fmt::format("sumo {} ended with exit code {} {}", arguments.front(), said->code,
                                said->error));
  }
  return std::move(said->out);
}

}  // namespace pedzone::study
