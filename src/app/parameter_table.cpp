#include "app/parameter_table.hpp"

#include <fmt/format.h>

#include "world/parameters.hpp"

namespace pedzone {

std::string parameter_table() {
  std::string text =
      "| key | default | range | unit | meaning | source |\n"
      "| --- | --- | --- | --- | --- | --- |\n";
  for (const ParameterInfo& info : parameter_list()) {
    text += fmt::format("| `{}` | {} | {} to {} | {} | {} | {} |\n", info.key, info.value,
                        info.least, info.most, info.unit, info.meaning, info.source);
  }
  return text;
}

}  // namespace pedzone
