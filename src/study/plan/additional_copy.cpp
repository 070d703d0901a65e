#include "study/plan/additional_copy.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "core/xml.hpp"

namespace pedzone::study {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMovers[] = {"vehicle",    "trip",      "flow",         "person",
                                        "personFlow", "container", "containerFlow"};

// Where SUMO's additional files name others (sumo.dlr.de, "Additional files", "Output").
constexpr const char* kOutputs[] = {
    "inductionLoop/@file",    "e1Detector/@file", "instantInductionLoop/@file",
    "laneAreaDetector/@file", "e2Detector/@file", "entryExitDetector/@file",
    "e3Detector/@file",       "edgeData/@file",   "laneData/@file",
    "routeProbe/@file",       "vTypeProbe/@file", "calibrator/@output",
    "timedEvent/@dest"};
constexpr const char* kInputs[] = {"include/@href", "rerouter/@file", "variableSpeedSign/@file"};
constexpr std::string_view kNoFiles[] = {"", "NUL", "nul", "/dev/null", "stdout", "stderr", "-"};

bool among(std::string_view name, const auto& names) {
  return std::ranges::find(names, name) != std::end(names);
}

bool remove_movers(pugi::xml_node node) {
  bool removed = false;
  for (pugi::xml_node child = node.first_child(); child;) {
    const pugi::xml_node next = child.next_sibling();
    if (among(child.name(), kMovers)) {
      removed = node.remove_child(child);
    } else {
      removed |= remove_movers(child);
    }
    child = next;
  }
  return removed;
}

/// Calls `change` with each attribute that names a file.
template <typename Change>
void for_each_file(pugi::xml_node root, const auto& paths, const Change& change) {
  for (const char* path : paths) {
    for (const auto& found : root.select_nodes((".//" + std::string(path)).c_str())) {
      if (!among(found.attribute().value(), kNoFiles)) change(found.attribute());
    }
  }
}

bool redirect_outputs(pugi::xml_node root, const std::string& outputs) {
  bool redirected = false;
  for_each_file(root, kOutputs, [&](pugi::xml_attribute file) {
    file.set_value((outputs + fs::path(file.value()).filename().string()).c_str());
    redirected = true;
  });
  return redirected;
}

fs::path folder_of(const std::string& file) { return fs::absolute(file).parent_path(); }

}  // namespace

bool dissolve_groups(pugi::xml_node root) {
  const auto found = root.select_nodes(".//param[@key='pedzone.group']");
  for (const auto& node : found) node.parent().remove_child(node.node());
  return !found.empty();
}

std::optional<std::string> additional_copy(const std::string& file, const std::string& outputs,
                                           bool movers) {
  const XmlFile original(file);
  pugi::xml_document copy;
  pugi::xml_node root = copy.append_copy(original.root());
  bool changed = redirect_outputs(root, outputs);
  if (!movers) {
    changed |= remove_movers(root);
    changed |= dissolve_groups(root);
  }
  if (!changed) return std::nullopt;
  root.remove_attribute("xsi:noNamespaceSchemaLocation");
  for_each_file(root, kInputs, [&](pugi::xml_attribute name) {
    name.set_value((folder_of(file) / name.value()).c_str());
  });
  return xml_text(copy);
}

std::vector<std::string> files_named_in(const std::string& file) {
  std::vector<std::string> found, waiting{file};
  while (!waiting.empty()) {
    const std::string next = waiting.back();
    waiting.pop_back();
    const XmlFile xml(next);
    for_each_file(xml.root(), kInputs, [&](pugi::xml_attribute name) {
      const std::string named = (folder_of(next) / name.value()).lexically_normal().string();
      if (!fs::is_regular_file(named) || among(named, found)) return;
      found.push_back(named);
      waiting.push_back(named);
    });
  }
  return found;
}

}  // namespace pedzone::study
