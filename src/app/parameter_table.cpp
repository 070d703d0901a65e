#include "app/parameter_table.hpp"

#include <fmt/format.h>

#include "world/parameters.hpp"
#include "zone/panel.hpp"

namespace pedzone {
namespace {

std::string zone_parameters() {
  std::string text =
      "| key | default | range | unit | meaning | source |\n"
      "| --- | --- | --- | --- | --- | --- |\n";
  for (const ParameterInfo& info : parameter_list()) {
    text += fmt::format("| `{}` | {} | {} to {} | {} | {} | {} |\n", info.key, info.value,
                        info.least, info.most, info.unit, info.meaning, info.source);
  }
  return text;
}

std::string panel_attributes() {
  std::string text =
      "| attribute | what is allowed | default | meaning |\n"
      "| --- | --- | --- | --- |\n";
  for (const PanelField& field : panel_fields()) {
    text += fmt::format("| `{}` | {} | {} | {} |\n", field.attribute, field.value, field.otherwise,
                        field.meaning);
  }
  return text;
}

}  // namespace

std::string parameter_tables() {
  return "Parameters of a zone:\n\n" + zone_parameters() + "\nAttributes of `<pedestrians>`:\n\n" +
         panel_attributes();
}

}  // namespace pedzone
