#include "app/panel_options.hpp"

namespace pedzone {

void add_panel_options(CLI::App& command, PanelOptions& options) {
  for (const PanelField& field : panel_fields()) {
    const std::string name =
        "--pedestrians" + (field.option.empty() ? "" : "-" + std::string(field.option));
    const std::string attribute(field.attribute);
    command
        .add_option_function<std::string>(
            name,
            [&options, attribute](const std::string& value) {
              options.text.values.emplace_back(attribute, value);
            },
            std::string(field.meaning))
        ->type_name("VALUE")
        ->check(CLI::Validator(std::string(field.value)))  // told; checked as in a zone file
        ->default_str(std::string(field.otherwise))
        ->group("People to be made (as <pedestrians> in a zone file)");
  }
}

ZoneFile read_zone_file(const std::string& path, const PanelOptions& options) {
  ZoneFile file;
  if (!path.empty()) file = read_zone_file(path);
  if (!options.text.values.empty()) {
    add_panel(file.panels, read_panel(options.text, file.profiles, file.paths, file.panels.size()));
  }
  return file;
}

}  // namespace pedzone
